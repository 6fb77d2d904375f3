#include "segmentation/network_odds.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace ostraka::segmentation {
namespace {

constexpr int kSteps = 12;            // of what the network says, one of the logit each
constexpr float kMostWorth = 4;       // may outvote a doubt, not a certainty, as learnt colours
constexpr float kFewestSure = 100;    // samples of either
constexpr float kWrongShare = 2e-3F;  // share of either that is wrong in the learning itself

float logit(int says) {
  const float p = std::clamp(static_cast<float>(says) / 255, 1e-3F, 1 - 1e-3F);
  return std::log(p / (1 - p));
}

int stepOf(int says) {
  return std::clamp(static_cast<int>(std::floor(logit(says) + 0.5F * kSteps)), 0, kSteps - 1);
}

// The nearest values that do not fall, least squares with weights: pool adjacent violators.
void makeRising(std::array<float, kSteps>& values, const std::array<float, kSteps>& weights) {
  struct Pool {
    float mean, weight;
    int count;
  };
  std::vector<Pool> pools;
  for (int i = 0; i < kSteps; ++i) {
    pools.push_back({values[i], weights[i], 1});
    while (pools.size() > 1 && pools[pools.size() - 2].mean > pools.back().mean) {
      const Pool last = pools.back();
      pools.pop_back();
      Pool& before = pools.back();
      const float weight = before.weight + last.weight;
      before.mean = (before.mean * before.weight + last.mean * last.weight) / weight;
      before.weight = weight;
      before.count += last.count;
    }
  }
  int i = 0;
  for (const Pool& pool : pools)
    for (int k = 0; k < pool.count; ++k) values[i++] = pool.mean;
}

}  // namespace

NetworkOdds NetworkOdds::learn(std::span<const NetworkSight> sights) {
  std::array<float, kSteps> sherd{}, bare{};
  float all_sherd = 0, all_bare = 0;
  std::array<int, 256> steps{};
  for (int says = 0; says < 256; ++says) steps[says] = stepOf(says);
  for (const NetworkSight& sight : sights)
    for (int y = 0; y < sight.says.rows; ++y)
      for (int x = 0; x < sight.says.cols; ++x) {
        const int step = steps[sight.says(y, x)];
        sherd[step] += sight.inside(y, x), all_sherd += sight.inside(y, x);
        bare[step] += sight.clear(y, x), all_bare += sight.clear(y, x);
      }
  NetworkOdds odds;
  if (all_sherd < kFewestSure || all_bare < kFewestSure) return odds;
  std::array<float, kSteps> ratio{}, weights{};
  for (int i = 0; i < kSteps; ++i) {
    const float s = sherd[i] / all_sherd + kWrongShare, b = bare[i] / all_bare + kWrongShare;
    ratio[i] = std::log(s / b), weights[i] = s + b;
  }
  makeRising(ratio, weights);
  for (int says = 0; says < 256; ++says) {
    const float learnt = std::clamp(ratio[steps[says]], -kMostWorth, kMostWorth);
    const float own = logit(says);
    if (learnt * own > 0)
      odds.odds_[says] = std::copysign(std::min(std::abs(learnt), std::abs(own)), own);
  }
  return odds;
}

cv::Mat1f NetworkOdds::of(const cv::Mat1b& says, cv::Size size) const {
  cv::Mat1f own(says.size()), scaled;
  std::transform(says.begin(), says.end(), own.begin(), [this](uchar v) { return of(v); });
  cv::resize(own, scaled, size, 0, 0, cv::INTER_LINEAR);
  return scaled;
}

}  // namespace ostraka::segmentation
