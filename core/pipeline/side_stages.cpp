// Poses, masks and dense reconstruction: each side on its own.
#include <algorithm>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "base/files.h"
#include "base/json.h"
#include "base/parallel.h"
#include "base/text.h"
#include "batch/photograph.h"
#include "cloud/ply.h"
#include "mask/given_mask.h"
#include "mask/network_mask.h"
#include "mask/plate_mask.h"
#include "pipeline/chain.h"
#include "pipeline/no_plate.h"
#include "pipeline/photo_checks.h"
#include "pipeline/run_log.h"
#include "pipeline/scale_check.h"
#include "rig/calibrate.h"
#include "rig/colmap_program.h"
#include "rig/free_cameras.h"
#include "stereo/colmap_door.h"
#include "stereo/openmvs_door.h"
#include "stereo/stereo.h"

namespace ostraka::pipeline {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

Result<std::vector<cv::Mat>> photographsOf(const std::vector<rig::PosedImage>& images,
                                           int threads) {
  std::vector<cv::Mat> photographs(images.size());
  std::vector<std::optional<Error>> errors(images.size());
  parallelFor(images.size(), threads, [&](std::size_t i) {
    Result<cv::Mat> photograph = batch::readPhotograph(images[i].file);
    if (photograph)
      photographs[i] =
          batch::reducedTo(*photograph, images[i].intrinsics.width, images[i].intrinsics.height);
    else
      errors[i] = photograph.error();
  });
  for (const std::optional<Error>& error : errors)
    if (error) return *error;
  return photographs;
}

std::size_t indexOf(batch::Side side) {
  return side == batch::Side::Front ? 0 : 1;
}

// Absent: not of this batch.
const batch::Shot* findShot(const batch::Batch& batch, const rig::PosedImage& image) {
  const auto found =
      std::find_if(batch.shots.begin(), batch.shots.end(), [&](const batch::Shot& shot) {
        return shot.side == image.side && shot.camera == image.camera && shot.stop == image.stop;
      });
  return found == batch.shots.end() ? nullptr : &*found;
}

// The images of cameras.json with their photographs where they lie now: the batch may have been
// moved, or be called by another name, since its cameras were found.
Result<std::vector<rig::PosedImage>> readCamerasOf(const batch::Batch& batch,
                                                   const fs::path& file) {
  Result<std::vector<rig::PosedImage>> images = rig::readCameras(file);
  if (!images) return images;
  for (rig::PosedImage& image : *images) {
    const batch::Shot* shot = findShot(batch, image);
    if (shot == nullptr)
      return Error{ErrorCode::UnusableInput,
                   "It names " + image.file +
                       ", which is not in the batch; delete this file, and the cameras are found "
                       "again.",
                   file.string()};
    image.file = shot->file.string();
  }
  return images;
}

// Of the photograph's own size, so that the two can be laid upon each other.
Result<void> writeMask(const fs::path& file, const cv::Mat1b& mask, const batch::Shot& shot) {
  cv::Mat whole = mask;
  if (mask.cols < shot.width || mask.rows < shot.height)
    cv::resize(mask, whole, {shot.width, shot.height}, 0, 0, cv::INTER_LINEAR);
  std::vector<unsigned char> bytes;
  cv::imencode(".png", whole, bytes, {cv::IMWRITE_PNG_COMPRESSION, 3});
  return writeFileAtomically(file, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

// By camera, of the size that its images have.
std::vector<cv::Mat> emptyPlates(const batch::Batch& batch,
                                 const std::vector<rig::PosedImage>& images) {
  std::vector<cv::Mat> empties;
  for (const batch::CalibrationShot& shot : batch.empty_plates) {
    const auto same = std::find_if(images.begin(), images.end(), [&](const rig::PosedImage& image) {
      return image.camera == shot.camera;
    });
    if (same == images.end()) continue;
    const Result<cv::Mat> photograph = batch::readPhotograph(shot.file);
    if (!photograph) continue;
    if (static_cast<int>(empties.size()) <= shot.camera)
      empties.resize(static_cast<std::size_t>(shot.camera) + 1);
    empties[static_cast<std::size_t>(shot.camera)] =
        batch::reducedTo(*photograph, same->intrinsics.width, same->intrinsics.height);
  }
  return empties;
}

// A photograph without a mask, or with one that cannot be read, gets an empty one: it costs that
// photograph only.
Result<mask::MaskResult> givenMasks(const Run& run, const std::vector<rig::PosedImage>& images) {
  mask::MaskResult result;
  std::optional<Error> first;
  int usable = 0;
  for (const rig::PosedImage& image : images) {
    const batch::Shot& shot = *findShot(run.batch, image);  // readCamerasOf has seen to it
    Result<cv::Mat1b> mask =
        shot.mask_file.empty()
            ? Result<cv::Mat1b>(Error{ErrorCode::UnusableInput,
                                      "This photograph has no mask; give one for each that is "
                                      "to be used.",
                                      image.file})
            : mask::readGivenMask(shot.mask_file, shot.width, shot.height);
    if (mask) {
      ++usable;
    } else {
      if (!first) first = mask.error();
      const std::string warning = mask.error().sentence() + " This photograph is not used.";
      run.progress.note(NoteLevel::Warning, warning);
      result.warnings.push_back(warning);
      mask = cv::Mat1b(shot.height, shot.width, uchar{0});
    }
    result.masks.push_back(std::move(*mask));
  }
  if (usable == 0 && first) return *first;
  return result;
}

Result<mask::MaskResult> networkMasks(const Run& run, const std::vector<cv::Mat>& photographs) {
  mask::MaskResult result;
  for (const cv::Mat& photograph : photographs) {
    if (run.stop.stop_requested()) return Error::cancelled();
    Result<cv::Mat1b> mask = mask::maskByNetwork(photograph, run.options.masks, {});
    if (!mask) return mask.error();
    result.masks.push_back(std::move(*mask));
    run.progress.report(static_cast<std::int64_t>(result.masks.size()),
                        static_cast<std::int64_t>(photographs.size()));
  }
  return result;
}

Result<mask::MaskResult> makeMasks(const Run& run, const std::vector<rig::PosedImage>& images,
                                   const rig::SheetBend& bend) {
  const Result<MaskSource> source = maskSource(run.options.masks, run.batch);
  if (!source) return source.error();
  if (*source == MaskSource::Given) return givenMasks(run, images);
  const Result<std::vector<cv::Mat>> photographs = photographsOf(images, run.options.threads);
  if (!photographs) return photographs.error();
  if (*source == MaskSource::Network) return networkMasks(run, *photographs);
  mask::PlateMaskOptions options;
  options.threads = run.options.threads;
  options.bend = bend;
  return mask::maskByPlate(images, *photographs, *run.batch.plate, emptyPlates(run.batch, images),
                           options, run.progress, run.stop);
}

// Each side by itself: in its true size where a length is known, else in the nominal one; then
// their sizes are compared when both have scans.
Result<StageNotes> poseWithoutPlate(const Run& run, const fs::path& folder) {
  std::vector<rig::PosedImage> images;
  StageNotes notes;
  double reprojection_px = 0;
  bool has_scale = true;
  for (const batch::Side side : {batch::Side::Front, batch::Side::Back}) {
    std::vector<batch::Shot> shots;
    for (const batch::Shot& shot : run.batch.shots)
      if (shot.side == side) shots.push_back(shot);
    const fs::path workspace = run.work / (std::string("colmap_") + batch::name(side));
    rig::ColmapPoseOptions options;
    options.threads = run.options.threads;
    WarningsKept kept(run.progress);
    const Result<rig::ColmapPoses> found =
        rig::poseWithColmap(shots, workspace, options, kept, run.stop);
    if (!found) return found.error();
    notes.warnings.insert(notes.warnings.end(), kept.warnings.begin(), kept.warnings.end());
    const Result<std::optional<rig::KnownScale>> known =
        knownScale(run.batch, side, *found, run.options.threads, run.stop);
    if (!known) return known.error();
    has_scale = has_scale && known->has_value();
    if (*known)
      notes.figures[std::string("scale_spread_") + batch::name(side)] = (*known)->relative_spread;
    const rig::ColmapPoses poses =
        rig::scaledTo(*found, *known ? (*known)->mm_per_unit : nominalScale(*found));
    images.insert(images.end(), poses.images.begin(), poses.images.end());
    reprojection_px = std::max(reprojection_px, poses.reprojection_px);
    if (poses.images.size() < shots.size())
      notes.warnings.push_back(std::to_string(shots.size() - poses.images.size()) + " of the " +
                               batch::name(side) +
                               " side's photographs got no pose from COLMAP and are left out.");
    std::error_code ignored;
    fs::remove_all(workspace, ignored);
  }
  if (run.options.rig)
    notes.warnings.push_back(
        "The rig was not used: without plate.json the poses come from COLMAP.");
  if (!has_scale) notes.warnings.push_back(noScaleWarning());
  notes.figures["images"] = images.size();
  notes.figures["reprojection_rms_px"] = reprojection_px;
  notes.figures["has_scale"] = has_scale;
  if (const Result<void> written = rig::writeCameras(folder / "cameras.json", images); !written)
    return written.error();
  return notes;
}

// Residuals per camera; with a known rig how well it fitted and what has moved since.
ordered_json residualsOf(const rig::BatchPoses& poses) {
  ordered_json list = ordered_json::array();
  for (const rig::CameraFindings& c : poses.cameras)
    list.push_back({{"camera", c.camera},
                    {"median_residual_px", c.median_residual_px},
                    {"known_rig_residual_px", c.known_residual_px},
                    {"moved_mm", c.moved_mm},
                    {"turned_rad", c.turned_rad}});
  return list;
}

// Distances between markers that took no part in the fit.
ordered_json heldOutOf(const rig::BatchPoses& poses) {
  ordered_json list = ordered_json::array();
  for (const rig::HeldOutDistance& d : poses.held_out)
    list.push_back({{"markers", {d.first, d.second}},
                    {"expected_mm", d.expected_mm},
                    {"measured_mm", d.measured_mm},
                    {"error_pct", 100 * d.error()}});
  return list;
}

// What speaks against the scale holds the result; what agrees stands in the log.
ScaleCheck scaleOf(const Run& run, const rig::BatchPoses& poses, StageNotes& notes) {
  const ScaleCheck check = checkScale(poses, run.batch.known_lengths);
  for (const std::string& warning : check.warnings) {
    run.progress.note(NoteLevel::Warning, warning);
    notes.warnings.push_back(warning);
  }
  for (const std::string& words : check.agreeing) run.progress.note(NoteLevel::Info, words);
  return check;
}

// Blurred photographs help the poses, by their markers, and harm all that follows.
Result<void> leaveOutSpoilt(const Run& run, rig::BatchPoses& poses, StageNotes& notes) {
  PhotoCheckOptions options;
  options.one_camera = run.batch.way == batch::Way::FreeCamera;
  options.threads = run.options.threads;
  const Result<PhotoFindings> found =
      checkPhotographs(poses.images, *run.batch.plate, options, run.stop);
  if (!found) return found.error();
  for (const std::string& warning : found->warnings) {
    run.progress.note(NoteLevel::Warning, warning);
    notes.warnings.push_back(warning);
  }
  for (auto i = found->spoilt.rbegin(); i != found->spoilt.rend(); ++i) {
    const auto at = static_cast<std::ptrdiff_t>(*i);
    poses.images.erase(poses.images.begin() + at);
    poses.rms_per_image_px.erase(poses.rms_per_image_px.begin() + at);
    poses.markers_per_image.erase(poses.markers_per_image.begin() + at);
  }
  return {};
}

constexpr const char* kBends = "sheet.json";

// {"unit":"mm","front":{"reach","coefficients":[12]},"back":{...}}
Result<void> writeBends(const fs::path& file, const std::array<rig::SheetBend, 2>& bends) {
  ordered_json json{{"unit", "mm"}};
  for (const batch::Side side : {batch::Side::Front, batch::Side::Back}) {
    const rig::SheetBend& bend = bends[indexOf(side)];
    json[batch::name(side)] = {{"reach", bend.reach_mm}, {"coefficients", bend.coefficients_mm}};
  }
  return writeJson(file, json);
}

Result<std::array<rig::SheetBend, 2>> readBends(const fs::path& file) {
  const Result<nlohmann::json> json = readJson(file);
  if (!json) return json.error();
  std::array<rig::SheetBend, 2> bends;
  try {
    for (const batch::Side side : {batch::Side::Front, batch::Side::Back}) {
      const nlohmann::json& own = json->at(batch::name(side));
      bends[indexOf(side)].reach_mm = own.at("reach").get<double>();
      bends[indexOf(side)].coefficients_mm =
          own.at("coefficients").get<std::array<double, rig::SheetBend::kTerms>>();
    }
  } catch (const nlohmann::json::exception&) {
    return Error::unusable(
        "It does not say how the sheets are bent; delete it, and they are measured again.", file);
  }
  return bends;
}

// What masks, stereo and all that follows work on: images of no more pixels than asked for.
Staged<Poses> atWorkingSize(const Run& run, Poses poses, StageRecord record) {
  bool any = false;
  for (rig::PosedImage& image : poses.images) {
    const int width = image.intrinsics.width;
    image.intrinsics = rig::reducedTo(image.intrinsics, run.options.megapixels);
    any = any || image.intrinsics.width != width;
  }
  if (any) record.outputs_hash = sha256(record.outputs_hash + fixed(run.options.megapixels, 3));
  record.notes.figures["draft"] = any && run.options.megapixels <= kDraftMegapixels;
  return {std::move(poses), std::move(record)};
}

// The share of all photographs' pixels that the masks cover: a figure for the report.
double coverage(const std::vector<cv::Mat1b>& masks) {
  double inside = 0, all = 0;
  for (const cv::Mat1b& mask : masks)
    inside += cv::countNonZero(mask >= 128), all += static_cast<double>(mask.total());
  return all > 0 ? inside / all : 0;
}

}  // namespace

std::string maskName(const rig::PosedImage& image) {
  return fs::path(image.file).stem().string() + ".png";
}

std::vector<rig::PosedImage> Poses::of(batch::Side side) const {
  std::vector<rig::PosedImage> chosen;
  for (const rig::PosedImage& image : images)
    if (image.side == side) chosen.push_back(image);
  return chosen;
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
  const auto work = [&](const fs::path& folder) -> Result<StageNotes> {
    if (!run.batch.plate) return poseWithoutPlate(run, folder);
    rig::PoseOptions options;
    options.threads = run.options.threads;
    const bool free = run.batch.way == batch::Way::FreeCamera;
    Result<rig::BatchPoses> poses =
        free ? rig::poseFreeCameras(run.batch, options, run.progress, run.stop)
             : rig::poseBatch(run.batch, known, options, run.progress, run.stop);
    if (!poses) return poses.error();
    StageNotes notes;
    notes.warnings = poses->warnings;
    const ScaleCheck scale = scaleOf(run, *poses, notes);
    if (const Result<void> left = leaveOutSpoilt(run, *poses, notes); !left) return left.error();
    if (const Result<void> written = rig::writeCameras(folder / "cameras.json", poses->images);
        !written)
      return written.error();
    if (const Result<void> written = free ? writeBends(folder / kBends, poses->bends)
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
                     {"scale_doubts", scale.doubts}};
    return notes;
  };
  const Result<StageRecord> record =
      runStage(run.held, "rig", {{"batch", run.batch_hash}, {"rig", rig_hash}}, work, run.progress);
  if (!record) return record.error();
  Result<std::vector<rig::PosedImage>> images =
      readCamerasOf(run.batch, run.work / "rig" / "cameras.json");
  if (!images) return images.error();
  if (!run.batch.plate) {
    const bool has_scale = record->notes.figures.value("has_scale", false);
    return atWorkingSize(run, {std::move(*images), {}, has_scale}, *record);
  }
  if (run.batch.way == batch::Way::FreeCamera) {
    const Result<std::array<rig::SheetBend, 2>> bends = readBends(run.work / "rig" / kBends);
    if (!bends) return bends.error();
    return atWorkingSize(run, {std::move(*images), {}, true, *bends}, *record);
  }
  Result<rig::Rig> rig = rig::readRig(run.work / "rig" / "rig.json");
  if (!rig) return rig.error();
  return atWorkingSize(run, {std::move(*images), std::move(*rig)}, *record);
}

Result<Staged<Masks>> maskStage(const Run& run, batch::Side side, const Staged<Poses>& poses) {
  const std::vector<rig::PosedImage> images = poses.value.of(side);
  const std::string name = std::string("masks_") + batch::name(side);
  std::string how = run.options.masks;
  if (how != "auto" && how != "given") {
    const Result<std::string> model = readFile(how);
    if (!model) return model.error();
    how = sha256(*model);
  }
  const auto work = [&](const fs::path& folder) -> Result<StageNotes> {
    const Result<mask::MaskResult> made = makeMasks(run, images, poses.value.bends[indexOf(side)]);
    if (!made) return made.error();
    for (std::size_t i = 0; i < images.size(); ++i)
      if (const Result<void> written = writeMask(folder / maskName(images[i]), made->masks[i],
                                                 *findShot(run.batch, images[i]));
          !written)
        return written.error();
    return StageNotes{{{"covered_share", coverage(made->masks)}}, made->warnings};
  };
  const Result<StageRecord> record =
      runStage(run.held, name,
               {{"batch", run.batch_hash}, {"poses", poses.record.outputs_hash}, {"masks", how}},
               work, run.progress);
  if (!record) return record.error();
  Masks masks;
  for (const rig::PosedImage& image : images) {
    Result<cv::Mat> mask = batch::readMask(run.work / name / maskName(image));
    if (!mask) return mask.error();
    masks.emplace_back(batch::reducedTo(*mask, image.intrinsics.width, image.intrinsics.height));
  }
  return Staged<Masks>{std::move(masks), *record};
}

namespace {

// Another program works in a folder beside the stage's, which stays for its log when it fails.
Result<PointCloud> denseCloud(const Run& run, const std::string& name,
                              const std::vector<stereo::View>& views,
                              const stereo::DenseOptions& options, ordered_json& figures) {
  if (run.options.dense == DenseMethod::Builtin) {
    Result<stereo::Reconstruction> found =
        stereo::reconstruct(views, options, run.progress, run.stop);
    if (!found) return found.error();
    figures["confirmed_share"] = found->agreement.confirmedShare();
    figures["covered_share"] = found->agreement.coveredShare();
    return std::move(found->cloud);
  }
  const bool colmap = run.options.dense == DenseMethod::Colmap;
  const fs::path workspace = run.work / (name + (colmap ? "_colmap" : "_openmvs"));
  Result<PointCloud> cloud =
      colmap ? stereo::reconstructWithColmap(views, options, workspace, run.progress, run.stop)
             : stereo::reconstructWithOpenMvs(views, options, workspace, run.progress, run.stop);
  std::error_code ignored;
  if (cloud) fs::remove_all(workspace, ignored);
  return cloud;
}

}  // namespace

Result<Staged<PointCloud>> denseStage(const Run& run, batch::Side side, const Staged<Poses>& poses,
                                      const Staged<Masks>& masks) {
  const std::vector<rig::PosedImage> images = poses.value.of(side);
  const std::string name = std::string("dense_") + batch::name(side);
  const auto work = [&](const fs::path& folder) -> Result<StageNotes> {
    // An empty mask would say that nothing is where it looks; it is rather a photograph spoilt.
    std::vector<rig::PosedImage> used;
    std::vector<cv::Mat1b> used_masks;
    StageNotes notes;
    for (std::size_t i = 0; i < images.size(); ++i) {
      if (cv::countNonZero(masks.value[i]) > 0) {
        used.push_back(images[i]);
        used_masks.push_back(masks.value[i]);
        continue;
      }
      const std::vector<std::string>& told = masks.record.notes.warnings;
      if (std::any_of(told.begin(), told.end(), [&](const std::string& warning) {
            return warning.find(images[i].file) != std::string::npos;
          }))
        continue;
      notes.warnings.push_back(images[i].file +
                               ": No sherd is marked on this photograph; it is left out. If sherds "
                               "are on it, take it again or mend its mask.");
      run.progress.note(NoteLevel::Warning, notes.warnings.back());
    }
    if (used.size() < 3)
      return Error{ErrorCode::NotEnough,
                   "Sherds are marked on " + std::to_string(used.size()) + " photographs of the " +
                       batch::name(side) +
                       " side; 3 are needed. Look at the masks, and at whether sherds were on the "
                       "plate.",
                   (run.work / (std::string("masks_") + batch::name(side))).string()};
    const Result<std::vector<cv::Mat>> photographs = photographsOf(used, run.options.threads);
    if (!photographs) return photographs.error();
    std::vector<stereo::View> views;
    for (std::size_t i = 0; i < used.size(); ++i)
      views.push_back({used[i], (*photographs)[i], used_masks[i]});
    stereo::DenseOptions options;
    options.threads = run.options.threads;
    if (run.batch.plate) options.floor_z_mm = -poses.value.bends[indexOf(side)].most();
    const Result<PointCloud> cloud = denseCloud(run, name, views, options, notes.figures);
    if (!cloud) return cloud.error();
    const Result<void> written =
        writePly(folder / "cloud.ply", *cloud, std::string("plate_") + batch::name(side));
    if (!written) return written.error();
    notes.figures["points"] = cloud->size();
    return notes;
  };
  const Result<StageRecord> record = runStage(run.held, name,
                                              {{"batch", run.batch_hash},
                                               {"poses", poses.record.outputs_hash},
                                               {"masks", masks.record.outputs_hash},
                                               {"dense", static_cast<int>(run.options.dense)}},
                                              work, run.progress);
  if (!record) return record.error();
  Result<PointCloud> cloud = readPlyCloud(run.work / name / "cloud.ply");
  if (!cloud) return cloud.error();
  return Staged<PointCloud>{std::move(*cloud), *record};
}

}  // namespace ostraka::pipeline
