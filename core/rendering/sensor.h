#pragma once
#include <vector>

#include "rendering/photograph.h"

namespace ostraka::rendering {

/// Automatic exposure and white balance. Returns the gain of exposure; 1 without exposure_aim.
double expose(std::vector<float>& linear, int width, int height, const Sensor& sensor);
/// Light to picture: vignetting, motion, blur, shot and read noise, sRGB,
/// sharpening.
/// linear: width x height x 3, red green blue, 1 = full scale; used up.
cv::Mat develop(std::vector<float>& linear, int width, int height, const Sensor& sensor,
                std::uint64_t seed);

}  // namespace ostraka::rendering
