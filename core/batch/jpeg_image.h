#pragma once
#include <opencv2/core/mat.hpp>
#include <string>
#include <string_view>

#include "base/result.h"
#include "batch/image_header.h"

namespace ostraka::batch {

bool isJpeg(std::string_view bytes);

/// A JPEG image of this size (imageSize) as stored: 8-bit BGR, or grey with one channel; the values
/// are those of cv::imdecode. Errors: UnusableInput, also if picture data is lost in the middle
/// of the file, which OpenCV silently fills in.
Result<cv::Mat> decodeJpeg(std::string_view bytes, const ImageSize& size, int channels,
                           const std::string& where);

}  // namespace ostraka::batch
