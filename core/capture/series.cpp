#include "capture/series.h"

#include <algorithm>
#include <cmath>

#include "base/files.h"
#include "base/parallel.h"

namespace ostraka::capture {
namespace {

// Two looks at a plate that stands still differ by 0.01 degrees and less.
constexpr double kSameAngle_deg = 0.3;

std::string stopName(int stop) {
  return "stop " + std::to_string(stop + 1);
}

std::string shotWords(int stop, int camera) {
  return "Camera " + placeName(camera) + ", " + stopName(stop);
}

std::string listed(const std::vector<ShotProblem>& problems) {
  std::string text;
  for (const ShotProblem p : problems) text += (text.empty() ? "" : "; ") + words(p);
  return text;
}

}  // namespace

void Series::tell(CaptureEvent event) {
  event.side = options_.side;
  const std::lock_guard lock(telling_);
  if (on_event_) on_event_(event);
}

int Series::kept() const {
  int count = 0;
  for (const ManifestEntry& e : store_->manifest().entries)
    count += e.used && e.side == options_.side;
  return count;
}

Error Series::withSafety(Error error) const {
  if (error.code == ErrorCode::Cancelled) return error;
  error.what += " The " + std::to_string(kept()) +
                " photographs of this side so far are safe; start again to go on.";
  return error;
}

Result<SideSummary> Series::run() {
  if (Result<void> r = prepare(); !r) return r.error();
  const double started_s = devices_.clock->now_s();
  Result<void> result;
  while (result && (!tasks_.empty() || !unchecked_.empty())) {
    if (stop_.stop_requested()) {
      result = Error::cancelled();
    } else if (tasks_.empty()) {
      parallelFor(unchecked_.size(), static_cast<int>(unchecked_.size()),
                  [&](std::size_t i) { lookAt(unchecked_[i]); });
      result = takeVerdicts();
    } else {
      const Task task = tasks_.front();
      tasks_.pop_front();
      result = shootStop(task);
    }
    progress_.report(kept(), static_cast<std::int64_t>(options_.stops) *
                                 static_cast<std::int64_t>(devices_.cameras.size()));
  }
  const double overhead_s = devices_.clock->now_s() - started_s - busy_s_;
  const Result<void> saved = store_->save();
  if (!result) return withSafety(result.error());
  if (!saved) return withSafety(saved.error());
  Result<SideSummary> done = summary();
  if (done) done->overhead_s = std::max(0.0, overhead_s);
  return done;
}

Result<void> Series::prepare() {
  if (Result<void> r = options_.check(); !r) return r;
  if (devices_.cameras.empty() || !devices_.turntable)
    return Error{ErrorCode::Missing, "The rig has no camera or no turntable.", {}};
  const int cameras = static_cast<int>(devices_.cameras.size());
  Result<BatchStore> store =
      BatchStore::open(options_.batch, options_.side, options_.stops, cameras, devices_.plate);
  if (!store) return store.error();
  store_ = std::move(*store);
  references_.resize(devices_.cameras.size());
  for (const ShotName& again : options_.retake) {
    if (again.stop < 0 || again.stop >= options_.stops || again.camera < 0 ||
        again.camera >= cameras)
      return Error{ErrorCode::UnusableInput, "A shot to be taken again does not exist.", {}};
    if (Result<void> r = store_->setAside(again.stop, again.camera, "asked for again"); !r)
      return r;
  }
  for (int s = 0; s < options_.stops; ++s) {
    Task task{s, {}};
    for (int c = 0; c < cameras; ++c)
      if (store_->manifest().find(options_.side, s, c) == nullptr) task.cameras.push_back(c);
    if (!task.cameras.empty()) tasks_.push_back(task);
  }
  if (Result<void> r = readReferences(); !r) return r;
  if (tasks_.empty()) return {};
  if (devices_.side_placed) devices_.side_placed(options_.side);
  return findPosition();
}

// After a break: what the kept photographs show, and those that nobody looked at yet.
Result<void> Series::readReferences() {
  parallelFor(references_.size(), 0, [&](std::size_t c) {
    for (int s = 0; s < options_.stops && !references_[c].look; ++s) {
      const ManifestEntry* entry =
          std::as_const(*store_).manifest().find(options_.side, s, static_cast<int>(c));
      if (entry == nullptr || !entry->checked) continue;
      const Result<std::string> bytes = readFile(store_->fileOf(*entry));
      if (!bytes) continue;
      if (const auto look = lookAtPlate(*bytes, devices_.plate, {}))
        learn(references_[c], *look, angleOf(s));
    }
  });
  for (const ManifestEntry& entry : store_->manifest().entries)
    if (entry.used && entry.side == options_.side && !entry.checked)
      unchecked_.push_back({.stop = entry.stop, .camera = entry.camera, .check = {}, .epoch = -1});
  return {};
}

Result<void> Series::findPosition() {
  Turntable& table = *devices_.turntable;
  if (table.position_deg()) return {};
  const Result<void> homed = table.home(stop_);
  if (homed) return {};
  if (homed.error().code != ErrorCode::Missing) return homed;
  // No switch. Photographs of this side tell where the plate stands; without any, a person must.
  const bool seen = std::any_of(references_.begin(), references_.end(),
                                [](const CameraReference& r) { return r.look.has_value(); });
  if (!seen)
    return Error{ErrorCode::NotEnough,
                 "The table's position is not known: turn its zero mark to the front and set zero.",
                 table.name()};
  if (Result<void> r = table.zeroHere(stop_); !r) return r;
  zero_unknown_ = true;
  ++epoch_;
  return {};
}

double Series::targetOf(int stop) const {
  const double there = angleOf(stop) + zero_deg_;
  const double now = devices_.turntable->position_deg().value_or(there);
  return there + 360 * std::round((now - there) / 360);
}

Result<void> Series::shootStop(const Task& task) {
  if (Result<void> r = turnTo(task); !r) return r;
  const bool looked_back = !unchecked_.empty();
  if (looked_back) {
    const std::size_t waiting = tasks_.size();
    if (Result<void> r = takeVerdicts(); !r) return r;
    if (tasks_.size() > waiting) {  // back to a bad shot at once, and then here again
      tasks_.insert(tasks_.begin() + static_cast<std::ptrdiff_t>(tasks_.size() - waiting), task);
      return {};
    }
  }
  return shootCameras(task.cameras, task.stop);
}

Result<void> Series::turnTo(const Task& task) {
  tell({.kind = CaptureEventKind::Turning, .stop = task.stop});
  Result<void> turned = turnOnce(task, true);
  for (int again = 1; !turned && again <= options_.tries_per_device; ++again) {
    if (turned.error().code != ErrorCode::Missing && turned.error().code != ErrorCode::NotEnough)
      return turned;
    if (Result<void> r = recoverTable(turned.error()); !r) return r;
    turned = turnOnce(task, false);
  }
  return turned;
}

// While the table turns, the cameras are emptied and the last stop's photographs are looked at.
Result<void> Series::turnOnce(const Task& task, bool with_checks) {
  const std::size_t cameras = with_checks ? task.cameras.size() : 0,
                    checks = with_checks ? unchecked_.size() : 0;
  const double target = targetOf(task.stop);
  Result<void> turned;
  parallelFor(1 + cameras + checks, static_cast<int>(1 + cameras + checks), [&](std::size_t i) {
    if (i == 0) {
      const double from_s = devices_.clock->now_s();
      turned = devices_.turntable->moveTo(target, stop_);
      if (turned) {
        tell({.kind = CaptureEventKind::Settling, .stop = task.stop});
        if (!devices_.clock->sleep(devices_.settle_s, stop_)) turned = Error::cancelled();
      }
      busy_s_ += devices_.clock->now_s() - from_s;
    } else if (i <= cameras) {
      // A camera that cannot be emptied fails again when it shoots, and is looked after there.
      (void)devices_.cameras[static_cast<std::size_t>(task.cameras[i - 1])]->getReady(stop_);
    } else {
      lookAt(unchecked_[i - 1 - cameras]);
    }
  });
  return turned;
}

Result<void> Series::recoverTable(const Error& trouble) {
  tell({.kind = CaptureEventKind::Trouble, .trouble = trouble.sentence()});
  progress_.note(NoteLevel::Warning, "capture: " + trouble.sentence());
  if (trouble.code == ErrorCode::Missing)
    if (Result<void> r = devices_.turntable->reopen(stop_); !r)
      return r.error().code == ErrorCode::Missing ? Result<void>() : r;  // tried again by the turn
  return findPosition();
}

void Series::lookAt(Unchecked& shot) {
  const auto c = static_cast<std::size_t>(shot.camera);
  const ManifestEntry* entry =
      std::as_const(*store_).manifest().find(options_.side, shot.stop, shot.camera);
  const Result<std::string> bytes = readFile(store_->fileOf(*entry));
  const Result<PlateLook> look =
      bytes ? lookAtPlate(*bytes, devices_.plate, {}) : Result<PlateLook>(bytes.error());
  const double angle = angleOf(shot.stop);
  if (look)
    shot.check = judge(*look, angle, references_[c], {});
  else
    shot.check.problems.push_back(ShotProblem::Unreadable);
  if (shot.repeated) shot.check.problems.push_back(ShotProblem::Repeated);
  const auto counted = tries_.find({shot.stop, shot.camera});
  const int tries = counted == tries_.end() ? 0 : counted->second;
  shot.refused = !shot.check.keepable() || (shot.check.again() && tries < options_.tries_per_shot);
  if (!shot.refused && look) learn(references_[c], *look, angle);
  CaptureEvent event{
      .kind = shot.refused ? CaptureEventKind::ShotRefused : CaptureEventKind::ShotKept,
      .stop = shot.stop,
      .camera = shot.camera,
      .file = store_->fileOf(*entry),
      .check = shot.check,
      .take = entry->take};
  if (shot.refused)
    event.trouble = shotWords(shot.stop, shot.camera) + ": " + listed(shot.check.problems) + ".";
  tell(event);
}

Result<void> Series::takeVerdicts() {
  const std::vector<Unchecked> shots = std::move(unchecked_);
  unchecked_.clear();
  std::map<int, std::vector<int>> again;
  for (const Unchecked& shot : shots) {
    ManifestEntry* entry = store_->manifest().find(options_.side, shot.stop, shot.camera);
    entry->checked = true;
    entry->angle_seen_deg = shot.check.angle_seen_deg;
    entry->sharpness = shot.check.sharpness;
    entry->markers_seen = shot.check.markers_seen;
    entry->sherds = shot.check.sherds;
    entry->problems.clear();
    for (const ShotProblem p : shot.check.problems) entry->problems.push_back(words(p));
    if (!shot.refused) continue;
    if (Result<void> r = refuse(shot); !r) return r;
    again[shot.stop].push_back(shot.camera);
  }
  if (Result<void> r = correctZero(shots); !r) return r;
  for (const auto& [stop_number, cameras] : again) tasks_.push_front({stop_number, cameras});
  for (const Unchecked& shot : shots)
    if (!again.contains(shot.stop) && shot.camera == shots.back().camera)
      tell({.kind = CaptureEventKind::StopDone, .stop = shot.stop});
  return {};
}

Result<void> Series::refuse(const Unchecked& shot) {
  const std::string why = listed(shot.check.problems);
  if (Result<void> r = store_->setAside(shot.stop, shot.camera, why); !r) return r;
  progress_.note(NoteLevel::Info,
                 "capture: " + shotWords(shot.stop, shot.camera) + " is taken again: " + why);
  if (tries_[{shot.stop, shot.camera}] < options_.tries_per_shot) return {};
  return Error{ErrorCode::Failed,
               shotWords(shot.stop, shot.camera) + " failed " +
                   std::to_string(options_.tries_per_shot) + " times: " + why + ".",
               {}};
}

// When all cameras see the plate turned by the same angle too far, it is the table that is wrong;
// once might be one old photograph each, twice is the table.
Result<void> Series::correctZero(const std::vector<Unchecked>& shots) {
  std::vector<double> off;
  bool all = true;
  for (const Unchecked& shot : shots) {
    if (shot.epoch != epoch_) continue;
    const auto& seen = shot.check.angle_seen_deg;
    all = all && shot.check.has(ShotProblem::WrongStop) && seen;
    if (seen) off.push_back(std::remainder(*seen - angleOf(shot.stop), 360));
  }
  if (off.empty() || !all) {
    doubted_zero_deg_.reset();
    if (!off.empty()) zero_unknown_ = false;
    return {};
  }
  for (const double other : off)
    if (std::abs(std::remainder(other - off[0], 360)) > kSameAngle_deg) return {};
  const bool seen_before = doubted_zero_deg_ && std::abs(std::remainder(*doubted_zero_deg_ - off[0],
                                                                        360)) <= kSameAngle_deg;
  if (!seen_before && !zero_unknown_) {
    doubted_zero_deg_ = off[0];
    return {};
  }
  zero_deg_ -= off[0];
  zero_unknown_ = false;
  doubted_zero_deg_.reset();
  progress_.note(NoteLevel::Warning, "capture: the markers show the table turned by " +
                                         std::to_string(off[0]) +
                                         " degrees against its own count; corrected");
  return {};
}

Result<void> Series::shootCameras(std::vector<int> cameras, int stop) {
  if (stop_.stop_requested()) return Error::cancelled();
  for (const int c : cameras) {
    ++tries_[{stop, c}];
    if (!devices_.cameras[static_cast<std::size_t>(c)]->triggersItself() &&
        !devices_.turntable->firesShutters())
      tell({.kind = CaptureEventKind::PressShutter, .stop = stop, .camera = c});
  }
  tell({.kind = CaptureEventKind::Shooting, .stop = stop});
  bool fired = false;
  for (int round = 0; !cameras.empty(); ++round) {
    const double from_s = devices_.clock->now_s();
    if (round == 0 && devices_.turntable->firesShutters()) {
      if (Result<void> r = devices_.turntable->fireShutters(stop_); !r) return r;
      fired = true;
    }
    std::vector<Delivery> deliveries(cameras.size());
    parallelFor(cameras.size(), static_cast<int>(cameras.size()),
                [&](std::size_t i) { deliveries[i] = shootOne(cameras[i], stop, fired); });
    fired = false;
    std::vector<Arriving> arriving;
    std::vector<int> failed;
    std::optional<Error> hopeless;
    double last_s = from_s;
    for (std::size_t i = 0; i < cameras.size(); ++i) {
      last_s = std::max(last_s, deliveries[i].fetched_s);
      if (deliveries[i].outcome) {
        unchecked_.push_back({.stop = stop, .camera = cameras[i], .check = {}, .epoch = epoch_});
        unchecked_.back().repeated = store_->holdsElsewhere(deliveries[i].arriving->entry);
        arriving.push_back(std::move(*deliveries[i].arriving));
      } else {
        const Error& error = deliveries[i].outcome.error();
        if (error.code != ErrorCode::Missing || round + 1 >= options_.tries_per_device)
          if (!hopeless || error.code == ErrorCode::Cancelled) hopeless = error;
        failed.push_back(cameras[i]);
      }
    }
    busy_s_ += last_s - from_s;
    if (Result<void> r = store_->commit(std::move(arriving)); !r) return r;
    if (hopeless) return *hopeless;
    for (std::size_t i = 0; i < cameras.size(); ++i)
      if (!deliveries[i].outcome)
        if (Result<void> r = recoverCamera(cameras[i], stop, deliveries[i].outcome.error()); !r)
          return r;
    cameras = std::move(failed);
  }
  return {};
}

Series::Delivery Series::shootOne(int camera, int stop, bool triggered) {
  Camera& device = *devices_.cameras[static_cast<std::size_t>(camera)];
  Delivery delivery;
  if (!triggered) delivery.outcome = device.trigger();
  Result<std::vector<CameraFile>> files = std::vector<CameraFile>{};
  if (delivery.outcome) {
    const bool by_hand = !device.triggersItself() && !devices_.turntable->firesShutters();
    files = device.fetch(by_hand ? options_.press_timeout_s : options_.fetch_timeout_s, stop_);
    if (!files) delivery.outcome = files.error();
  }
  delivery.fetched_s = devices_.clock->now_s();
  if (!delivery.outcome) return delivery;
  Result<Arriving> arriving = store_->stage(*files, camera, stop, angleOf(stop), device.id());
  if (arriving)
    delivery.arriving = std::move(*arriving);
  else
    delivery.outcome = arriving.error();
  return delivery;
}

Result<void> Series::recoverCamera(int camera, int stop, const Error& trouble) {
  tell({.kind = CaptureEventKind::Trouble,
        .stop = stop,
        .camera = camera,
        .trouble = trouble.sentence()});
  progress_.note(NoteLevel::Warning,
                 "capture: " + shotWords(stop, camera) + ": " + trouble.sentence());
  Camera& device = *devices_.cameras[static_cast<std::size_t>(camera)];
  Result<void> back = device.reopen(stop_);
  if (back) back = device.getReady(stop_);  // drops what the failed try may still deliver
  if (!back && back.error().code == ErrorCode::Missing) return {};  // tried again by the shot
  return back;
}

Result<SideSummary> Series::summary() {
  SideSummary done;
  done.kept = kept();
  std::vector<std::vector<std::filesystem::path>> files(devices_.cameras.size());
  for (int s = 0; s < options_.stops; ++s)
    for (std::size_t c = 0; c < files.size(); ++c) {
      const ManifestEntry* entry =
          std::as_const(*store_).manifest().find(options_.side, s, static_cast<int>(c));
      if (entry == nullptr) continue;
      files[c].push_back(store_->fileOf(*entry));
      if (!entry->problems.empty()) done.flagged.push_back({s, static_cast<int>(c)});
    }
  done.check = checkSide(files, devices_.plate, {}, stop_);
  if (stop_.stop_requested()) return Error::cancelled();
  if (!done.flagged.empty())
    done.check.sentences.push_back(std::to_string(done.flagged.size()) +
                                   " photographs are kept though something is wrong with them; "
                                   "look at them before you go on.");
  return done;
}

}  // namespace ostraka::capture
