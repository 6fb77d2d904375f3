#pragma once
#include <vector>

#include "rig/camera.h"
#include "rig/rig.h"
#include "vessels/sherd.h"
#include "virtualrig/simulate.h"

namespace ostraka::virtualrig {

inline constexpr int kCameras = 3;  ///< of the rig that makeRig draws

/// Cameras and a turntable.
struct VirtualRig {
  std::vector<rig::Intrinsics> intrinsics;
  std::vector<Eigen::Isometry3d> camera_from_room;  ///< room: the plate's frame at stop 0
  std::vector<double> angles_rad;                   ///< of the plate, counter-clockwise, by stop

  int cameras() const { return static_cast<int>(intrinsics.size()); }
  Eigen::Isometry3d cameraFromPlate(int camera, int stop) const;
};
/// camera_from_room: x right, y down, z towards `target`; the room's z stays up in the picture,
/// up to the roll.
Eigen::Isometry3d lookingAt(const Eigen::Vector3d& eye, const Eigen::Vector3d& target,
                            double roll_rad);
/// Three cameras on an arc, drawn by chance around one design.
VirtualRig makeRig(int width, int stops, vessels::Random& random);
/// A calibrated rig, its pictures scaled so that the first camera's have this width.
VirtualRig asVirtual(const rig::Rig& rig, int width);

/// Twelve positions of the calibration board before a camera: near and far, tilted, into the
/// corners.
std::vector<Eigen::Isometry3d> boardPoses(const rig::Intrinsics& camera, vessels::Random& random);

/// Vessels made and broken: the batch's sherds, largest first, near-duplicates in twos; or the
/// given meshes, in their order. Errors: those of sherdOfMesh.
Result<std::vector<vessels::VirtualSherd>> makeSherds(const SimulateOptions& options);

}  // namespace ostraka::virtualrig
