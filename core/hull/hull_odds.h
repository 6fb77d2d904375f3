#pragma once
#include <array>
#include <opencv2/core/mat.hpp>
#include <span>

namespace ostraka::hull {

/// What one view tells of the hull; all but log_odds are reduced.
struct HullSight {
  cv::Mat1f behind;  ///< voxels of hull behind a sample
  cv::Mat1f below;   ///< voxels from the floor up to where its ray meets the hull
  cv::Mat1b group;   ///< 0 where the hull does not show
  cv::Mat1f clear;   ///< 0..1: certainly lit plate
  cv::Mat1f log_odds;
};

/// How much a pixel's hull says for a sherd, by the voxels behind and below (HullSight), rounded. A
/// hull is a voxel or two too wide, more so with few photographs.
struct HullOdds {
  static constexpr std::size_t kSteps = 8;
  std::array<std::array<float, kSteps>, kSteps> by{};  ///< [behind][below]
  /// Of a photograph's own size.
  cv::Mat1f of(const cv::Mat1f& behind, const cv::Mat1f& below, cv::Size size) const;
};

/// Learnt from the samples of all views that are sure by themselves, as sherd or as lit plate: a
/// black sherd, which is not, gets what the others say of its depth.
HullOdds learnHullOdds(std::span<const HullSight> sights, int reduction);

}  // namespace ostraka::hull
