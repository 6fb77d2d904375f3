#pragma once
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "base/message.h"

namespace ostraka::mask {

/// The share of the plate away from sherds that is darker than the camera's other stops explain:
/// the shadow of a hand or a person. residual: log photograph - log bare plate; group and plate:
/// where the hull and where the plate inside the markers show, reduced by `reduction`.
double darkenedShare(const cv::Mat3f& residual, const cv::Mat1b& group, const cv::Mat1b& plate,
                     int reduction, double mm_per_pixel);

/// A photograph with such a shadow, and how much of the bare plate it covers.
struct StrangeShadow {
  std::string file;
  int percent = 0;
};

/// shadows: one or more.
Message warningOf(const std::vector<StrangeShadow>& shadows);

}  // namespace ostraka::mask
