#include "pipeline/view_masks.h"

#include <opencv2/imgproc.hpp>

#include "base/parallel.h"
#include "base/part_progress.h"
#include "batch/photograph.h"
#include "mask/coarse_heights.h"
#include "mask/hull_mask.h"
#include "mask/plate_mask.h"
#include "rig/support_plane.h"
#include "stereo/stereo.h"

namespace ostraka::pipeline {
namespace {

constexpr double kCoarseMegapixels = 0.5, kCoarseOfDraft = 0.25;
// Of the common sight's radius: how far below and above the ground things are looked for, and how
// far from it its own points may lie. Beyond what was seen of the ground nothing is: what surrounds
// it is blurred, or too plain, and stereo finds heights there that are none.
constexpr double kSoughtBelow = 0.2, kSoughtAbove = 2, kGroundThickness = 0.05;

// Heights need no more: the masks of batches/hand stay as they are (docs/experiments.md).
constexpr int kSources = 5, kSourcesPerPixel = 3;

constexpr std::size_t kMostViews = 12;  // of a printed sheet: they see all that is to be confirmed

rig::PosedImage coarsely(rig::PosedImage image, const CoarseOptions& options) {
  image.intrinsics = rig::reducedTo(image.intrinsics, options.megapixels);
  return image;
}

// The log names the stage that asks for coarse stereo, as the window does.
class NotesOfMasks final : public Progress {
 public:
  explicit NotesOfMasks(Progress& outer) : outer_(outer) {}
  void report(std::int64_t done, std::int64_t total) override { outer_.report(done, total); }
  void note(NoteLevel level, const Message& text) override {
    outer_.note(level, "masks: " + text.english());
  }

 private:
  Progress& outer_;
};

// Where a photograph shows the box, 255.
cv::Mat1b sightOf(const Eigen::AlignedBox3d& box, const rig::PosedImage& image) {
  cv::Mat1b sight(image.intrinsics.height, image.intrinsics.width, uchar{0});
  std::vector<cv::Point2f> corners;
  for (int k = 0; k < 8; ++k) {
    const Eigen::Vector3d q =
        image.camera_from_plate * box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(k));
    if (q.z() <= 0) return sight = 255;
    const Eigen::Vector2d pixel = image.intrinsics.project(q).cwiseMax(-1e4).cwiseMin(1e4);
    corners.emplace_back(static_cast<float>(pixel.x()), static_cast<float>(pixel.y()));
  }
  std::vector<cv::Point2f> hull;
  cv::convexHull(corners, hull);
  const std::vector<cv::Point> outline(hull.begin(), hull.end());
  cv::fillConvexPoly(sight, outline, cv::Scalar(255));
  return sight;
}

}  // namespace

double coarseMegapixels(double megapixels) {
  return megapixels <= kDraftMegapixels ? kCoarseOfDraft : kCoarseMegapixels;
}

Result<std::vector<cv::Mat1b>> shownOn(const Ground& ground,
                                       const std::vector<rig::PosedImage>& images,
                                       const std::vector<cv::Mat>& photographs,
                                       const CoarseOptions& coarsely_seen, Progress& progress,
                                       const std::stop_token& stop) {
  const int threads = coarsely_seen.threads;
  const double reach = rig::commonSight(images).radius;
  Eigen::AlignedBox3d bounds;
  bounds.min() << ground.extent.min(), -kSoughtBelow * reach;
  bounds.max() << ground.extent.max(), kSoughtAbove * reach;
  if (ground.printed) {
    bounds.min().z() = -kGroundThickness * reach;
    bounds.max().z() = mask::PlateMaskOptions().height_mm;
  }
  const std::size_t step = ground.printed ? (images.size() + kMostViews - 1) / kMostViews : 1;
  std::vector<stereo::View> views((images.size() + step - 1) / step);
  parallelFor(views.size(), threads, [&](std::size_t k) {
    const std::size_t i = k * step;
    stereo::View& view = views[k];
    view.camera = coarsely(images[i], coarsely_seen);
    view.photograph = batch::reducedTo(photographs[i], view.camera.intrinsics.width,
                                       view.camera.intrinsics.height);
    if (ground.printed) view.mask = sightOf(bounds, view.camera);
  });
  stereo::DenseOptions options;
  options.threads = threads;
  options.bounds = bounds;
  options.max_sources = kSources;
  options.max_sources_per_pixel = kSourcesPerPixel;
  NotesOfMasks masks(progress);
  const Result<stereo::Reconstruction> coarse = stereo::reconstruct(views, options, masks, stop);
  if (!coarse) return coarse.error();
  const std::vector<float> heights = mask::heightsAbove(coarse->cloud, ground.bend);
  const double least = mask::leastRaised(heights, kGroundThickness * reach);
  const mask::Gaps gaps = ground.printed ? mask::Gaps::Left : mask::Gaps::Filled;
  std::vector<cv::Mat1b> shown(images.size());
  parallelFor(images.size(), threads, [&](std::size_t i) {
    shown[i] =
        mask::shownBy(coarse->cloud, heights, coarsely(images[i], coarsely_seen), least, gaps);
  });
  return shown;
}

Result<mask::MaskResult> masksFromViews(const std::vector<rig::PosedImage>& images,
                                        const std::vector<cv::Mat>& photographs,
                                        const std::optional<Eigen::AlignedBox2d>& ground,
                                        const CoarseOptions& coarse, Progress& progress,
                                        const std::stop_token& stop) {
  if (!ground) {
    mask::HullMaskOptions options;
    options.threads = coarse.threads;
    return mask::maskByHull(images, photographs, options, progress, stop);
  }
  PartProgress first(progress, 0, 2), second(progress, 1, 2);
  Result<std::vector<cv::Mat1b>> shown =
      shownOn({*ground, {}, false}, images, photographs, coarse, first, stop);
  if (!shown) return shown.error();
  batch::Plate plane;
  plane.sheet = ground;
  plane.diameter_mm = ground->diagonal().norm();
  mask::PlateMaskOptions options;
  options.threads = coarse.threads;
  options.shown = std::move(*shown);
  return mask::maskByPlate(images, photographs, plane, {}, options, second, stop);
}

}  // namespace ostraka::pipeline
