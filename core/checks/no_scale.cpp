#include "checks/no_scale.h"

#include "base/median.h"
#include "base/message.h"
#include "base/parallel.h"
#include "batch/photograph.h"

namespace ostraka::checks {

double nominalScale(const colmap::ColmapPoses& poses) {
  std::vector<double> pixels;
  for (const rig::PosedImage& image : poses.images)
    for (const Eigen::Vector3d& point : poses.points) {
      const double depth = (image.camera_from_plate * point).z();
      if (depth > 0) pixels.push_back(depth / image.intrinsics.fx);
    }
  if (pixels.empty()) return 1;
  const double middle = medianOf(pixels);
  return middle > 0 ? kNominalPixel_mm / middle : 1;
}

Result<std::optional<KnownScale>> knownScale(const batch::Batch& batch, batch::Side side,
                                             const colmap::ColmapPoses& poses, int threads,
                                             std::stop_token stop) {
  std::vector<batch::KnownLength> lengths;
  for (const batch::KnownLength& known : batch.known_lengths)
    if (known.side == side) lengths.push_back(known);
  if (const std::optional<KnownScale> marked = scaleFromLengths(poses.images, lengths))
    return marked;
  if (!batch.board) return std::optional<KnownScale>();
  std::vector<calibration::TargetView> views(poses.images.size());
  std::vector<std::optional<Error>> errors(poses.images.size());
  parallelFor(poses.images.size(), threads, [&](std::size_t i) {
    if (stop.stop_requested()) return;
    const Result<cv::Mat> photograph = batch::readPhotograph(poses.images[i].file);
    if (!photograph) {
      errors[i] = photograph.error();
      return;
    }
    Result<calibration::TargetView> view = calibration::findBoard(*photograph, *batch.board);
    if (view)
      views[i] = std::move(*view);
    else
      errors[i] = view.error();
  });
  if (stop.stop_requested()) return Error::cancelled();
  for (const std::optional<Error>& error : errors)
    if (error) return *error;
  return scaleFromBoard(poses.images, views);
}

void resizeSide(std::vector<rig::PosedImage>& images, batch::Side side, double factor) {
  for (rig::PosedImage& image : images)
    if (image.side == side) image.camera_from_plate.translation() *= factor;
}

Message noScaleWarning() {
  return message(
      "The result has no scale: without plate.json no length is known, and lengths in mm are based "
      "on a guessed pixel size; photograph on a marker plate, lay the board of board.json beside "
      "the sherds on both sides, or mark a known length on both in scale.json.");
}

}  // namespace ostraka::checks
