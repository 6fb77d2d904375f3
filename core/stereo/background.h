#pragma once
#include <opencv2/core.hpp>

namespace ostraka::stereo {

/// 255 where a photograph without a mask may show the object, for an object that is lit before a
/// dark background; everything when the picture's border is not dark. Generous: shadows on the
/// object and a pixel around it are kept, for a mask that cuts into the object does harm and one
/// that is too wide only costs time. photograph: CV_8UC3.
cv::Mat1b possibleObject(const cv::Mat& photograph);

/// Whether a mask leaves nothing out.
bool isEverything(const cv::Mat1b& mask);

/// The largest 4-connected body of a mask (inside is at least 128), with its soft edge and without
/// its holes: spots elsewhere are surroundings of the object's colours, and holes are places on it
/// of its surroundings' colours, which would cost surface. 0 everywhere where there is no body.
cv::Mat1b wholeBody(const cv::Mat1b& mask);

}  // namespace ostraka::stereo
