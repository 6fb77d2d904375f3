// Masks and dense reconstruction: each side on its own.
#include <algorithm>
#include <nlohmann/json.hpp>
#include <opencv2/imgproc.hpp>

#include "base/message.h"
#include "base/parallel.h"
#include "base/part_progress.h"
#include "batch/mask_source.h"
#include "batch/photograph.h"
#include "checks/agreement.h"
#include "cloud/ply.h"
#include "files/files.h"
#include "images/png_image.h"
#include "mask/given_mask.h"
#include "mask/plate_mask.h"
#include "pipeline/chain.h"
#include "pipeline/preflight.h"
#include "pipeline/view_masks.h"
#include "rig/turntable.h"
#include "segmentation/network_mask.h"
#include "stages/run_log.h"
#include "stereo/colmap_adapter.h"
#include "stereo/openmvs_adapter.h"
#include "stereo/stereo.h"

namespace ostraka::pipeline {
namespace {

namespace fs = std::filesystem;

Result<std::vector<cv::Mat>> photographsOf(const std::vector<rig::PosedImage>& images, int threads,
                                           const std::stop_token& stop) {
  std::vector<cv::Mat> photographs(images.size());
  std::vector<std::optional<Error>> errors(images.size());
  parallelFor(images.size(), threads, [&](std::size_t i) {
    if (stop.stop_requested()) return;
    Result<cv::Mat> photograph = batch::readPhotograph(images[i].file);
    if (photograph)
      photographs[i] =
          batch::reducedTo(*photograph, images[i].intrinsics.width, images[i].intrinsics.height);
    else
      errors[i] = photograph.error();
  });
  if (stop.stop_requested()) return Error::cancelled();
  for (const std::optional<Error>& error : errors)
    if (error) return *error;
  return photographs;
}

// Of the photograph's own size, so that the two can be laid upon each other.
Result<void> writeMask(const fs::path& file, const cv::Mat1b& mask, const batch::Shot& shot) {
  cv::Mat whole = mask;
  if (mask.cols < shot.width || mask.rows < shot.height)
    cv::resize(mask, whole, {shot.width, shot.height}, 0, 0, cv::INTER_LINEAR);
  return writeFileAtomically(file, images::encodedPng(whole));
}

// By camera, of the size that its images have.
std::vector<cv::Mat> emptyPlates(const batch::Batch& batch,
                                 const std::vector<rig::PosedImage>& images) {
  std::vector<cv::Mat> empties;
  for (const batch::CalibrationShot& shot : batch.empty_plates) {
    const auto same = std::ranges::find(images, shot.camera, &rig::PosedImage::camera);
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
            ? Result<cv::Mat1b>(Error::unusable(
                  message(
                      "This photograph has no mask; provide one for each photograph to be used."),
                  image.file))
            : mask::readGivenMask(shot.mask_file, shot.width, shot.height);
    if (mask) {
      ++usable;
    } else {
      if (!first) first = mask.error();
      const Message warning =
          inOne(mask.error().sentence(), message("This photograph is not used."));
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
  Result<segmentation::Network> network = segmentation::Network::read(run.options.masks);
  if (!network) return network.error();
  mask::MaskResult result;
  for (const cv::Mat& photograph : photographs) {
    if (run.stop.stop_requested()) return Error::cancelled();
    Result<cv::Mat1b> mask = network->mask(photograph);
    if (!mask) return mask.error();
    result.masks.push_back(std::move(*mask));
    run.progress.report(static_cast<std::int64_t>(result.masks.size()),
                        static_cast<std::int64_t>(photographs.size()));
  }
  return result;
}

struct TurningPlate {
  batch::Plate plate;
  std::vector<rig::PosedImage> images;
};

// Photographs from cameras at rest over a round plate that turned are masked as a rig's are. When
// two of them were taken at the same time is not known: each is a stop of its own.
TurningPlate turningPlate(const batch::Plate& plate, batch::Way way,
                          const std::vector<rig::PosedImage>& images) {
  TurningPlate turning{plate, images};
  if (way != batch::Way::FreeCamera || !plate.round) return turning;
  const auto places = rig::turntablePlaces(images);
  if (!places) return turning;
  turning.plate.sheet.reset();
  for (std::size_t i = 0; i < images.size(); ++i)
    turning.images[i].camera = (*places)[i].ring, turning.images[i].stop = static_cast<int>(i);
  return turning;
}

Result<mask::MaskResult> makeMasks(const Run& run, const std::vector<rig::PosedImage>& images,
                                   const rig::SheetBend& bend,
                                   const std::optional<Eigen::AlignedBox2d>& ground) {
  const Result<batch::MaskSource> source = batch::maskSource(run.options.masks, run.batch);
  if (!source) return source.error();
  if (*source == batch::MaskSource::Given) return givenMasks(run, images);
  const Result<std::vector<cv::Mat>> photographs =
      photographsOf(images, run.threadsForOriginals(), run.stop);
  if (!photographs) return photographs.error();
  if (*source == batch::MaskSource::Network) return networkMasks(run, *photographs);
  const CoarseOptions coarse{run.options.threads, coarseMegapixels(run.options.megapixels)};
  if (*source == batch::MaskSource::Views)
    return masksFromViews(images, *photographs, ground, coarse, run.progress, run.stop);
  mask::PlateMaskOptions options;
  options.threads = run.options.threads;
  options.bend = bend;
  const TurningPlate turning = turningPlate(*run.batch.plate, run.batch.way, images);
  const bool on_sheet = turning.plate.sheet.has_value();
  if (on_sheet) {
    PartProgress first(run.progress, 0, 2);
    Result<std::vector<cv::Mat1b>> shown =
        shownOn({*turning.plate.sheet, bend, true}, images, *photographs, coarse, first, run.stop);
    if (!shown && shown.error().code != ErrorCode::NotEnough) return shown.error();
    if (shown) options.shown = std::move(*shown);
  }
  PartProgress rest(run.progress, on_sheet ? 1 : 0, on_sheet ? 2 : 1);
  return mask::maskByPlate(turning.images, *photographs, turning.plate,
                           emptyPlates(run.batch, images), options, rest, run.stop);
}

// The share of all photographs' pixels that the masks cover: a figure for the report.
double coverage(const std::vector<cv::Mat1b>& masks) {
  double inside = 0, all = 0;
  for (const cv::Mat1b& mask : masks)
    inside += cv::countNonZero(mask >= 128), all += static_cast<double>(mask.total());
  return all > 0 ? inside / all : 0;
}

}  // namespace

Result<Staged<Masks>> maskStage(const Run& run, batch::Side side, const Staged<Poses>& poses) {
  const std::vector<rig::PosedImage> images = poses.value.of(side);
  const double megapixels = maskMegapixels(run.options, run.batch);
  std::vector<rig::PosedImage> masked = images;
  for (rig::PosedImage& image : masked)
    image.intrinsics = rig::reducedTo(image.intrinsics, megapixels);
  const std::string name = std::string("masks_") + batch::name(side);
  const std::string& network = run.inputs.networkHash();
  const std::string& how = network.empty() ? run.options.masks : network;
  const auto work = [&](const fs::path& folder) -> Result<stages::StageNotes> {
    const Result<mask::MaskResult> made = makeMasks(run, masked, poses.value.bends[sideIndex(side)],
                                                    poses.value.grounds[sideIndex(side)]);
    if (!made) return made.error();
    for (std::size_t i = 0; i < images.size(); ++i)
      if (const Result<void> written = writeMask(folder / maskName(images[i]), made->masks[i],
                                                 *findShot(run.batch, images[i]));
          !written)
        return written.error();
    return stages::StageNotes{{{"covered_share", coverage(made->masks)}}, made->warnings};
  };
  const Result<stages::StageRecord> record = runStage(run, name,
                                                      {{"batch", run.batch_hash},
                                                       {"poses", poses.record.outputs_hash},
                                                       {"masks", how},
                                                       {"megapixels", megapixels}},
                                                      work);
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

// Whether one of the values is this file, or a path that ends in it.
bool names(const Message& message, const std::string& file) {
  return std::ranges::any_of(message.values(), [&](const MessageValue& v) {
    return v.kind == MessageValue::Kind::Message ? names(*v.message, file)
                                                 : v.text.find(file) != std::string::npos;
  });
}

// Another program works in a folder beside the stage's, which stays for its log when it fails.
Result<PointCloud> denseCloud(const Run& run, batch::Side side, const fs::path& folder,
                              std::vector<stereo::View> views, const stereo::DenseOptions& options,
                              stages::StageNotes& notes) {
  const auto read = [&](std::size_t i) -> Result<cv::Mat> {
    const rig::Intrinsics& camera = views[i].camera.intrinsics;
    Result<cv::Mat> photograph = batch::readPhotograph(views[i].camera.file);
    if (photograph) *photograph = batch::reducedTo(*photograph, camera.width, camera.height);
    return photograph;
  };
  if (run.options.dense == DenseMethod::Builtin) {
    Result<stereo::Reconstruction> found =
        stereo::reconstruct(views, read, options, run.progress, run.stop);
    if (!found) return found.error();
    notes.figures["confirmed_share"] = found->agreement.confirmedShare();
    notes.figures["covered_share"] = found->agreement.coveredShare();
    if (const auto doubt = checks::disagreement(side, found->agreement)) {
      run.progress.note(NoteLevel::Warning, *doubt);
      notes.warnings.push_back(*doubt);
    }
    return std::move(found->cloud);
  }
  for (std::size_t i = 0; i < views.size(); ++i) {
    Result<cv::Mat> photograph = read(i);
    if (!photograph) return photograph.error();
    views[i].photograph = std::move(*photograph);
  }
  const bool colmap = run.options.dense == DenseMethod::Colmap;
  const fs::path workspace = folder / (colmap ? "colmap" : "openmvs");
  Result<PointCloud> cloud =
      colmap ? stereo::reconstructWithColmap(views, options, workspace, run.progress, run.stop)
             : stereo::reconstructWithOpenMvs(views, options, workspace, run.progress, run.stop);
  std::error_code ignored;
  if (cloud) fs::remove_all(workspace, ignored);
  return cloud;
}

// All that is made of the points has their colours.
Staged<PointCloud> inTrueColours(const Run& run, PointCloud cloud, stages::StageRecord record) {
  if (run.colours.value) {
    for (Color& c : cloud.colors) c = run.colours.value->of(c);
    record.outputs_hash = sha256(record.outputs_hash + run.colours.record.outputs_hash);
  }
  return {std::move(cloud), std::move(record)};
}

}  // namespace

Result<Staged<PointCloud>> denseStage(const Run& run, batch::Side side, const Staged<Poses>& poses,
                                      const Staged<Masks>& masks) {
  const std::vector<rig::PosedImage> images = poses.value.of(side);
  const std::string name = std::string("dense_") + batch::name(side);
  const auto work = [&](const fs::path& folder) -> Result<stages::StageNotes> {
    // An empty mask would say that nothing is where it looks; it is rather a photograph spoilt.
    std::vector<rig::PosedImage> used;
    std::vector<cv::Mat1b> used_masks;
    stages::StageNotes notes;
    for (std::size_t i = 0; i < images.size(); ++i) {
      if (cv::countNonZero(masks.value[i]) > 0) {
        used.push_back(images[i]);
        used_masks.push_back(masks.value[i]);
        continue;
      }
      const std::vector<Message>& told = masks.record.notes.warnings;
      if (std::ranges::any_of(
              told, [&](const Message& warning) { return names(warning, images[i].file); }))
        continue;
      notes.warnings.push_back(
          inOne(message("%1: The mask marks no sherd in this photograph; it is left out.",
                        images[i].file),
                message("If it shows sherds, retake it or edit its mask.")));
      run.progress.note(NoteLevel::Warning, notes.warnings.back());
    }
    if (used.size() < 3)
      return Error{
          ErrorCode::NotEnough,
          inOne(side == batch::Side::Front ? message("Photographs of the front side whose masks "
                                                     "mark sherds: %1; at least 3 are needed.",
                                                     used.size())
                                           : message("Photographs of the back side whose masks "
                                                     "mark sherds: %1; at least 3 are needed.",
                                                     used.size()),
                message("Check the masks, and whether sherds were on the plate.")),
          (run.work / (std::string("masks_") + batch::name(side))).string()};
    std::vector<stereo::View> views;
    for (std::size_t i = 0; i < used.size(); ++i) views.push_back({used[i], {}, used_masks[i]});
    stereo::DenseOptions options;
    options.threads = run.options.threads;
    options.readers = run.threadsForOriginals();
    options.memory_mb = stereoMemory_mb(run.options, run.batch, options.readers);
    if (run.batch.plate) options.floor_z_mm = -poses.value.bends[sideIndex(side)].most();
    const Result<PointCloud> cloud =
        denseCloud(run, side, folder, std::move(views), options, notes);
    if (!cloud) return cloud.error();
    const Result<void> written =
        writePly(folder / "cloud.ply", *cloud, std::string("plate_") + batch::name(side));
    if (!written) return written.error();
    notes.figures["points"] = cloud->size();
    return notes;
  };
  const Result<stages::StageRecord> record =
      runStage(run, name,
               {{"batch", run.batch_hash},
                {"poses", poses.record.outputs_hash},
                {"masks", masks.record.outputs_hash},
                {"dense", static_cast<int>(run.options.dense)},
                {"memory_gb", run.options.memory_gb}},
               work);
  if (!record) return record.error();
  Result<PointCloud> cloud = readPlyCloud(run.work / name / "cloud.ply");
  if (!cloud) return cloud.error();
  return inTrueColours(run, std::move(*cloud), *record);
}

}  // namespace ostraka::pipeline
