#pragma once
#include <vector>

#include "virtualrig/photograph.h"

namespace ostraka::virtualrig {

/// Light to picture: vignetting, blur, shot and read noise, sRGB.
/// linear: width x height x 3, red green blue, 1 = full scale; used up.
cv::Mat develop(std::vector<float>& linear, int width, int height, const Sensor& sensor,
                std::uint64_t seed);

}  // namespace ostraka::virtualrig
