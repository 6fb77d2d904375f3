#pragma once
#include <Eigen/Geometry>
#include <filesystem>
#include <vector>

#include "base/result.h"
#include "rig/camera.h"

namespace ostraka::rig {

/// A camera that stands still beside the turntable.
struct RigCamera {
  int camera = 0;  ///< number in the batch
  Intrinsics intrinsics;
  /// x_camera = camera_from_turntable * x_turntable, mm. z of the turntable frame is the axis, up.
  Eigen::Isometry3d camera_from_turntable = Eigen::Isometry3d::Identity();
  double focal_sd_px = 0;        ///< standard deviation of fx; 0 = not known
  double intrinsics_rms_px = 0;  ///< of the board's corners; 0 = no board
  double marker_inset_px = 0;    ///< by which this camera shows black marker edges too far inside
  /// Of fx fy cx cy k1 k2 p1 p2 k3, rotation vector (rad) and translation (mm) of
  /// camera_from_turntable: 15 x 15 row by row; empty where it is not known.
  std::vector<double> covariance;
};

/// The cameras and the turntable of one laboratory: RIG.json.
struct Rig {
  std::vector<RigCamera> cameras;       ///< sorted by number
  std::vector<int> stops;               ///< numbers of the stops, ascending
  std::vector<double> stop_angles_rad;  ///< one per stop, counter-clockwise from above, first = 0
  double reprojection_rms_px = 0;

  const RigCamera* find(int camera) const;  ///< nullptr when there is none of this number
};

/// Errors: UnusableInput (not a rig, another version, a camera or a stop twice, numbers that are no
/// camera).
Result<Rig> readRig(const std::filesystem::path& file);
/// Whether writeRig may replace this file: it is not there, or holds the JSON object of a rig, of
/// any version, or only the "devices" of one. Error: UnusableInput.
Result<void> checkRigOutput(const std::filesystem::path& file);
/// What an existing file says besides (its "devices") stays as it is.
Result<void> writeRig(const std::filesystem::path& file, const Rig& rig);

}  // namespace ostraka::rig
