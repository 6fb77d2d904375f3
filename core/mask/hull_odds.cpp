#include "mask/hull_odds.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace ostraka::mask {
namespace {

constexpr float kSlackVoxels = 1;  // a hull's outermost voxel says nothing
constexpr double kMostHullOdds = 4, kPriorSamples = 10;
constexpr float kSureOdds = 3;

std::size_t stepOf(float voxels, std::size_t steps) {
  return static_cast<std::size_t>(std::clamp(2 * voxels, 0.F, static_cast<float>(steps - 1)));
}

}  // namespace

void HullOdds::addTo(cv::Mat1f& log_odds, const cv::Mat1f& voxels, float times) const {
  cv::Mat1f full;
  cv::resize(voxels, full, log_odds.size(), 0, 0, cv::INTER_LINEAR);
  for (int y = 0; y < full.rows; ++y)
    for (int x = 0; x < full.cols; ++x)
      if (full(y, x) > kSlackVoxels)
        log_odds(y, x) += times * steps[stepOf(full(y, x), steps.size())];
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
