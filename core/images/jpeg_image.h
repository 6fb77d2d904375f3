#pragma once
#include <opencv2/core/mat.hpp>
#include <string>
#include <string_view>

#include "base/result.h"
#include "images/decode.h"
#include "images/image_header.h"

namespace ostraka::images {

bool isJpeg(std::string_view bytes);

/// A JPEG image of this size (imageSize); the values are those of cv::imdecode. Errors:
/// UnusableInput, also if picture data is lost in the middle of the file, which OpenCV silently
/// fills in.
Result<cv::Mat> decodeJpeg(std::string_view bytes, const ImageSize& size, Values values,
                           const std::string& where);

struct JpegOptions {
  int quality = 95;
  bool halved_colors = true;  ///< 4:2:0 instead of 4:4:4
  std::string exif = {};      ///< content of APP1; empty: none
};
/// A JPEG file of 8-bit values, grey or BGR.
std::string encodedJpeg(const cv::Mat& image, const JpegOptions& options = {});

}  // namespace ostraka::images
