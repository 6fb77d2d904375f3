#pragma once
#include <opencv2/core/mat.hpp>
#include <string>
#include <string_view>

#include "base/result.h"
#include "images/decode.h"

namespace ostraka::images {

/// The first picture of a TIFF file (TIFF 6.0). AsStored: grey and RGB of 8, 16 or 32 bits
/// (integers or, of 32 bits, also real numbers) with their bits; all else as 8-bit BGR or, where it
/// is without colours, grey. Errors: UnusableInput.
Result<cv::Mat> decodeTiff(std::string_view bytes, Values values, const std::string& where);

/// A TIFF file (LZW) of 8-bit values, grey or BGR, with its resolution in pixels an inch.
std::string encodedTiff(const cv::Mat& image, double dpi);

}  // namespace ostraka::images
