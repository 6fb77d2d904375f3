#pragma once
#include <opencv2/core/mat.hpp>
#include <string>
#include <string_view>

#include "base/result.h"
#include "images/decode.h"

namespace ostraka::images {

bool isPng(std::string_view bytes);

/// The picture of a PNG file (ISO/IEC 15948); the values are those of cv::imdecode. Errors:
/// UnusableInput.
Result<cv::Mat> decodePng(std::string_view bytes, Values values, const std::string& where);

/// A PNG file of 8-bit values: grey, BGR or BGRA. effort: zlib's level, 1 (fast) to 9 (small); dpi:
/// its resolution in pixels an inch (pHYs), where it has one.
std::string encodedPng(const cv::Mat& image, int effort = 3, double dpi = 0);

}  // namespace ostraka::images
