#pragma once
#include <opencv2/core/mat.hpp>
#include <vector>

#include "base/result.h"
#include "batch/batch.h"
#include "rig/marker_edges.h"

namespace ostraka::rig {

/// A marker of the plate in a photograph.
struct SeenMarker {
  int id = 0;
  Quad corners;      ///< pixels, OpenCV's order; integer = pixel centre
  double sd_px = 0;  ///< expected error of a coordinate
};

/// Markers of the plate in a photograph (8-bit BGR or grey), sorted by id. Markers of other ids are
/// not ours; of an id seen twice neither counts. Corners are accurate to sd_px, up to
/// an inset common to a camera. Errors: UnusableInput (dictionary).
Result<std::vector<SeenMarker>> findPlateMarkers(const cv::Mat& photograph,
                                                 const batch::Plate& plate);

}  // namespace ostraka::rig
