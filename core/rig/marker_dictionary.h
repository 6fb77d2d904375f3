#pragma once
#include <opencv2/aruco.hpp>
#include <string>

#include "base/result.h"

namespace ostraka::rig {

/// OpenCV's predefined dictionary by its name, as DICT_4X4_100. Errors: UnusableInput.
Result<cv::Ptr<cv::aruco::Dictionary>> markerDictionary(const std::string& name);

}  // namespace ostraka::rig
