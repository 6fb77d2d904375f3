// Where each photograph was taken from: the first stage of the chain.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/message.h"
#include "base/text.h"
#include "calibration/calibrate.h"
#include "calibration/free_cameras.h"
#include "calibration/lenses.h"
#include "calibration/sheet_bends.h"
#include "checks/no_scale.h"
#include "checks/photo_checks.h"
#include "checks/scale_check.h"
#include "checks/straight_down.h"
#include "colmap/colmap_program.h"
#include "files/files.h"
#include "files/json.h"
#include "files/json_message.h"
#include "pipeline/chain.h"
#include "pipeline/preflight.h"
#include "pipeline/proposed_sheet.h"
#include "rig/support_plane.h"
#include "rig/turntable.h"
#include "stages/run_log.h"

namespace ostraka::pipeline {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

// The images of cameras.json with their photographs where they lie now: the batch may have been
// moved, or be called by another name, since its cameras were found.
Result<std::vector<rig::PosedImage>> readCamerasOf(const batch::Batch& batch,
                                                   const fs::path& file) {
  Result<std::vector<rig::PosedImage>> images = rig::readCameras(file);
  if (!images) return images;
  for (rig::PosedImage& image : *images) {
    const batch::Shot* shot = findShot(batch, image);
    if (shot == nullptr)
      return Error::unusable(message("The file lists %1, which is not in the batch; delete the "
                                     "file to find the cameras again.",
                                     image.file),
                             file.string());
    image.file = shot->file.string();
  }
  return images;
}

constexpr const char* kGrounds = "grounds.json";
constexpr double kColmapMegapixels = 2;  // more features of finer detail cost time and add nothing

using Grounds = std::array<std::optional<Eigen::AlignedBox2d>, 2>;

// {"unit":"mm","front":{"low":[x,y],"high":[x,y]},"back":null}
Result<void> writeGrounds(const fs::path& file, const Grounds& grounds) {
  ordered_json sides{{"unit", "mm"}};
  for (const batch::Side side : {batch::Side::Front, batch::Side::Back}) {
    const auto& box = grounds[sideIndex(side)];
    sides[batch::name(side)] = box ? ordered_json{{"low", {box->min().x(), box->min().y()}},
                                                  {"high", {box->max().x(), box->max().y()}}}
                                   : ordered_json();
  }
  return writeJson(file, sides);
}

Result<Grounds> readGrounds(const fs::path& file) {
  const Result<nlohmann::json> sides = readJson(file);
  if (!sides) return sides.error();
  Grounds grounds;
  try {
    for (const batch::Side side : {batch::Side::Front, batch::Side::Back}) {
      const nlohmann::json& box = sides->at(batch::name(side));
      if (box.is_null()) continue;
      const auto low = box.at("low").get<std::array<double, 2>>(),
                 high = box.at("high").get<std::array<double, 2>>();
      grounds[sideIndex(side)] =
          Eigen::AlignedBox2d(Eigen::Vector2d(low[0], low[1]), Eigen::Vector2d(high[0], high[1]));
    }
  } catch (const nlohmann::json::exception&) {
    return Error::unusable(message("The file does not describe what the sherds stand on; delete it "
                                   "to determine this again."),
                           file);
  }
  return grounds;
}

struct SidePoses {
  colmap::ColmapPoses poses;
  std::optional<checks::KnownScale> scale;
  std::optional<Eigen::AlignedBox2d> ground;
};

// In its true size where a length is known, else in the nominal one.
Result<SidePoses> poseSideWithoutPlate(const Run& run, const fs::path& folder, batch::Side side,
                                       std::vector<batch::Shot> shots, Progress& progress) {
  const fs::path workspace = folder / (std::string("colmap_") + batch::name(side));
  colmap::ColmapPoseOptions options;
  options.threads = run.options.threads;
  const bool free = run.batch.way == batch::Way::FreeCamera;
  if (free) {
    options.lenses = calibration::lensesOf(shots);
    options.megapixels = kColmapMegapixels;
    for (batch::Shot& shot : shots) shot.mask_file.clear();  // the room stands still and helps
  }
  Result<colmap::ColmapPoses> found =
      colmap::poseWithColmap(shots, workspace, options, progress, run.stop);
  if (!found) return found.error();
  const Result<std::optional<checks::KnownScale>> known =
      checks::knownScale(run.batch, side, *found, run.threadsForOriginals(), run.stop);
  if (!known) return known.error();
  SidePoses posed{
      colmap::scaledTo(*found, *known ? (*known)->mm_per_unit : checks::nominalScale(*found)),
      *known,
      {}};
  if (free)
    if (const auto plane = rig::findSupportPlane(posed.poses.images, posed.poses.points,
                                                 Eigen::Vector3d::UnitZ())) {
      colmap::moveTo(posed.poses, plane->plane_from_world);
      posed.ground = plane->extent;
    }
  std::error_code ignored;
  fs::remove_all(workspace, ignored);
  return posed;
}

// Each side by itself; their sizes are compared when both have scans.
Result<stages::StageNotes> poseWithoutPlate(const Run& run, const fs::path& folder) {
  std::vector<rig::PosedImage> images;
  stages::StageNotes notes;
  Grounds grounds;
  double reprojection_px = 0;
  bool has_scale = true;
  for (const batch::Side side : {batch::Side::Front, batch::Side::Back}) {
    std::vector<batch::Shot> shots;
    for (const batch::Shot& shot : run.batch.shots)
      if (shot.side == side) shots.push_back(shot);
    if (shots.empty()) continue;
    stages::WarningsKept kept(run.progress);
    const Result<SidePoses> posed = poseSideWithoutPlate(run, folder, side, shots, kept);
    if (!posed) return posed.error();
    notes.warnings.insert(notes.warnings.end(), kept.warnings.begin(), kept.warnings.end());
    has_scale = has_scale && posed->scale.has_value();
    if (posed->scale)
      notes.figures[std::string("scale_spread_") + batch::name(side)] =
          posed->scale->relative_spread;
    const colmap::ColmapPoses& poses = posed->poses;
    images.insert(images.end(), poses.images.begin(), poses.images.end());
    grounds[sideIndex(side)] = posed->ground;
    reprojection_px = std::max(reprojection_px, poses.reprojection_px);
    if (poses.images.size() < shots.size())
      notes.warnings.push_back(side == batch::Side::Front
                                   ? message("Photographs of the front side that are left out "
                                             "because COLMAP found no pose for them: %1.",
                                             shots.size() - poses.images.size())
                                   : message("Photographs of the back side that are left out "
                                             "because COLMAP found no pose for them: %1.",
                                             shots.size() - poses.images.size()));
  }
  if (run.options.rig)
    notes.warnings.push_back(
        message("The rig was not used: without plate.json the poses come from COLMAP."));
  if (!has_scale) notes.warnings.push_back(checks::noScaleWarning());
  notes.figures["images"] = images.size();
  notes.figures["reprojection_rms_px"] = reprojection_px;
  notes.figures["has_scale"] = has_scale;
  if (const Result<void> written = rig::writeCameras(folder / "cameras.json", images); !written)
    return written.error();
  if (const Result<void> written = writeGrounds(folder / kGrounds, grounds); !written)
    return written.error();
  return notes;
}

// Residuals per camera; with a known rig how well it fitted and what has moved since.
ordered_json residualsOf(const calibration::BatchPoses& poses) {
  ordered_json list = ordered_json::array();
  for (const calibration::CameraFindings& c : poses.cameras)
    list.push_back({{"camera", c.camera},
                    {"median_residual_px", c.median_residual_px},
                    {"known_rig_residual_px", c.known_residual_px},
                    {"moved_mm", c.moved_mm},
                    {"turned_rad", c.turned_rad}});
  return list;
}

// Distances between markers that took no part in the fit.
ordered_json heldOutOf(const calibration::BatchPoses& poses) {
  ordered_json list = ordered_json::array();
  for (const calibration::HeldOutDistance& d : poses.held_out)
    list.push_back({{"markers", {d.first, d.second}},
                    {"expected_mm", d.expected_mm},
                    {"measured_mm", d.measured_mm},
                    {"error_pct", 100 * d.error()}});
  return list;
}

// What speaks against the scale holds the result; what agrees stands in the log.
checks::ScaleCheck scaleOf(const Run& run, const calibration::BatchPoses& poses,
                           stages::StageNotes& notes) {
  const checks::ScaleCheck check = checks::checkScale(poses, run.batch.known_lengths);
  for (const Message& warning : check.warnings) {
    run.progress.note(NoteLevel::Warning, warning);
    notes.warnings.push_back(warning);
  }
  for (const Message& words : check.agreeing) run.progress.note(NoteLevel::Info, words);
  return check;
}

void leaveOut(calibration::BatchPoses& poses, std::size_t index) {
  const auto at = static_cast<std::ptrdiff_t>(index);
  poses.images.erase(poses.images.begin() + at);
  poses.rms_per_image_px.erase(poses.rms_per_image_px.begin() + at);
  poses.markers_per_image.erase(poses.markers_per_image.begin() + at);
}

// Blurred photographs help the poses, by their markers, and harm all that follows.
Result<void> leaveOutSpoilt(const Run& run, calibration::BatchPoses& poses,
                            stages::StageNotes& notes) {
  checks::PhotoCheckOptions options;
  options.one_camera = run.batch.way == batch::Way::FreeCamera;
  options.megapixels = run.options.megapixels;
  options.threads = run.threadsForOriginals();
  const Result<checks::PhotoFindings> found =
      checks::checkPhotographs(poses.images, *run.batch.plate, options, run.stop);
  if (!found) return found.error();
  for (const Message& warning : found->warnings) {
    run.progress.note(NoteLevel::Warning, warning);
    notes.warnings.push_back(warning);
  }
  for (auto i = found->spoilt.rbegin(); i != found->spoilt.rend(); ++i) leaveOut(poses, *i);
  return {};
}

// Where a round plate turned below a camera at rest, what was taken from elsewhere has a light and
// a room of its own, which a single photograph does not tell.
void leaveOutOutliers(const Run& run, calibration::BatchPoses& poses, stages::StageNotes& notes) {
  if (run.batch.way != batch::Way::FreeCamera || !run.batch.plate->round) return;
  for (const batch::Side side : {batch::Side::Front, batch::Side::Back}) {
    std::vector<rig::PosedImage> images;
    std::vector<std::size_t> at;
    for (std::size_t i = 0; i < poses.images.size(); ++i)
      if (poses.images[i].side == side) images.push_back(poses.images[i]), at.push_back(i);
    const auto places = rig::turntablePlaces(images);
    if (!places) continue;
    for (std::size_t k = images.size(); k-- > 0;) {
      if ((*places)[k].ring >= 0) continue;
      const Message warning = message(
          "%1: the camera was not in the place that it had while the plate turned; the photograph "
          "is left out.",
          images[k].file);
      run.progress.note(NoteLevel::Warning, warning);
      notes.warnings.push_back(warning);
      leaveOut(poses, at[k]);
    }
  }
}

constexpr const char* kBends = "sheet.json";

// What stereo and all that follows work on: images of no more pixels than asked for.
Staged<Poses> atWorkingSize(const Run& run, Poses poses, stages::StageRecord record) {
  bool any = false;
  const double megapixels = run.options.megapixels;
  for (rig::PosedImage& image : poses.images) {
    const int width = image.intrinsics.width;
    image.intrinsics = rig::reducedTo(image.intrinsics, megapixels);
    any = any || image.intrinsics.width != width;
  }
  if (any) record.outputs_hash = sha256(record.outputs_hash + fixed(megapixels, 3));
  record.notes.figures["draft"] = any && megapixels <= kDraftMegapixels;
  return {std::move(poses), std::move(record)};
}

}  // namespace

