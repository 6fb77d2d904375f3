#pragma once
#include <filesystem>
#include <opencv2/core/mat.hpp>

#include "base/result.h"

namespace ostraka::batch {

/// The photograph as 8-bit BGR, rows x columns as stored: an EXIF orientation is not applied, since
/// intrinsics belong to the sensor. Errors: UnusableInput when the file is missing, cut off or no
/// JPEG, PNG or TIFF.
Result<cv::Mat> readPhotograph(const std::filesystem::path& file);

/// A mask or label image as 8-bit grey values, unscaled. Errors as above.
Result<cv::Mat> readMask(const std::filesystem::path& file);

}  // namespace ostraka::batch
