#include "pipeline/no_plate.h"

#include <algorithm>

namespace ostraka::pipeline {

Result<MaskSource> maskSource(const std::string& masks, const batch::Batch& batch) {
  if (masks == "given") return MaskSource::Given;
  if (masks != "auto") return MaskSource::Network;
  if (batch.plate) return MaskSource::Plate;
  if (std::any_of(batch.shots.begin(), batch.shots.end(),
                  [](const batch::Shot& shot) { return !shot.mask_file.empty(); }))
    return MaskSource::Given;
  return Error{
      ErrorCode::UnusableInput,
      "Without plate.json the masks cannot be found; put masks beside the photographs, or name a "
      "network (--masks MODEL.onnx).",
      batch.folder.string()};
}

double nominalScale(const rig::ColmapPoses& poses) {
  std::vector<double> pixels;
  for (const rig::PosedImage& image : poses.images)
    for (const Eigen::Vector3d& point : poses.points) {
      const double depth = (image.camera_from_plate * point).z();
      if (depth > 0) pixels.push_back(depth / image.intrinsics.fx);
    }
  if (pixels.empty()) return 1;
  const auto middle = pixels.begin() + static_cast<std::ptrdiff_t>(pixels.size() / 2);
  std::nth_element(pixels.begin(), middle, pixels.end());
  return *middle > 0 ? kNominalPixel_mm / *middle : 1;
}

void resizeSide(std::vector<rig::PosedImage>& images, batch::Side side, double factor) {
  for (rig::PosedImage& image : images)
    if (image.side == side) image.camera_from_plate.translation() *= factor;
}

std::string noScaleWarning() {
  return "The result has no scale: without plate.json no length is known, and what is given in mm "
         "is a guess of the size of a pixel; photograph on a marker plate to measure.";
}

}  // namespace ostraka::pipeline
