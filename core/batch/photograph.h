#pragma once
#include <array>
#include <filesystem>
#include <opencv2/core/mat.hpp>
#include <string_view>

#include "base/result.h"

namespace ostraka::batch {

/// Whether the file name has a photograph's ending (JPEG, PNG, TIFF, HEIC, in any case). Not RAW
/// files, which cameras write beside their photographs (raw_image.h).
bool hasPhotographEnding(const std::filesystem::path& file);

/// The photograph as 8-bit BGR, rows x columns as stored: an EXIF orientation is not applied, since
/// intrinsics belong to the sensor. 16 bits become 8. Errors: UnusableInput when the file is
/// missing, cut off or no JPEG, PNG, TIFF, HEIC or RAW.
Result<cv::Mat> readPhotograph(const std::filesystem::path& file);

/// The same from a file's bytes; `where` names them in errors.
Result<cv::Mat> decodePhotograph(std::string_view bytes, const std::string& where);

/// From now on OpenCV throws std::bad_alloc when there is not enough memory, instead of a
/// cv::Exception that looks like a defect or a damaged file. To be called when a program starts.
void makeOpenCvThrowBadAlloc();

/// A mask or label image as 8-bit grey values, unscaled. Errors as above.
Result<cv::Mat> readMask(const std::filesystem::path& file);

/// A picture or mask averaged down to this size; itself, shared, where it is no larger.
cv::Mat reducedTo(const cv::Mat& picture, int width, int height);

/// Grey values of an 8-bit BGR or grey photograph; the latter is shared, not copied.
cv::Mat greyOf(const cv::Mat& photograph);

/// The light that each 8-bit value of a photograph stands for, 0 to 1: the inverse of the sRGB
/// curve (IEC 61966-2-1).
const std::array<double, 256>& linearLight();

}  // namespace ostraka::batch
