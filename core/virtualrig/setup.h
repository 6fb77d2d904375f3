#pragma once
#include <array>
#include <vector>

#include "rig/camera.h"
#include "virtualrig/sherd.h"
#include "virtualrig/simulate.h"

namespace ostraka::virtualrig {

inline constexpr int kCameras = 3;

/// Three cameras on an arc and a turntable, drawn by chance around one design.
struct VirtualRig {
  std::array<rig::Intrinsics, kCameras> intrinsics;
  std::array<Eigen::Isometry3d, kCameras> camera_from_room;  ///< room: the plate's frame at stop 0
  std::vector<double> angles_rad;  ///< of the plate, counter-clockwise, by stop

  Eigen::Isometry3d cameraFromPlate(int camera, int stop) const;
};
VirtualRig makeRig(int width, int stops, Random& random);

/// Twelve positions of the calibration board before a camera: near and far, tilted, into the
/// corners.
std::vector<Eigen::Isometry3d> boardPoses(const rig::Intrinsics& camera, Random& random);

/// Vessels made and broken: the batch's sherds, largest first, look-alikes in twos.
Result<std::vector<VirtualSherd>> makeSherds(const SimulateOptions& options);

}  // namespace ostraka::virtualrig
