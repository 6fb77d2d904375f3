#pragma once
#include <opencv2/core/mat.hpp>
#include <optional>

#include "colour/correction.h"

namespace ostraka::colour {

/// The ColorChecker Classic that lies in a photograph (8-bit BGR), found on a reduced picture by
/// OpenCV's mcc and measured on the photograph itself; of several the first that can be used
/// (correctionBy), else the one that fits best.
std::optional<Chart> findChart(const cv::Mat3b& photograph);

}  // namespace ostraka::colour
