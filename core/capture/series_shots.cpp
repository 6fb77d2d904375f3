// Photographs on their way from the cameras into the batch.
#include <algorithm>
#include <cmath>

#include "base/message.h"
#include "base/parallel.h"
#include "capture/series.h"
#include "files/files.h"
#include "images/image_header.h"

namespace ostraka::capture {
namespace {

constexpr double kMostTurnError_deg = 0.5;
constexpr double kSamePlace_mm = 1;  // of a sherd in two looks of one camera at a plate at rest

// Two photographs of one camera at one angle: do the sherds lie at the same places?
bool sameSherds(const PlateInspection& a, const PlateInspection& b) {
  std::size_t same = 0;
  for (const SeenSherd& s : a.sherds)
    same += std::any_of(b.sherds.begin(), b.sherds.end(), [&](const SeenSherd& other) {
      return (s.centre_mm - other.centre_mm).norm() < kSamePlace_mm;
    });
  return 5 * same >= 4 * std::max(a.sherds.size(), b.sherds.size());
}

const devices::CameraFile* photographIn(const std::vector<devices::CameraFile>& files) {
  for (const devices::CameraFile& file : files)
    if (images::imageSize(file.bytes, {})) return &file;
  return nullptr;
}

// nullptr: no whole picture.
std::shared_ptr<const MappedInspection> inspectBytes(const std::string& bytes,
                                                     const batch::Plate& plate) {
  Result<MappedInspection> inspection = inspectAndMap(bytes, plate, kSequenceInspection);
  return inspection ? std::make_shared<const MappedInspection>(std::move(*inspection)) : nullptr;
}

}  // namespace

bool Series::byHand(int camera) const {
  return !devices_.cameras[static_cast<std::size_t>(camera)]->triggersItself() &&
         !devices_.turntable->firesShutters();
}

// A camera that is gone is looked after when it shoots.
Result<void> Series::setAsRigSays(int camera) {
  const auto c = static_cast<std::size_t>(camera);
  if (c >= devices_.wanted_settings.size()) return {};
  for (const auto& [name, value] : devices_.wanted_settings[c])
    if (const auto set = devices_.cameras[c]->set(name, value);
        !set && set.error().code != ErrorCode::Missing)
      return set.error();
  return {};
}

// A camera that cannot be emptied fails again when it shoots, and is looked after there.
void Series::emptyCamera(int camera) {
  const auto c = static_cast<std::size_t>(camera);
  if (!devices_.cameras[c]->getReady(stop_)) return;
  const Result<std::vector<devices::CameraSetting>> settings = devices_.cameras[c]->settings();
  if (!settings) return;
  watches_[c].settings.clear();
  for (const devices::CameraSetting& s : *settings) watches_[c].settings[s.name] = s.value;
}

std::vector<int> Series::doubted(const Task& task) const {
  std::vector<int> cameras;
  for (const int c : task.cameras)
    if (watches_[static_cast<std::size_t>(c)].trust == Trust::Doubted) cameras.push_back(c);
  return cameras;
}

// All angles at which photographs are kept, of this side or another, are whole steps apart; this
// one is not. The table comes to it and goes on from it in its usual direction, so that play in its
// gears does not look like a wrong photograph.
Result<void> Series::takeProofs(std::vector<int> cameras, const Task& task) {
  const bool turns = devices_.turntable->turnsItself();
  const double before_deg = turns ? 360.0 / options_.stops / 3 : 0;
  const Task proof{task.stop, cameras};
  if (const auto now = devices_.turntable->position_deg();
      turns && now && *now > targetOf(task.stop) - before_deg + 0.01)
    if (Result<void> r = turnTo(proof, -1.5 * before_deg); !r) return r;
  if (Result<void> r = turnTo(proof, -before_deg); !r) return r;
  for (int round = 0; !cameras.empty(); ++round) {
    if (stop_.stop_requested()) return Error::cancelled();
    if (round == options_.tries_per_shot)
      return Error::failed(
          message("Camera %1 delivers only earlier or broken photographs; switch it off and on.",
                  batch::cameraLetter(cameras[0])),
          devices_.cameras[static_cast<std::size_t>(cameras[0])]->id().serial);
    if (round > 0)
      parallelFor(cameras.size(), static_cast<int>(cameras.size()),
                  [&](std::size_t i) { emptyCamera(cameras[i]); });
    std::vector<Shot> shots;
    if (Result<void> r = expose(cameras, task.stop, shots); !r) return r;
    cameras.clear();
    for (Shot& shot : shots) {
      const devices::CameraFile* photograph = photographIn(shot.files);
      const bool fresh =
          photograph != nullptr && devices_.delivered.insert(sha256(photograph->bytes)).second;
      Watch& watch = watches_[static_cast<std::size_t>(shot.camera)];
      if (fresh) {
        watch.proof = photograph->bytes;
        watch.probe_inspection.reset();
        watch.proof_deg = angleOf(task.stop) - before_deg;
        watch.trust = Trust::Awaiting;
      } else {
        cameras.push_back(shot.camera);
      }
    }
  }
  return {};
}

void Series::lookAtProof(int camera) {
  Watch& watch = watches_[static_cast<std::size_t>(camera)];
  watch.probe_inspection.reset();
  if (const auto mapped = inspectBytes(watch.proof, devices_.plate))
    watch.probe_inspection = mapped->inspection;
  watch.proof.clear();
  if (watch.probe_inspection && watch.probe_inspection->pixel_from_plate) return;
  // Nothing can be told from it. Again, but not for ever: a camera may be turned away from the
  // markers, and each of its photographs is flagged for that.
  watch.trust = ++watch.blind_proofs < options_.tries_per_shot ? Trust::Doubted : Trust::Proven;
}

// Was the plate turned between the throw-away exposure and this one as the table was?
bool Series::provenBy(Watch& watch, const PlateInspection& inspection, double angle_deg) const {
  if (!watch.probe_inspection) return false;
  const std::optional<double> turn = turnBetween_deg(*watch.probe_inspection, inspection);
  if (!turn) return false;
  const double off = std::remainder(*turn - (angle_deg - watch.proof_deg), 360);
  if (std::abs(off) > kMostTurnError_deg) return false;
  if (!devices_.turntable->turnsItself() && !sameSherds(*watch.probe_inspection, inspection))
    return false;
  watch.trust = Trust::Proven;
  watch.probe_inspection.reset();
  return true;
}

// The files are written and synced while their pictures are looked at; then the manifest names
// them; then each is judged, in the order of the cameras.
Result<void> Series::keepAndCheck() {
  struct Kept {
    Result<Arriving> arriving = Arriving{};
    std::shared_ptr<const MappedInspection> inspection;
    bool old = false;
  };
  std::vector<int> proofs;
  for (std::size_t c = 0; c < watches_.size(); ++c)
    if (!watches_[c].proof.empty()) proofs.push_back(static_cast<int>(c));
  std::vector<Kept> kept(shots_.size());
  const std::size_t jobs = shots_.size() + proofs.size();
  parallelFor(jobs, static_cast<int>(jobs), [&](std::size_t i) {
    if (i >= shots_.size()) return lookAtProof(proofs[i - shots_.size()]);
    const Shot& shot = shots_[i];
    if (shot.checked) return;
    if (shot.files.empty()) {  // by an earlier run
      const ManifestEntry* entry =
          std::as_const(*store_).manifest().find(options_.side, shot.stop, shot.camera);
      if (const Result<std::string> bytes = readFile(store_->fileOf(*entry)))
        kept[i].inspection = inspectBytes(*bytes, devices_.plate);
      return;
    }
    kept[i].arriving =
        store_->stage(shot.files, shot.camera, shot.stop, angleOf(shot.stop), shot.id);
    const devices::CameraFile* photograph = photographIn(shot.files);
    if (photograph != nullptr) kept[i].inspection = inspectBytes(photograph->bytes, devices_.plate);
  });
  Result<void> result;
  std::vector<Arriving> arriving;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (shots_[i].files.empty() || shots_[i].checked) continue;
    if (!kept[i].arriving) {
      result = kept[i].arriving.error();
      continue;
    }
    ManifestEntry& entry = kept[i].arriving->entry;
    entry.settings = shots_[i].settings;
    const bool known = !devices_.delivered.insert(entry.sha256).second;
    const auto c = static_cast<std::size_t>(shots_[i].camera);
    kept[i].old = devices_.cameras[c]->fileIsOfItsTrigger() ? store_->holdsElsewhere(entry) : known;
    arriving.push_back(std::move(*kept[i].arriving));
  }
  if (const Result<void> committed = store_->commit(std::move(arriving)); !committed)
    result = committed;
  if (!result) {
    shots_.clear();  // what the manifest names is judged when the side is gone on with
    return result;
  }
  for (std::size_t i = 0; i < kept.size(); ++i)
    if (!shots_[i].checked) checkShot(shots_[i], kept[i].inspection, kept[i].old);
  return {};
}

