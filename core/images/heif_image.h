#pragma once
#include <opencv2/core/mat.hpp>
#include <string>
#include <string_view>

#include "base/result.h"
#include "images/image_header.h"

namespace ostraka::images {

/// Whether these are the bytes of a HEIF image coded with HEVC, as telephones write (.heic, .heif).
bool isHeif(std::string_view bytes);

/// Size of the main image as stored, before the rotation that the file asks for; checks that each
/// box is within the file, and that images put together from others (ISO/IEC 23008-12) end, are
/// within `kHeifParts`, `kHeifLevels` and the size of an image, and no overlays. Error:
/// UnusableInput.
Result<ImageSize> heifSize(std::string_view bytes, const std::string& where);

/// The main image as 8-bit BGR, as stored; the same checks. Error: UnusableInput.
Result<cv::Mat> decodeHeif(std::string_view bytes, const std::string& where);

/// The EXIF block as a TIFF's bytes; empty when there is none.
std::string heifExif(std::string_view bytes);

}  // namespace ostraka::images
