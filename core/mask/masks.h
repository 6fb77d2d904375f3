#pragma once
#include <opencv2/core/mat.hpp>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "rig/camera.h"

namespace ostraka::mask {

/// Sherd or background for each pixel of each photograph, in the order of the photographs.
/// A mask is CV_8UC1 of its photograph's size: 0..255 = share of the pixel that a sherd covers, so
/// that >= 128 is inside and the level 127.5 is the outline to a fraction of a pixel.
struct MaskResult {
  std::vector<cv::Mat1b> masks;
  std::vector<Message> warnings;  ///< sentences for a person; each asks for an act
};

/// That each photograph (CV_8UC3) has a pose and the size that its camera says, and that there are
/// three. too_few: the sentence of NotEnough. Errors: UnusableInput, NotEnough.
Result<void> checkViews(std::span<const rig::PosedImage> images,
                        std::span<const cv::Mat> photographs, const Message& too_few);

Error noSherdFound();  ///< NotEnough: of a plate that looks bare

}  // namespace ostraka::mask
