#pragma once
#include <filesystem>
#include <opencv2/core/mat.hpp>
#include <string>
#include <string_view>

#include "base/result.h"
#include "images/image_header.h"

namespace ostraka::images {

/// Is this a camera's RAW file by the ending of its name? Only the name tells many of them from a
/// TIFF image, which holds a preview first.
bool hasRawEnding(const std::filesystem::path& file);

/// Size of the picture that `decodeRaw` makes. Where the header does not state the length of the
/// sensor's values, these are unpacked to see whether the file is cut off: 0.3 s for 24 megapixels.
/// Cut off is also a file that states more than `kRawPixelsPerByte`. Error: UnusableInput.
Result<ImageSize> rawSize(std::string_view bytes, const std::string& where);

/// The developed picture as 8-bit BGR (sRGB): the camera's white balance, exposure as it was, so
/// that photographs of a series stay comparable; not turned upright. Error: UnusableInput.
Result<cv::Mat> decodeRaw(std::string_view bytes, const std::string& where);

}  // namespace ostraka::images
