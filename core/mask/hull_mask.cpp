#include "mask/hull_mask.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "base/message.h"
#include "base/parallel.h"
#include "ground/plate_picture.h"
#include "hull/hull.h"
#include "mask/colour_model.h"
#include "mask/outline.h"
#include "rig/support_plane.h"

namespace ostraka::mask {
namespace {

constexpr int kRounds = 4;       // colours and hull teach each other; the hull settles after three
constexpr int kVoxels = 96;      // per side of the box: 1 % of it, a few pixels of a photograph
constexpr double kBoxRadii = 2;  // half the box, in radii of the first guess

class HullMasker {
 public:
  HullMasker(std::span<const rig::PosedImage> images, std::span<const cv::Mat> photographs,
             const rig::Sight& guess, const HullMaskOptions& options)
      : images_(images), photographs_(photographs), guess_(guess), options_(options) {
    hull_.threads = options.threads;
    hull_.reduction = std::max(1, photographs[0].cols / 340);
    // A body is seen as itself by nearly all views; what only some call foreground is surroundings.
    hull_.inside_share = 0.6;
    hull_.carving_views = std::max(1.5, 0.2 * static_cast<double>(images.size()));
    space_.pitch = 2 * kBoxRadii * guess.radius / kVoxels;
    space_.low = guess.centre - Eigen::Vector3d::Constant(kBoxRadii * guess.radius);
    space_.count = {kVoxels, kVoxels, kVoxels};
  }

  Result<MaskResult> run(Progress& progress, const std::stop_token& stop) {
    start();
    for (int round = 0; round < kRounds; ++round) {
      progress.report(round, kRounds + 1);
      parallelFor(views_.size(), options_.threads, [&](std::size_t i) { weigh(i); });
      first_ = false;
      voxels_ = hull::carveHull(space_, views_, hull_, stop);
      if (stop.stop_requested()) return Error::cancelled();
      if (std::none_of(voxels_.begin(), voxels_.end(), [](unsigned char v) { return v != 0; }))
        return Error{
            ErrorCode::NotEnough,
            message("The photographs show no common object; check the cameras, or provide masks."),
            {}};
      parallelFor(views_.size(), options_.threads, [&](std::size_t i) {
        silhouettes_[i] = hull::silhouetteOfHull(space_, voxels_, views_[i], hull_).group;
      });
    }
    MaskResult result;
    result.masks.resize(images_.size());
    parallelFor(images_.size(), options_.threads, [&](std::size_t i) {
      if (!stop.stop_requested()) result.masks[i] = outline(i);
    });
    if (stop.stop_requested()) return Error::cancelled();
    progress.report(kRounds + 1, kRounds + 1);
    return result;
  }

 private:
  void start() {
    views_.resize(images_.size());
    colours_.resize(images_.size());
    silhouettes_.resize(images_.size());
    for (std::size_t i = 0; i < images_.size(); ++i) {
      cv::Mat small;
      cv::resize(photographs_[i], small,
                 {photographs_[i].cols / hull_.reduction, photographs_[i].rows / hull_.reduction},
                 0, 0, cv::INTER_AREA);
      colours_[i] = ground::logColours(small);
      views_[i].image = &images_[i];
      silhouettes_[i] = cv::Mat1b(small.size(), uchar{0});
      disc(i, 0.7, silhouettes_[i]);
    }
  }

  // Draws the guess, scaled, as it shows in a view.
  void disc(std::size_t i, double scale, cv::Mat1b& mask) const {
    const Eigen::Vector3d q = images_[i].camera_from_plate * guess_.centre;
    if (q.z() <= 0) return;
    const Eigen::Vector2d p = images_[i].intrinsics.project(q) / hull_.reduction;
    const double radius =
        scale * guess_.radius * images_[i].intrinsics.fx / q.z() / hull_.reduction;
    cv::circle(mask, {cvRound(p.x()), cvRound(p.y())}, cvRound(radius), 255, cv::FILLED);
  }

