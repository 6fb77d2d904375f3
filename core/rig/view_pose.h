#pragma once
#include <optional>
#include <vector>

#include "batch/batch.h"
#include "rig/camera.h"
#include "rig/plate_markers.h"

namespace ostraka::rig {

/// A marker of a photograph together with where it lies on the plate.
struct PlacedMarker {
  SeenMarker seen;
  std::size_t plate_index = 0;             ///< into Plate::markers
  std::array<Eigen::Vector3d, 4> corners;  ///< plate frame, mm
};

std::vector<PlacedMarker> placed(const std::vector<SeenMarker>& seen, const batch::Plate& plate);

/// The plate's pose from the markers of one photograph, and the markers that agree with it: a
/// foreign pattern read as one of ours lies elsewhere than the others say.
struct PoseFromMarkers {
  Eigen::Isometry3d camera_from_plate = Eigen::Isometry3d::Identity();
  std::vector<char> agrees;  ///< one per marker
};

/// Nothing with fewer than two markers that agree (one marker's tilt is ambiguous).
std::optional<PoseFromMarkers> poseFromMarkers(const std::vector<PlacedMarker>& markers,
                                               const Intrinsics& intrinsics);

}  // namespace ostraka::rig
