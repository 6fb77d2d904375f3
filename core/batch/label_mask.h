#pragma once
#include <filesystem>
#include <opencv2/core/mat.hpp>

#include "base/result.h"

namespace ostraka::batch {

/// A mask that came with a photograph, as 0 or 255: any label other than 0 is inside, of 8 or 16
/// bits (an alpha channel counts alone when there is one). In a JPEG, whose edges ring, what is
/// nearer to white than to black is. Errors:
/// UnusableInput when the file is missing, cut off or no JPEG, PNG or TIFF.
Result<cv::Mat1b> readLabelMask(const std::filesystem::path& file);

}  // namespace ostraka::batch