void Series::checkShot(Shot& shot, std::shared_ptr<const MappedInspection> mapped, bool old) {
  const PlateInspection* inspection = mapped ? &mapped->inspection : nullptr;
  Watch& watch = watches_[static_cast<std::size_t>(shot.camera)];
  shot.files.clear();
  shot.checked = true;
  const ManifestEntry* entry =
      std::as_const(*store_).manifest().find(options_.side, shot.stop, shot.camera);
  const double angle = angleOf(shot.stop);
  if (inspection != nullptr)
    shot.check = checkOf(*inspection, angle, watch.reference);
  else
    shot.check.problems.push_back(ShotProblem::Unreadable);
  if (old) shot.check.problems.push_back(ShotProblem::Repeated);
  if (watch.trust == Trust::Awaiting && inspection != nullptr && !inspection->pixel_from_plate) {
    // The throw-away exposure showed the plate: this one has to, or nothing is proven.
    if (!shot.check.has(ShotProblem::Unplaced))
      shot.check.problems.push_back(ShotProblem::Unplaced);
  } else if (watch.trust == Trust::Awaiting && inspection != nullptr &&
             !provenBy(watch, *inspection, angle)) {
    if (!shot.check.has(ShotProblem::WrongStop))
      shot.check.problems.push_back(ShotProblem::WrongStop);
    watch.trust = Trust::Doubted;
    shot.epoch = -1;
  }
  const auto place = static_cast<std::size_t>(shot.camera);
  shot.check.other_settings = store_->otherSettings(
      *entry, place < devices_.wanted_settings.size() ? devices_.wanted_settings[place]
                                                      : std::map<std::string, std::string>());
  if (!shot.check.other_settings.empty()) shot.check.problems.push_back(ShotProblem::OtherSettings);
  const auto counted = tries_.find({shot.stop, shot.camera});
  const int tries = counted == tries_.end() ? 0 : counted->second;
  shot.refused = !shot.check.keepable() || (shot.check.again() && tries < options_.tries_per_shot);
  if (!shot.refused && inspection != nullptr) {
    learn(watch.reference, *inspection, angle);
    inspections_[{shot.stop, shot.camera}] = std::move(mapped);
  }
  CaptureEvent event{
      .kind = shot.refused ? CaptureEventKind::ShotRefused : CaptureEventKind::ShotKept,
      .stop = shot.stop,
      .camera = shot.camera,
      .file = store_->fileOf(*entry),
      .check = shot.check,
      .take = entry->take};
  if (shot.refused)
    event.trouble = message("Camera %1, position %2: %3.", batch::cameraLetter(shot.camera),
                            shot.stop + 1, listed(shot.check));
  tell(event);
}

