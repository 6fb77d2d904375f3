#pragma once
#include <filesystem>
#include <opencv2/core/mat.hpp>

#include "base/result.h"

namespace ostraka::mask {

/// A mask that came with the photograph, as 0 or 255 (batch::readLabelMask). Missing, unreadable or
/// of another size than width x height is an error that names the file and what was expected.
Result<cv::Mat1b> readGivenMask(const std::filesystem::path& path, int width, int height);

}  // namespace ostraka::mask
