#pragma once
#include <opencv2/core/mat.hpp>
#include <string>
#include <string_view>

#include "base/result.h"

namespace ostraka::images {

/// What a decoded image's values are. Bgr and Grey have 8 bits, whatever the file has. AsStored has
/// the file's channels (grey, BGR or BGRA; palettes become colours) and, of PNG and TIFF, its bits.
enum class Values { Bgr, Grey, AsStored };

/// The image of a JPEG, PNG, TIFF, HEIC or RAW file from its bytes, rows x columns as stored: an
/// orientation is not applied. HEIC and RAW have colours, or grey values of them. `where` is the
/// file's name, whose ending says that it is RAW. Errors: UnusableInput where the file is cut off,
/// damaged or of another kind.
Result<cv::Mat> decodeImage(std::string_view bytes, Values values, const std::string& where);

}  // namespace ostraka::images
