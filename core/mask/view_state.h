#pragma once
#include <opencv2/core/mat.hpp>

#include "hull/hull.h"

namespace ostraka::mask {

/// What maskByPlate keeps of each photograph between the two passes, small enough for a whole side.
struct ViewState {
  cv::Mat3f residual;  ///< half the memory would do; 23 MB at 1600 x 1200
  cv::Mat1f log_odds;
  cv::Mat1f height_odds;  ///< half size, see weighHeights
  hull::HullView hull;
  cv::Mat1b group;    ///< reduced: which group's hull shows
  cv::Mat1f depth;    ///< reduced: mm of hull behind it
  cv::Mat1f below;    ///< reduced: voxels from the floor up to the hull that it shows
  cv::Mat1b allowed;  ///< where a sherd may be
  cv::Mat1b plate;    ///< reduced: the plate inside the markers
};

}  // namespace ostraka::mask
