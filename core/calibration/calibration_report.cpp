#include "calibration/calibration_report.h"

#include <algorithm>
#include <cmath>

#include "base/message.h"
#include "calibration/board_folder.h"
#include "calibration/calibration_advice.h"
#include "calibration/held_out.h"

namespace ostraka::calibration {
namespace {

namespace fs = std::filesystem;

void countRegions(CameraCalibration& camera, const std::vector<Eigen::Vector2d>& pixels) {
  for (const Eigen::Vector2d& p : pixels) {
    const int x = std::clamp(static_cast<int>(3 * p.x() / camera.width), 0, 2);
    const int y = std::clamp(static_cast<int>(3 * p.y() / camera.height), 0, 2);
    ++camera.corners_per_region[static_cast<std::size_t>(3 * y + x)];
  }
}

CameraCalibration ofLens(int camera, const IntrinsicsReport& lens,
                         const std::vector<Eigen::Vector2d>& pixels) {
  CameraCalibration out;
  out.camera = camera;
  out.width = lens.intrinsics.width;
  out.height = lens.intrinsics.height;
  out.focal_px = lens.intrinsics.fx;
  out.focal_sd_px = lens.sd[0];
  out.lens_rms_px = lens.rms_px;
  out.pictures = lens.files.size();
  if (!lens.files.empty()) {
    out.worst_picture = fs::path(lens.files[lens.worst_view]).filename().string();
    out.worst_picture_rms_px = lens.rms_per_view_px[lens.worst_view];
  }
  countRegions(out, pixels);
  for (const Eigen::Isometry3d& pose : lens.camera_from_target) {
    const double tilt = std::acos(std::min(1.0, std::abs(pose.linear()(2, 2))));
    out.largest_tilt_rad = std::max(out.largest_tilt_rad, tilt);
    out.tilted_pictures += tilt > 20 * M_PI / 180 ? 1 : 0;
  }
  return out;
}

Message prefixed(int camera, const Message& sentence) {
  return message("Camera %1: %2", batch::cameraLetter(camera), sentence);
}

// Pictures of a board alone: lenses, no places.
Result<CalibrationReport> calibrateLenses(const fs::path& folder, const CalibrationOptions& options,
                                          Progress& progress, std::stop_token stop) {
  const Result<std::map<int, BoardPictures>> cameras =
      readBoardFolder(folder, options.threads, progress, stop);
  if (!cameras) return cameras.error();
  CalibrationReport report;
  bool determined = true;
  for (const auto& [number, pictures] : *cameras) {
    report.set_aside.insert(report.set_aside.end(), pictures.set_aside.begin(),
                            pictures.set_aside.end());
    const Result<IntrinsicsReport> lens =
        calibrateIntrinsics(pictures.views, pictures.width, pictures.height);
    if (!lens)
      return Error{lens.error().code, prefixed(number, lens.error().what), folder.string()};
    std::vector<Eigen::Vector2d> pixels;
    for (const TargetView& view : pictures.views)
      if (std::find(lens->files.begin(), lens->files.end(), view.file) != lens->files.end())
        pixels.insert(pixels.end(), view.pixels.begin(), view.pixels.end());
    report.set_aside.insert(report.set_aside.end(), lens->set_aside.begin(), lens->set_aside.end());
    report.cameras.push_back(ofLens(number, *lens, pixels));
    determined = determined && lens->focal_determined;
    for (const Message& advice : lens->advice) report.missing.push_back(prefixed(number, advice));
    adviseOnBoard(report.cameras.back(), report.missing);
  }
  report.verdict_in_words =
      determined
          ? message("The lens is known but the camera poses are not, so no rig can be saved.")
          : message("Not usable: the focal length is not determined.");
  if (determined)
    report.missing.push_back(message(
        "Photograph the plate with its markers too: put one picture per camera and position into "
        "'front' (cam0_pos00.jpg and so on) next to plate.json, and the board's pictures into "
        "'calib'."));
  return report;
}

double outerEdges(const std::array<Eigen::Vector3d, 4>& a,
                  const std::array<Eigen::Vector3d, 4>& b) {
  return ((a[0] + a[1]) / 2 - (b[0] + b[1]) / 2).norm();
}

Result<std::vector<MeasuredLength>> measure(const BatchPoses& poses, const batch::Plate& plate,
                                            const std::vector<MarkerLength>& lengths) {
  const auto corners = [&](int id) -> std::optional<std::array<Eigen::Vector3d, 4>> {
    for (std::size_t m = 0; m < plate.markers.size(); ++m)
      if (plate.markers[m].id == id) return poses.markers[m];
    return std::nullopt;
  };
  std::vector<MeasuredLength> measured;
  for (const MarkerLength& length : lengths) {
    const auto a = corners(length.first), b = corners(length.second);
    if (!a || !b)
      return Error::unusable(
          message("Marker %1 of the known length is visible in fewer than two photographs; choose "
                  "two markers of the plate that the photographs show.",
                  a ? length.second : length.first));
    measured.push_back({length, outerEdges(*a, *b)});
  }
  return measured;
}

Result<CalibrationReport> calibrateBatch(const batch::Batch& batch,
                                         const CalibrationOptions& options, Progress& progress,
                                         std::stop_token stop) {
  PoseOptions pose_options;
  pose_options.threads = options.threads;
  const Result<BatchPoses> poses = poseBatch(batch, {}, pose_options, progress, stop);
  if (!poses) return poses.error();
  CalibrationReport report;
  report.reprojection_rms_px = poses->reprojection_rms_px;
  report.held_out = poses->held_out;
  const Result<std::vector<MeasuredLength>> lengths =
      measure(*poses, *batch.plate, options.lengths);
  if (!lengths) return lengths.error();
  report.lengths = *lengths;
  for (const CameraFindings& found : poses->cameras) {
    CameraCalibration camera;
    if (found.lens) camera = ofLens(found.camera, *found.lens, found.board_pixels);
    camera.camera = found.camera;
    camera.width = found.width;
    camera.height = found.height;
    camera.plate_residual_px = found.median_residual_px;
    if (found.lens)
      for (const Message& advice : found.lens->advice)
        report.missing.push_back(prefixed(found.camera, advice));
    if (const rig::RigCamera* rig = poses->rig.find(found.camera); rig != nullptr) {
      camera.focal_px = rig->intrinsics.fx;
      camera.focal_sd_px = rig->focal_sd_px;
    }
    adviseOnBoard(camera, report.missing);
    report.cameras.push_back(std::move(camera));
  }
  adviseOnPlate(*poses, report);
  if (report.verdict != Verdict::NotUsable) report.rig = poses->rig;
  return report;
}

}  // namespace

Result<void> CalibrationOptions::check() const {
  for (const MarkerLength& length : lengths)
    if (!(length.mm > 0) || length.first == length.second)
      return Error::unusable(
          message("A known length needs two different markers and a value greater than 0 mm."));
  return {};
}

Result<CalibrationReport> calibrateFolder(const fs::path& folder, const CalibrationOptions& options,
                                          Progress& progress, std::stop_token stop) {
  if (const Result<void> good = options.check(); !good) return good.error();
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored))
    return Error::unusable(
        message("Folder not found; choose one with photographs of the plate or of the board."),
        folder.string());
  if (!fs::is_directory(folder / "front", ignored) && !fs::is_directory(folder / "back", ignored) &&
      !fs::is_directory(folder / "top_images", ignored))
    return calibrateLenses(folder, options, progress, stop);
  batch::ReadBatchOptions read_options;
  read_options.min_views_per_side = 0;  // a rig can be calibrated from the front alone
  const Result<batch::Batch> batch = batch::readBatch(folder, read_options, progress);
  if (!batch) return batch.error();
  return calibrateBatch(*batch, options, progress, stop);
}

}  // namespace ostraka::calibration
