#include "review/picture_pixel.h"

#include <algorithm>
#include <cmath>

#include "cloud/bounds.h"

namespace ostraka::review {
namespace {

constexpr double kMostPixels = 6e5;  // as half a window shows; a pose that is tried waits for it

}  // namespace

double picturePixel_mm(const rig::PosedImage& photograph, std::span<const Eigen::Vector3f> points) {
  const auto [lowest, highest] = boundsOf(points);
  const Eigen::Vector3d middle = 0.5 * (lowest + highest).cast<double>();
  const double depth = (photograph.camera_from_plate * middle).z();
  const Eigen::Vector3d size = (highest - lowest).cast<double>();
  const double seen = depth / photograph.intrinsics.fx;
  const double needed = std::sqrt(size.x() * size.y() / kMostPixels);
  return std::min(kWidestPicturePixel_mm, std::max(seen, needed));
}

}  // namespace ostraka::review