Result<void> Series::shootCameras(const Task& task) {
  if (stop_.stop_requested()) return Error::cancelled();
  for (const int c : task.cameras) {
    ++tries_[{task.stop, c}];
    if (byHand(c)) tell({.kind = CaptureEventKind::PressShutter, .stop = task.stop, .camera = c});
  }
  tell({.kind = CaptureEventKind::Shooting, .stop = task.stop});
  return expose(task.cameras, task.stop, shots_);
}

// Those that failed are brought back and tried again; what came stays in shots whatever happens.
Result<void> Series::expose(std::vector<int> cameras, int stop, std::vector<Shot>& shots) {
  bool fired = false;
  for (int round = 0; !cameras.empty(); ++round) {
    const double from_s = devices_.clock->now_s();
    const bool some_wait = std::any_of(cameras.begin(), cameras.end(), [&](int c) {
      return !devices_.cameras[static_cast<std::size_t>(c)]->triggersItself();
    });
    if ((round == 0 || some_wait) && devices_.turntable->firesShutters()) {
      if (Result<void> r = devices_.turntable->fireShutters(stop_); !r) return r;
      fired = true;
    }
    std::vector<Delivery> deliveries(cameras.size());
    parallelFor(cameras.size(), static_cast<int>(cameras.size()),
                [&](std::size_t i) { deliveries[i] = shootOne(cameras[i], fired); });
    fired = false;
    std::vector<int> failed;
    std::optional<Error> hopeless;
    double last_s = from_s;
    for (std::size_t i = 0; i < cameras.size(); ++i) {
      const auto c = static_cast<std::size_t>(cameras[i]);
      last_s = std::max(last_s, deliveries[i].fetched_s);
      if (deliveries[i].outcome) {
        shots.push_back({.stop = stop,
                         .camera = cameras[i],
                         .files = std::move(deliveries[i].files),
                         .id = devices_.cameras[c]->id(),
                         .settings = watches_[c].settings,
                         .epoch = epoch_});
      } else {
        const Error& error = deliveries[i].outcome.error();
        if (error.code != ErrorCode::Missing || round + 1 >= options_.tries_per_device)
          if (!hopeless || error.code == ErrorCode::Cancelled) hopeless = error;
        failed.push_back(cameras[i]);
      }
    }
    busy_s_ += last_s - from_s;
    if (hopeless) return *hopeless;
    for (std::size_t i = 0; i < cameras.size(); ++i)
      if (!deliveries[i].outcome)
        if (Result<void> r = recoverCamera(cameras[i], stop, deliveries[i].outcome.error()); !r)
          return r;
    cameras = std::move(failed);
  }
  return {};
}

