#include "pipeline/view_masks.h"

#include "base/parallel.h"
#include "batch/photograph.h"
#include "mask/coarse_heights.h"
#include "mask/hull_mask.h"
#include "mask/plate_mask.h"
#include "rig/support_plane.h"
#include "stereo/stereo.h"

namespace ostraka::pipeline {
namespace {

constexpr double kCoarseMegapixels = 0.25;  // enough to tell a sherd of 5 mm height from a table
// Of the common sight's radius: how far below and above the ground things are looked for, and how
// far from it its own points may lie. Beyond what was seen of the ground nothing is: what surrounds
// it is blurred, or too plain, and stereo finds heights there that are none.
constexpr double kSoughtBelow = 0.2, kSoughtAbove = 2, kGroundThickness = 0.05;

// What stands on the ground, photograph by photograph.
Result<std::vector<cv::Mat1b>> shownOn(const Eigen::AlignedBox2d& ground,
                                       const std::vector<rig::PosedImage>& images,
                                       const std::vector<cv::Mat>& photographs, int threads,
                                       Progress& progress, const std::stop_token& stop) {
  std::vector<stereo::View> views(images.size());
  parallelFor(images.size(), threads, [&](std::size_t i) {
    views[i].camera = images[i];
    views[i].camera.intrinsics = rig::reducedTo(images[i].intrinsics, kCoarseMegapixels);
    views[i].photograph = batch::reducedTo(photographs[i], views[i].camera.intrinsics.width,
                                           views[i].camera.intrinsics.height);
  });
  const double reach = rig::commonSight(images).radius;
  Eigen::AlignedBox3d bounds;
  bounds.min() << ground.min(), -kSoughtBelow * reach;
  bounds.max() << ground.max(), kSoughtAbove * reach;
  stereo::DenseOptions options;
  options.threads = threads;
  options.bounds = bounds;
  const Result<stereo::Reconstruction> coarse = stereo::reconstruct(views, options, progress, stop);
  if (!coarse) return coarse.error();
  const double least = mask::leastRaised(coarse->cloud, kGroundThickness * reach);
  std::vector<cv::Mat1b> shown(images.size());
  parallelFor(images.size(), threads, [&](std::size_t i) {
    shown[i] = mask::shownBy(coarse->cloud, views[i].camera, least);
  });
  return shown;
}

}  // namespace

Result<mask::MaskResult> masksFromViews(const std::vector<rig::PosedImage>& images,
                                        const std::vector<cv::Mat>& photographs,
                                        const std::optional<Eigen::AlignedBox2d>& ground,
                                        int threads, Progress& progress,
                                        const std::stop_token& stop) {
  if (!ground) {
    mask::HullMaskOptions options;
    options.threads = threads;
    return mask::maskByHull(images, photographs, options, progress, stop);
  }
  Result<std::vector<cv::Mat1b>> shown =
      shownOn(*ground, images, photographs, threads, progress, stop);
  if (!shown) return shown.error();
  batch::Plate plane;
  plane.sheet = ground;
  plane.diameter_mm = ground->diagonal().norm();
  mask::PlateMaskOptions options;
  options.threads = threads;
  options.shown = std::move(*shown);
  return mask::maskByPlate(images, photographs, plane, {}, options, progress, stop);
}

}  // namespace ostraka::pipeline
