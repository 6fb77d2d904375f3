#pragma once
#include <opencv2/core.hpp>

namespace ostraka::stereo {

/// 255 where a photograph without a mask may show the object, for an object that is lit before a
/// dark background; everything when the picture's border is not dark. Generous: shadows on the
/// object and a pixel around it are kept, for a mask that cuts into the object does harm and one
/// that is too wide only costs time. photograph: CV_8UC3.
cv::Mat1b possibleObject(const cv::Mat& photograph);

}  // namespace ostraka::stereo