  // Odds of each reduced pixel from the colours inside and outside the silhouette so far.
  void weigh(std::size_t i) {
    cv::Mat1b inner, outer;
    const cv::Mat window = cv::getStructuringElement(cv::MORPH_ELLIPSE, {9, 9});
    // The hull of few views is wide: only its core is surely the body.
    cv::Mat1f depth;
    cv::distanceTransform(silhouettes_[i], depth, cv::DIST_L2, cv::DIST_MASK_PRECISE);
    double deepest = 0;
    cv::minMaxLoc(depth, nullptr, &deepest);
    inner = depth > 0.4 * deepest;
    cv::dilate(silhouettes_[i], outer, window);
    if (first_) disc(i, 1.6, outer);
    ColourHistogram body, surroundings;
    const cv::Mat3f& colours = colours_[i];
    for (int y = 0; y < colours.rows; ++y)
      for (int x = 0; x < colours.cols; ++x) {
        const int bin = ColourHistogram::bin(colours(y, x));
        if (inner(y, x) != 0) body.add(bin);
        if (outer(y, x) == 0) surroundings.add(bin);
      }
    body.finish();
    surroundings.finish();
    cv::Mat1f odds(colours.size());
    for (int y = 0; y < colours.rows; ++y)
      for (int x = 0; x < colours.cols; ++x) {
        const int bin = ColourHistogram::bin(colours(y, x));
        odds(y, x) = std::clamp(std::log(body.density(bin) / surroundings.density(bin)), -4.F, 4.F);
      }
    // Neighbours belong together; two reduced pixels keep the outline to a voxel.
    cv::GaussianBlur(odds, odds, {}, 2, 2, cv::BORDER_REPLICATE);
    views_[i].inside.create(odds.size());
    views_[i].clear.create(odds.size());
    for (int y = 0; y < odds.rows; ++y)
      for (int x = 0; x < odds.cols; ++x) {
        const float share = 1 / (1 + std::exp(-2 * odds(y, x)));
        views_[i].inside(y, x) = share;
        views_[i].clear(y, x) = std::max(0.F, 1 - 2 * share);
      }
    odds_[i] = odds;
  }

  cv::Mat1b outline(std::size_t i) const {
    const cv::Size size = photographs_[i].size();
    cv::Mat1b allowed;
    cv::Mat1f odds;
    cv::dilate(silhouettes_[i], allowed, cv::getStructuringElement(cv::MORPH_ELLIPSE, {7, 7}));
    cv::resize(allowed, allowed, size, 0, 0, cv::INTER_NEAREST);
    // Deep inside the hull the views' agreement speaks for the body, whatever a spot's own colour.
    cv::Mat1f spoken = odds_[i].clone();
    cv::Mat1f depth;
    cv::distanceTransform(silhouettes_[i], depth, cv::DIST_L2, cv::DIST_MASK_PRECISE);
    double deepest = 0;
    cv::minMaxLoc(depth, nullptr, &deepest);
    for (int y = 0; y < spoken.rows; ++y)
      for (int x = 0; x < spoken.cols; ++x)
        if (depth(y, x) > 0.5 * deepest) spoken(y, x) = std::max(spoken(y, x), 0.F) + 2;
    cv::resize(spoken, odds, size, 0, 0, cv::INTER_LINEAR);
    cv::Mat3f colours = ground::logColours(photographs_[i]);
    cv::GaussianBlur(colours, colours, {}, 1, 1);
    CutOptions cut_options;
    cut_options.min_area_px = 0.002 * static_cast<double>(size.area());
    return softenOutline(cutOutline(odds, allowed, colours, cut_options), photographs_[i]);
  }

  std::span<const rig::PosedImage> images_;
  std::span<const cv::Mat> photographs_;
  rig::Sight guess_;
  const HullMaskOptions& options_;
  hull::HullOptions hull_;
  hull::HullSpace space_;
  bool first_ = true;
  std::vector<hull::HullView> views_;
  std::vector<cv::Mat3f> colours_;
  std::vector<cv::Mat1b> silhouettes_;
  std::vector<cv::Mat1f> odds_ = std::vector<cv::Mat1f>(images_.size());
  std::vector<unsigned char> voxels_;
};

}  // namespace

Result<MaskResult> maskByHull(std::span<const rig::PosedImage> images,
                              std::span<const cv::Mat> photographs, const HullMaskOptions& options,
                              Progress& progress, std::stop_token stop) {
  if (const Result<void> ok =
          checkViews(images, photographs,
                     message("A visual hull needs at least 3 photographs; photograph "
                             "the object from more directions."));
      !ok)
    return ok.error();
  const rig::Sight guess = rig::commonSight(images);
  if (!guess.sound())
    return Error::unusable(message("The cameras do not view a common area; check their poses."));
  return HullMasker(images, photographs, guess, options).run(progress, stop);
}

}  // namespace ostraka::mask
