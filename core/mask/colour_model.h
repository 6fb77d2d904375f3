#pragma once
#include <opencv2/core/mat.hpp>

namespace ostraka::mask {

/// Sharpens the log odds with what the certain pixels of the same photograph teach: for each group
/// of sherds (a connected part of `allowed`), the colours of its certain sherd pixels and those of
/// the certain plate and shadow pixels around it, as histograms of brightness and two colour
/// differences. The histograms' log ratio is added, within +-2: they learn from the odds
/// themselves, so they may tip the scales but not outvote them.
void sharpenByColours(const cv::Mat3f& log_colours, const cv::Mat1b& allowed, cv::Mat1f& log_odds);

}  // namespace ostraka::mask