Series::Delivery Series::shootOne(int camera, bool triggered) {
  devices::Camera& device = *devices_.cameras[static_cast<std::size_t>(camera)];
  Delivery delivery;
  if (!triggered) delivery.outcome = device.trigger();
  if (delivery.outcome) {
    const double patience_s = byHand(camera) ? options_.press_timeout_s : options_.fetch_timeout_s;
    Result<std::vector<devices::CameraFile>> files = device.fetch(patience_s, stop_);
    if (files)
      delivery.files = std::move(*files);
    else
      delivery.outcome = files.error();
  }
  delivery.fetched_s = devices_.clock->now_s();
  return delivery;
}

Result<void> Series::recoverCamera(int camera, int stop, const Error& trouble) {
  tell({.kind = CaptureEventKind::Trouble,
        .stop = stop,
        .camera = camera,
        .trouble = trouble.sentence()});
  progress_.note(NoteLevel::Warning,
                 about("capture", about(shotWords(stop, camera), trouble.sentence())));
  devices::Camera& device = *devices_.cameras[static_cast<std::size_t>(camera)];
  Result<void> back = device.reopen(stop_);
  if (back) (void)setAsRigSays(camera);     // one that was switched off; the shot's check tells
  if (back) back = device.getReady(stop_);  // drops what the failed try may still deliver
  if (!back && back.error().code == ErrorCode::Missing) return {};  // tried again by the shot
  return back;
}

}  // namespace ostraka::capture
