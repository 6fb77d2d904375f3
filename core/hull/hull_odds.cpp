#include "hull/hull_odds.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace ostraka::hull {
namespace {

constexpr float kSlackVoxels = 1;  // a hull's outermost voxel says nothing
// Enough to settle a doubt; at 4 the demo's models lose 0.009 mm (docs/experiments.md).
constexpr double kMostHullOdds = 2, kPriorSamples = 10;
constexpr float kSureOdds = 3;

std::size_t stepOf(float voxels) {
  return static_cast<std::size_t>(
      std::clamp(voxels + 0.5F, 0.F, static_cast<float>(HullOdds::kSteps - 1)));
}

}  // namespace

cv::Mat1f HullOdds::of(const cv::Mat1f& behind, const cv::Mat1f& below, cv::Size size) const {
  cv::Mat1f odds, height;
  cv::resize(behind, odds, size, 0, 0, cv::INTER_LINEAR);
  cv::resize(below, height, size, 0, 0, cv::INTER_LINEAR);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) {
      const float b = odds(y, x), h = height(y, x);
      odds(y, x) = std::min(b, h) > kSlackVoxels ? by[stepOf(b)][stepOf(h)] : 0.F;
    }
  return odds;
}

HullOdds learnHullOdds(std::span<const HullSight> sights, int reduction) {
  HullOdds odds;
  std::array<std::array<double, HullOdds::kSteps>, HullOdds::kSteps> sherd{}, plate{};
  for (const HullSight& view : sights)
    for (int y = 0; y < view.group.rows; ++y)
      for (int x = 0; x < view.group.cols; ++x) {
        if (view.group(y, x) == 0) continue;
        const std::size_t b = stepOf(view.behind(y, x)), h = stepOf(view.below(y, x));
        if (view.log_odds(y * reduction + reduction / 2, x * reduction + reduction / 2) > kSureOdds)
          sherd[b][h] += 1;
        if (view.clear(y, x) > 0.5F) plate[b][h] += 1;
      }
  for (std::size_t b = 0; b < HullOdds::kSteps; ++b)
    for (std::size_t h = 0; h < HullOdds::kSteps; ++h)
      odds.by[b][h] = static_cast<float>(
          std::clamp(std::log((sherd[b][h] + kPriorSamples) / (plate[b][h] + kPriorSamples)), 0.0,
                     kMostHullOdds));
  return odds;
}

}  // namespace ostraka::hull
