#include "segmentation/network_odds.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace ostraka::segmentation {
namespace {

constexpr int kSteps = 12;            // of the probability, each as wide as 1 in its logit
constexpr float kMostOdds = 4;        // may outvote a doubt, not a certainty, as learnt colours
constexpr float kFewestSure = 100;    // samples of either
constexpr double kWrongShare = 2e-3;  // share of either that is wrong in the learning itself

int stepOf(int probability) {
  return std::clamp(static_cast<int>(std::floor(networkLogOdds(probability) + 0.5F * kSteps)), 0,
                    kSteps - 1);
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

float networkLogOdds(int probability) {
  const float p = std::clamp(static_cast<float>(probability) / 255, 1e-3F, 1 - 1e-3F);
  return std::log(p / (1 - p));
}

NetworkOdds NetworkOdds::learn(std::span<const NetworkSample> samples) {
  std::array<double, kSteps> sherd{}, bare{};
  double all_sherd = 0, all_bare = 0;
  std::array<int, 256> steps{};
  for (int probability = 0; probability < 256; ++probability)
    steps[probability] = stepOf(probability);
  for (const NetworkSample& sample : samples)
    for (int y = 0; y < sample.probability.rows; ++y)
      for (int x = 0; x < sample.probability.cols; ++x) {
        const int step = steps[sample.probability(y, x)];
        sherd[step] += sample.inside(y, x), all_sherd += sample.inside(y, x);
        bare[step] += sample.clear(y, x), all_bare += sample.clear(y, x);
      }
  NetworkOdds odds;
  if (all_sherd < kFewestSure || all_bare < kFewestSure) return odds;
  std::array<float, kSteps> ratio{}, weights{};
  for (int i = 0; i < kSteps; ++i) {
    const auto s = static_cast<float>(sherd[i] / all_sherd + kWrongShare),
               b = static_cast<float>(bare[i] / all_bare + kWrongShare);
    ratio[i] = std::log(s / b), weights[i] = s + b;
  }
  makeRising(ratio, weights);
  for (int probability = 0; probability < 256; ++probability) {
    const float learnt = std::clamp(ratio[steps[probability]], -kMostOdds, kMostOdds);
    const float own = networkLogOdds(probability);
    if (learnt * own > 0)
      odds.odds_[probability] = std::copysign(std::min(std::abs(learnt), std::abs(own)), own);
  }
  return odds;
}

cv::Mat1f NetworkOdds::of(const cv::Mat1b& probability, cv::Size size) const {
  cv::Mat1f own(probability.size()), scaled;
  std::transform(probability.begin(), probability.end(), own.begin(),
                 [this](uchar v) { return of(v); });
  cv::resize(own, scaled, size, 0, 0, cv::INTER_LINEAR);
  return scaled;
}

}  // namespace ostraka::segmentation
