#pragma once
#include <array>
#include <opencv2/core/mat.hpp>
#include <span>

namespace ostraka::segmentation {

/// What one photograph tells of the network's word, all of one size.
struct NetworkSight {
  cv::Mat1b says;    ///< probability of sherd, 0..255 (maskByShippedNetwork)
  cv::Mat1f inside;  ///< 0..1: surely sherd, as hull::HullView has it
  cv::Mat1f clear;   ///< 0..1: surely bare plate, likewise
};

/// log P(what the network says | sherd) / P(what it says | bare plate), by what it says. It is
/// learnt from what other evidence is sure of in the same photographs, so that a network counts for
/// as much as it is worth there: nothing, where it has never seen such things. Never falls with the
/// network's probability.
class NetworkOdds {
 public:
  /// No odds where too little is sure of either.
  static NetworkOdds learn(std::span<const NetworkSight> sights);
  float of(uchar says) const { return odds_[says]; }
  /// The odds of a photograph of this size.
  cv::Mat1f of(const cv::Mat1b& says, cv::Size size) const;

 private:
  std::array<float, 256> odds_{};
};

}  // namespace ostraka::segmentation
