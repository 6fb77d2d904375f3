#pragma once
#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "calibration/bundle_adjustment.h"

namespace ostraka::calibration {

/// Pose of one photograph found from its own markers. Camera, side and stop are indices.
struct ViewPose {
  int camera = 0, side = 0, stop = 0;
  Eigen::Isometry3d camera_from_plate = Eigen::Isometry3d::Identity();
  int markers = 0;
};

/// Which cameras and stops a start could be found for.
struct RigStart {
  RigState state;
  std::vector<char> camera_posed;                  ///< by camera
  std::array<std::vector<char>, 2> stop_measured;  ///< by side and stop
};

enum class SidesShot { Both, FrontOnly };

/// First values for the adjustment, with the plate's z for the axis. With known cameras their poses
/// are kept and only angles are found. stop_numbers: the stops' numbers in the file names; angles
/// of stops that no view shows come from the other side or from equal steps. Nothing when there is
/// no view of the front or, where both sides were shot, of the back.
std::optional<RigStart> startRig(const RigState& cameras, const std::vector<ViewPose>& views,
                                 const std::vector<int>& stop_numbers, Cameras known,
                                 SidesShot sides = SidesShot::Both);

}  // namespace ostraka::calibration
