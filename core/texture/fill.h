#pragma once
#include <opencv2/core/mat.hpp>

namespace ostraka::texture {

/// The page with each texel where `known` is 0 filled in from the known ones around it, smoothly:
/// what halving the page again and again brings together (pull-push, Gortler et al., SIGGRAPH
/// 1996). A page without a known texel comes back as it is.
cv::Mat3f filled(const cv::Mat3f& page, const cv::Mat1b& known);

}  // namespace ostraka::texture
