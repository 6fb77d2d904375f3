#pragma once
#include <opencv2/core/mat.hpp>
#include <vector>

namespace ostraka::mask {

/// How often colours occur: brightness in 18 steps of a quarter in the logarithm, two colour
/// differences in 13 steps of 0.08 (the noise of dark pixels).
class ColourHistogram {
 public:
  ColourHistogram();
  static int bin(const cv::Vec3f& log_colour);
  void add(int bin) { counts_[bin] += 1; }
  void finish();  ///< spreads counts to neighbouring bins; call before density
  float total() const { return total_; }
  float density(int bin) const;  ///< share of the samples, with a little doubt in every bin

 private:
  std::vector<float> counts_;
  float total_ = 0;
};

/// Sharpens the log odds with what the certain pixels of the same photograph teach: for each group
/// of sherds (a connected part of `allowed`), the colours of its certain sherd pixels and those of
/// the certain plate and shadow pixels around it, as histograms of brightness and two colour
/// differences. The histograms' log ratio is added, within +-2: they learn from the odds
/// themselves, so they may tip the scales but not outvote them.
void sharpenByColours(const cv::Mat3f& log_colours, const cv::Mat1b& allowed, cv::Mat1f& log_odds);

}  // namespace ostraka::mask
