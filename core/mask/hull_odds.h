#pragma once
#include <array>
#include <opencv2/core/mat.hpp>
#include <span>

namespace ostraka::mask {

/// What one view tells of the hull; all but log_odds are reduced.
struct HullSight {
  cv::Mat1f voxels;  ///< of hull behind a sample or below its front, whichever are fewer
  cv::Mat1b group;   ///< 0 where the hull does not show
  cv::Mat1f clear;   ///< 0..1: certainly lit plate
  cv::Mat1f log_odds;
};

/// How much a pixel's hull says for a sherd, by its voxels (HullSight), in half voxels. A hull is a
/// voxel or two too wide, more so with few photographs.
struct HullOdds {
  std::array<float, 12> steps{};
  /// Adds them to log odds of a photograph's own size.
  void addTo(cv::Mat1f& log_odds, const cv::Mat1f& voxels) const;
  /// Log odds as they were before.
  cv::Mat1f without(const cv::Mat1f& log_odds, const cv::Mat1f& voxels) const;
};

/// Learnt from the samples of all views that are sure by themselves, as sherd or as lit plate: a
/// black sherd, which is not, gets what the others say of its depth.
HullOdds learnHullOdds(std::span<const HullSight> sights, int reduction);

}  // namespace ostraka::mask
