#pragma once
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

namespace ostraka::mask {

/// Sherd or background for each pixel of each photograph, in the order of the photographs.
/// A mask is CV_8UC1 of its photograph's size: 0..255 = share of the pixel that a sherd covers, so
/// that >= 128 is inside and the level 127.5 is the outline to a fraction of a pixel.
struct MaskResult {
  std::vector<cv::Mat1b> masks;
  std::vector<std::string> warnings;  ///< sentences for a person; each asks for an act
};

}  // namespace ostraka::mask
