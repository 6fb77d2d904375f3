#pragma once
#include <array>
#include <opencv2/core/mat.hpp>
#include <span>

namespace ostraka::segmentation {

/// The network's own log odds for a probability of 0..255, within +-6.9.
float networkLogOdds(int probability);

/// One photograph's part in the learning, all of one size.
struct NetworkSample {
  cv::Mat1b probability;  ///< of sherd by the network, 0..255 (sherdProbabilities)
  cv::Mat1f inside;       ///< 0..1: surely sherd, as hull::HullView has it
  cv::Mat1f clear;        ///< 0..1: surely bare plate, likewise
};

/// log P(network's probability | sherd) / P(network's probability | bare plate). It is learnt where
/// other evidence is sure in the same photographs, so that a network without any notion of these
/// things has no weight. Rises with the probability, and is no larger than its own log odds.
class NetworkOdds {
 public:
  /// No odds where too little is sure of either.
  static NetworkOdds learn(std::span<const NetworkSample> samples);
  float of(uchar probability) const { return odds_[probability]; }
  /// The odds of a photograph of this size; the probabilities may have any size.
  cv::Mat1f of(const cv::Mat1b& probability, cv::Size size) const;
  bool none() const { return odds_.front() == 0 && odds_.back() == 0; }

 private:
  std::array<float, 256> odds_{};
};

}  // namespace ostraka::segmentation
