#include "mask/hull_odds.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace ostraka::mask {
namespace {

constexpr float kSlackVoxels = 1;  // a hull's outermost voxel says nothing
// Enough to settle a doubt; at 4 the demo's models lose 0.009 mm (RESULTS.md).
constexpr double kMostHullOdds = 2, kPriorSamples = 10;
constexpr float kSureOdds = 3;

std::size_t stepOf(float voxels, std::size_t steps) {
  return static_cast<std::size_t>(std::clamp(2 * voxels, 0.F, static_cast<float>(steps - 1)));
}

cv::Mat1f oddsOf(const std::array<float, 12>& steps, const cv::Mat1f& voxels, cv::Size size) {
  cv::Mat1f odds;
  cv::resize(voxels, odds, size, 0, 0, cv::INTER_LINEAR);
  for (float& value : odds) value = value > kSlackVoxels ? steps[stepOf(value, steps.size())] : 0.F;
  return odds;
}

}  // namespace

void HullOdds::addTo(cv::Mat1f& log_odds, const cv::Mat1f& voxels) const {
  log_odds += oddsOf(steps, voxels, log_odds.size());
}

cv::Mat1f HullOdds::without(const cv::Mat1f& log_odds, const cv::Mat1f& voxels) const {
  return log_odds - oddsOf(steps, voxels, log_odds.size());
}

HullOdds learnHullOdds(std::span<const HullSight> sights, int reduction) {
  HullOdds odds;
  std::array<double, 12> sherd{}, plate{};
  for (const HullSight& view : sights)
    for (int y = 0; y < view.voxels.rows; ++y)
      for (int x = 0; x < view.voxels.cols; ++x) {
        if (view.group(y, x) == 0) continue;
        const std::size_t step = stepOf(view.voxels(y, x), sherd.size());
        if (view.log_odds(y * reduction + reduction / 2, x * reduction + reduction / 2) > kSureOdds)
          sherd[step] += 1;
        if (view.clear(y, x) > 0.5F) plate[step] += 1;
      }
  for (std::size_t k = 0; k < odds.steps.size(); ++k)
    odds.steps[k] = static_cast<float>(std::clamp(
        std::log((sherd[k] + kPriorSamples) / (plate[k] + kPriorSamples)), 0.0, kMostHullOdds));
  return odds;
}

}  // namespace ostraka::mask
