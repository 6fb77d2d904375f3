#include "api/dense.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <string>
#include <utility>
#include <vector>

#include "api/checked.h"
#include "base/message.h"
#include "files/json.h"
#include "stereo/background.h"
#include "stereo/stereo.h"

namespace ostraka::api {
namespace {

// OpenCV asks for writable memory even where it only reads.
template <class Pixel>
cv::Mat_<Pixel> over(const DensePhotograph& photograph, std::span<const std::uint8_t> bytes) {
  return cv::Mat_<Pixel>(photograph.height, photograph.width,
                         reinterpret_cast<Pixel*>(const_cast<std::uint8_t*>(bytes.data())));
}

rig::Intrinsics cameraOf(const DensePhotograph& p) {
  const std::array<double, 12>& d = p.distortion;
  const bool further = std::any_of(d.begin() + 5, d.end(), [](double k) { return k != 0; });
  return {p.width,
          p.height,
          p.fx,
          p.fy,
          p.cx,
          p.cy,
          {d, p.fisheye ? rig::Lens::Fisheye
              : further ? rig::Lens::Full
                        : rig::Lens::Standard}};
}

// Focal lengths from a fisheye's to a telescope's, in widths of the photograph.
bool isCamera(const DensePhotograph& p) {
  const double side = std::max(p.width, p.height);
  const auto isFocal = [&](double f) { return f > 0.01 * side && f < 1000 * side; };
  const auto isCentre = [&](double c) { return std::abs(c) < 1000 * side; };
  return isFocal(p.fx) && isFocal(p.fy) && isCentre(p.cx) && isCentre(p.cy) &&
         std::ranges::all_of(p.distortion, [](double k) { return std::isfinite(k); }) &&
         !cameraOf(p).folds();
}

Result<stereo::View> asView(const DensePhotograph& photograph, std::size_t index) {
  const std::string name = "photograph " + std::to_string(index);
  const bool sized = photograph.width > 0 && photograph.height > 0;
  const std::size_t pixels = sized ? static_cast<std::size_t>(photograph.width) *
                                         static_cast<std::size_t>(photograph.height)
                                   : 0;
  if (!sized || photograph.rgb.size() != 3 * pixels ||
      (!photograph.mask.empty() && photograph.mask.size() != pixels))
    return Error::unusable(message("The pixels or the mask differ in size from the stated width "
                                   "and height; give one value for each pixel."),
                           name);
  if (!isCamera(photograph))
    return Error::unusable(message("The camera of '%1' has no valid K, R, t or size.", name), name);
  const Result<Eigen::Isometry3d> pose =
      rigidTransform(photograph.camera_from_world.matrix(), name);
  if (!pose) return pose.error();
  stereo::View view;
  cv::cvtColor(over<cv::Vec3b>(photograph, photograph.rgb), view.photograph, cv::COLOR_RGB2BGR);
  view.mask = photograph.mask.empty() ? stereo::possibleObject(view.photograph)
                                      : over<std::uint8_t>(photograph, photograph.mask).clone();
  view.camera.intrinsics = cameraOf(photograph);
  view.camera.camera_from_plate = *pose;
  view.camera.file = std::to_string(index);
  return view;
}

Result<DenseCloud> reconstructed(std::span<const DensePhotograph> photographs, int threads,
                                 Progress& progress, const std::stop_token& stop) {
  std::vector<stereo::View> views;
  for (std::size_t i = 0; i < photographs.size(); ++i) {
    Result<stereo::View> view = asView(photographs[i], i);
    if (!view) return view.error();
    views.push_back(std::move(*view));
  }
  stereo::DenseOptions options;
  options.threads = threads;
  Result<stereo::Reconstruction> found = stereo::reconstruct(views, options, progress, stop);
  if (!found) return found.error();
  const stereo::Agreement& agreement = found->agreement;
  return DenseCloud{std::move(found->cloud), agreement.confirmedShare(), agreement.plausible()};
}

}  // namespace

Result<DenseCloud> dense(std::span<const DensePhotograph> photographs, int threads,
                         Progress& progress, std::stop_token stop) {
  return withoutExceptions([&] { return reconstructed(photographs, threads, progress, stop); });
}

}  // namespace ostraka::api