std::vector<rig::PosedImage> Poses::of(batch::Side side) const {
  std::vector<rig::PosedImage> chosen;
  for (const rig::PosedImage& image : images)
    if (image.side == side) chosen.push_back(image);
  return chosen;
}

const batch::Shot* findShot(const batch::Batch& batch, const rig::PosedImage& image) {
  const auto found = std::ranges::find_if(batch.shots, [&](const batch::Shot& shot) {
    return shot.side == image.side && shot.camera == image.camera && shot.stop == image.stop;
  });
  return found == batch.shots.end() ? nullptr : &*found;
}

Result<Staged<Poses>> poseStage(const Run& run) {
  std::optional<rig::Rig> known;
  std::string rig_hash;
  if (run.options.rig) {
    const Result<std::string> bytes = readFile(*run.options.rig);
    if (!bytes) return bytes.error();
    const Result<rig::Rig> read = rig::readRig(*run.options.rig);
    if (!read) return read.error();
    known = *read;
    rig_hash = sha256(*bytes);
  }
  const auto work = [&](const fs::path& folder) -> Result<stages::StageNotes> {
    if (!run.batch.plate) return poseWithoutPlate(run, folder);
    calibration::PoseOptions options;
    options.threads = run.options.threads;
    const bool free = run.batch.way == batch::Way::FreeCamera;
    Result<calibration::BatchPoses> poses =
        free ? calibration::poseFreeCameras(run.batch, options, run.progress, run.stop)
             : calibration::poseBatch(run.batch, known, options, run.progress, run.stop);
    if (!poses) return poses.error();
    stages::StageNotes notes;
    notes.warnings = poses->warnings;
    const checks::ScaleCheck scale = scaleOf(run, *poses, notes);
    if (const Result<void> left = leaveOutSpoilt(run, *poses, notes); !left) return left.error();
    leaveOutOutliers(run, *poses, notes);
    if (const auto doubt = free ? checks::straightDown(poses->images) : std::nullopt) {
      run.progress.note(NoteLevel::Warning, *doubt);
      notes.warnings.push_back(*doubt);
    }
    if (const Result<void> written = rig::writeCameras(folder / "cameras.json", poses->images);
        !written)
      return written.error();
    if (const Result<void> written = free ? calibration::writeBends(folder / kBends, poses->bends)
                                          : rig::writeRig(folder / "rig.json", poses->rig);
        !written)
      return written.error();
    notes.figures = {{"images", poses->images.size()},
                     {"reprojection_rms_px", poses->reprojection_rms_px},
                     {"rms_per_image_px", poses->rms_per_image_px},
                     {"markers_per_image", poses->markers_per_image},
                     {"cameras", residualsOf(*poses)},
                     {"held_out", heldOutOf(*poses)},
                     {"known_lengths", scale.lengths},
                     {"scale_doubts", toJson(scale.doubts)}};
    return notes;
  };
  const Result<stages::StageRecord> record =
      runStage(run, "rig", {{"batch", run.batch_hash}, {"rig", rig_hash}}, work);
  if (!record) return record.error();
  Result<std::vector<rig::PosedImage>> images =
      readCamerasOf(run.batch, run.work / "rig" / "cameras.json");
  if (!images) return images.error();
  if (!run.batch.plate) {
    const bool has_scale = record->notes.figures.value("has_scale", false);
    const Result<Grounds> grounds = readGrounds(run.work / "rig" / kGrounds);
    if (!grounds) return grounds.error();
    return atWorkingSize(run, {std::move(*images), {}, has_scale, {}, *grounds}, *record);
  }
  if (run.batch.way == batch::Way::FreeCamera) {
    const Result<std::array<rig::SheetBend, 2>> bends =
        calibration::readBends(run.work / "rig" / kBends);
    if (!bends) return bends.error();
    const bool has_scale = !hasGuessedSize(run.batch, run.options);
    return atWorkingSize(run, {std::move(*images), {}, has_scale, *bends}, *record);
  }
  Result<rig::Rig> rig = rig::readRig(run.work / "rig" / "rig.json");
  if (!rig) return rig.error();
  return atWorkingSize(run, {std::move(*images), std::move(*rig)}, *record);
}

}  // namespace ostraka::pipeline
