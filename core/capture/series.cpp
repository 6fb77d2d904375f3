#include "capture/series.h"

#include <algorithm>
#include <cmath>

#include "base/message.h"
#include "base/parallel.h"
#include "files/files.h"

namespace ostraka::capture {
namespace {

// Two looks at a plate that stands still differ by 0.01 degrees and less.
constexpr double kSameAngle_deg = 0.3;

}  // namespace

Message shotWords(int stop, int camera) {
  return message("Camera %1, position %2", batch::cameraLetter(camera), stop + 1);
}

Message listed(const ShotCheck& check) {
  Message all;
  for (const Message& sentence : check.sentences())
    all = all.empty() ? sentence : Message("%1; %2", {all, sentence});
  return all;
}

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

Result<SideSummary> Series::run() {
  if (Result<void> r = prepare(); !r) return r.error();
  const double started_s = devices_.clock->now_s();
  Result<void> result;
  while (result && (!tasks_.empty() || !shots_.empty())) {
    if (stop_.stop_requested()) {
      result = Error::cancelled();
    } else if (tasks_.empty()) {
      result = keepAndCheck();
      if (result) result = takeVerdicts();
    } else {
      const Task task = tasks_.front();
      tasks_.pop_front();
      result = shootStop(task);
    }
    progress_.report(kept(), static_cast<std::int64_t>(options_.stops) *
                                 static_cast<std::int64_t>(devices_.cameras.size()));
  }
  if (!result && !shots_.empty() && keepAndCheck()) (void)takeVerdicts();  // what was delivered
  const double overhead_s = devices_.clock->now_s() - started_s - busy_s_;
  const Result<void> saved = store_->save();
  if (!result) return result.error();
  if (!saved) return saved.error();
  Result<SideSummary> done = summary();
  if (done) done->overhead_s = std::max(0.0, overhead_s);
  return done;
}

Result<void> Series::prepare() {
  if (Result<void> r = options_.check(); !r) return r;
  if (devices_.cameras.empty() || !devices_.turntable)
    return Error::missing(message("The rig has no camera or no turntable."));
  const int cameras = static_cast<int>(devices_.cameras.size());
  Result<BatchStore> store =
      BatchStore::open(options_.batch, options_.side, options_.stops, cameras, devices_.plate);
  if (!store) return store.error();
  store_ = std::move(*store);
  for (int c = 0; c < cameras; ++c)
    if (Result<void> r = sameCamera(c); !r) return r;
  watches_.resize(devices_.cameras.size());
  for (int c = 0; c < cameras; ++c)
    if (!byHand(c) && !devices_.cameras[static_cast<std::size_t>(c)]->fileIsOfItsTrigger())
      watches_[static_cast<std::size_t>(c)].trust = Trust::Doubted;
  for (const ManifestEntry& entry : store_->manifest().entries)
    devices_.delivered.insert(entry.sha256);
  for (const ShotName& again : options_.retake) {
    if (again.stop < 0 || again.stop >= options_.stops || again.camera < 0 ||
        again.camera >= cameras)
      return Error::unusable(message(
          "There is no shot %1 to retake: this side has positions 1 to %2 and cameras A to %3.",
          std::to_string(again.stop + 1) + batch::cameraLetter(again.camera), options_.stops,
          batch::cameraLetter(cameras - 1)));
  }
  if (Result<void> r = store_->setAside(options_.retake, "retake requested"); !r) return r;
  for (int s = 0; s < options_.stops; ++s) {
    Task task{s, {}};
    for (int c = 0; c < cameras; ++c)
      if (store_->manifest().find(options_.side, s, c) == nullptr) task.cameras.push_back(c);
    if (!task.cameras.empty()) tasks_.push_back(task);
  }
  if (Result<void> r = readReferences(); !r) return r;
  if (tasks_.empty()) return {};
  for (int c = 0; c < cameras; ++c)
    if (Result<void> r = setAsRigSays(c); !r) return r;
  if (devices_.side_placed) devices_.side_placed(options_.side);
  return findPosition();
}

// Front and back of a batch by the same cameras, or the calibration holds for one side only. A
// folder or a video device is known by its path, which may change.
Result<void> Series::sameCamera(int camera) const {
  const devices::CameraId id = devices_.cameras[static_cast<std::size_t>(camera)]->id();
  if (id.driver == "folder" || id.driver == "uvc" || id.serial.empty()) return {};
  for (const ManifestEntry& entry : store_->manifest().entries)
    if (entry.used && entry.camera == camera && !entry.camera_serial.empty() &&
        entry.camera_serial != id.serial)
      return Error::unusable(message("Camera %1 of this batch was %2, but the connected one is %3; "
                                     "continue with the original cameras or choose another folder.",
                                     batch::cameraLetter(camera), entry.camera_serial, id.serial),
                             options_.batch.string());
  return {};
}

// After a break: what the kept photographs show, and those that nobody looked at yet.
Result<void> Series::readReferences() {
  parallelFor(watches_.size(), 0, [&](std::size_t c) {
    CameraReference& reference = watches_[c].reference;
    for (int s = 0; s < options_.stops && !reference.inspection; ++s) {
      const ManifestEntry* entry =
          std::as_const(*store_).manifest().find(options_.side, s, static_cast<int>(c));
      if (entry == nullptr || !entry->checked) continue;
      const Result<std::string> bytes = readFile(store_->fileOf(*entry));
      if (!bytes) continue;
      if (const auto inspection = inspectPlate(*bytes, devices_.plate, kSequenceInspection))
        learn(reference, *inspection, angleOf(s));
    }
  });
  for (const ManifestEntry& entry : store_->manifest().entries)
    if (entry.used && entry.side == options_.side && !entry.checked)
      shots_.push_back({.stop = entry.stop, .camera = entry.camera, .epoch = -1});
  return {};
}

Result<void> Series::findPosition() {
  devices::Turntable& table = *devices_.turntable;
  if (table.position_deg()) return {};
  const Result<void> homed = table.home(stop_);
  if (homed) return {};
  if (homed.error().code != ErrorCode::Missing) return homed;
  // No switch. Photographs of this side tell where the plate stands; without any, a person must.
  const bool seen = std::ranges::any_of(
      watches_, [](const Watch& watch) { return watch.reference.inspection.has_value(); });
  if (!seen)
    return Error::notEnough(
        message(
            "The turntable's position is unknown: turn its zero mark to the front and set zero."),
        table.name());
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
  for (std::vector<int> unsure = doubted(task); true; unsure = doubted(task)) {
    if (!unsure.empty())
      if (Result<void> r = takeProofs(unsure, task); !r) return r;
    if (Result<void> r = turnTo(task, 0); !r) return r;
    const std::size_t waiting = tasks_.size();
    if (Result<void> r = takeVerdicts(); !r) return r;
    if (tasks_.size() > waiting) {  // back to a bad shot at once, and then here again
      tasks_.insert(tasks_.begin() + static_cast<std::ptrdiff_t>(tasks_.size() - waiting), task);
      return {};
    }
    if (doubted(task).empty()) return shootCameras(task);
  }
}

Result<void> Series::turnTo(const Task& task, double beyond_deg) {
  tell({.kind = CaptureEventKind::Turning, .stop = task.stop});
  Result<void> turned = turnOnce(task, beyond_deg, task.cameras);
  for (int again = 1; !turned && again <= options_.tries_per_device; ++again) {
    if (turned.error().code != ErrorCode::Missing && turned.error().code != ErrorCode::NotEnough)
      return turned;
    if (Result<void> r = recoverTable(turned.error()); !r) return r;
    turned = turnOnce(task, beyond_deg, {});
  }
  return turned;
}

// While the table turns, the last stop's photographs are put on disk and looked at, and the cameras
// are emptied.
Result<void> Series::turnOnce(const Task& task, double beyond_deg, std::span<const int> to_empty) {
  const double target = targetOf(task.stop) + beyond_deg;
  Result<void> turned, checked;
  const std::size_t jobs = 2 + to_empty.size();
  parallelFor(jobs, static_cast<int>(jobs), [&](std::size_t i) {
    if (i == 0) {
      const double from_s = devices_.clock->now_s();
      turned = devices_.turntable->moveTo(target, stop_);
      if (turned) {
        tell({.kind = CaptureEventKind::Settling, .stop = task.stop});
        if (!devices_.clock->sleep(devices_.settle_s, stop_)) turned = Error::cancelled();
      }
      busy_s_ += devices_.clock->now_s() - from_s;
    } else if (i == 1) {
      checked = keepAndCheck();
    } else {
      emptyCamera(to_empty[i - 2]);
    }
  });
  return checked ? turned : checked;
}

Result<void> Series::recoverTable(const Error& trouble) {
  tell({.kind = CaptureEventKind::Trouble, .trouble = trouble.sentence()});
  progress_.note(NoteLevel::Warning, about("capture", trouble.sentence()));
  if (trouble.code == ErrorCode::Missing)
    if (Result<void> r = devices_.turntable->reopen(stop_); !r)
      return r.error().code == ErrorCode::Missing ? Result<void>() : r;  // tried again by the turn
  return findPosition();
}

Result<void> Series::takeVerdicts() {
  const std::vector<Shot> shots = std::move(shots_);
  shots_.clear();
  if (shots.empty()) return {};
  std::map<int, std::vector<int>> again;
  for (const Shot& shot : shots) {
    ManifestEntry* entry = store_->manifest().find(options_.side, shot.stop, shot.camera);
    entry->checked = true;
    entry->angle_seen_deg = shot.check.angle_seen_deg;
    entry->sharpness = shot.check.sharpness;
    entry->markers_seen = shot.check.markers_seen;
    entry->sherds = shot.check.sherds;
    entry->cut_off = shot.check.has(ShotProblem::CutOff);
    entry->problems.clear();
    for (const Message& problem : shot.check.sentences())
      entry->problems.push_back(problem.english());
    if (!shot.refused) continue;
    if (Result<void> r = refuse(shot); !r) return r;
    again[shot.stop].push_back(shot.camera);
  }
  if (Result<void> r = correctZero(shots); !r) return r;
  for (const auto& [stop_number, cameras] : again) tasks_.push_front({stop_number, cameras});
  for (const Shot& shot : shots)
    if (!again.contains(shot.stop) && shot.camera == shots.back().camera)
      tell({.kind = CaptureEventKind::StopDone, .stop = shot.stop});
  return {};
}

Result<void> Series::refuse(const Shot& shot) {
  const Message why = listed(shot.check);
  if (Result<void> r = store_->setAside({{shot.stop, shot.camera}}, why.english()); !r) return r;
  progress_.note(NoteLevel::Info,
                 Message("capture: %1 is retaken: %2", {shotWords(shot.stop, shot.camera), why}));
  if (tries_[{shot.stop, shot.camera}] < options_.tries_per_shot) return {};
  return Error::failed(message("Camera %1, position %2 failed %3 times: %4.",
                               batch::cameraLetter(shot.camera), shot.stop + 1,
                               options_.tries_per_shot, why));
}

// When all cameras see the plate turned by the same angle too far, it is the table that is wrong;
// once might be one old photograph each, twice is the table.
Result<void> Series::correctZero(const std::vector<Shot>& shots) {
  std::vector<double> off;
  bool all = true;
  for (const Shot& shot : shots) {
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
  progress_.note(NoteLevel::Warning,
                 message("The turntable's own count was %1 degrees off; it was corrected from the "
                         "plate's markers.",
                         decimal(off[0], 1)));
  return {};
}

Result<SideSummary> Series::summary() {
  SideSummary done;
  done.kept = kept();
  std::vector<std::vector<SidePhotograph>> files(devices_.cameras.size());
  for (int s = 0; s < options_.stops; ++s)
    for (std::size_t c = 0; c < files.size(); ++c) {
      const ManifestEntry* entry =
          std::as_const(*store_).manifest().find(options_.side, s, static_cast<int>(c));
      if (entry == nullptr) continue;
      const auto inspection = inspections_.find({s, static_cast<int>(c)});
      files[c].push_back({store_->fileOf(*entry),
                          inspection == inspections_.end() ? nullptr : inspection->second});
      if (!entry->problems.empty()) done.flagged.push_back({s, static_cast<int>(c)});
      done.cut_off = done.cut_off || entry->cut_off;
    }
  done.check = checkSide(files, devices_.plate, {}, stop_);
  if (stop_.stop_requested()) return Error::cancelled();
  return done;
}

}  // namespace ostraka::capture
