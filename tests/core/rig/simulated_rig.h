#pragma once
#include <cmath>
#include <random>
#include <vector>

#include "batch/batch.h"
#include "calibration/bundle_adjustment.h"
#include "rig/camera.h"

namespace ostraka::rig {

inline Eigen::Isometry3d rigid(const Eigen::Vector3d& turn, const Eigen::Vector3d& shift) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  if (turn.norm() > 0)
    pose.linear() = Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix();
  pose.translation() = shift;
  return pose;
}

/// Looks at the origin from `elevation` above the table, 600 mm away.
inline Eigen::Isometry3d lookingDown(double elevation, double azimuth) {
  const Eigen::Vector3d centre =
      600 * Eigen::Vector3d(std::cos(elevation) * std::cos(azimuth),
                            std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
  const Eigen::Vector3d z = -centre.normalized();
  const Eigen::Vector3d x = z.cross(Eigen::Vector3d::UnitZ()).normalized();
  Eigen::Isometry3d camera_from_table = Eigen::Isometry3d::Identity();
  camera_from_table.linear() << x.transpose(), z.cross(x).transpose(), z.transpose();
  camera_from_table.translation() = -camera_from_table.linear() * centre;
  return camera_from_table;
}

inline Intrinsics lens(double focal) {
  Intrinsics i;
  i.width = 1600;
  i.height = 1200;
  i.fx = i.fy = focal;
  i.cx = 803;
  i.cy = 596;
  i.distortion = {{-0.06, 0.02, 0.0003, -0.0002, 0}};
  return i;
}

/// A ring of markers of 24 mm, 145 mm from the axis.
inline batch::Plate ring(int markers) {
  batch::Plate plate;
  plate.dictionary = "DICT_4X4_100";
  plate.diameter_mm = 330;
  for (int k = 0; k < markers; ++k) {
    const Eigen::AngleAxisd turn(2 * M_PI * k / markers, Eigen::Vector3d::UnitZ());
    batch::Marker marker;
    marker.id = k;
    marker.corners = {turn * Eigen::Vector3d(157, 12, 0), turn * Eigen::Vector3d(157, -12, 0),
                      turn * Eigen::Vector3d(133, -12, 0), turn * Eigen::Vector3d(133, 12, 0)};
    plate.markers.push_back(marker);
  }
  return plate;
}

/// Two cameras, eight stops of 45 degrees, the plate tilted a little and nudged at the flip.
inline calibration::RigState trueRig() {
  calibration::RigState state;
  state.cameras.resize(2);
  state.cameras[0].intrinsics = lens(2600);
  state.cameras[0].camera_from_turntable = lookingDown(0.5, 0.1);
  state.cameras[1].intrinsics = lens(2500);
  state.cameras[1].camera_from_turntable = lookingDown(1.0, -0.3);
  for (int side = 0; side < 2; ++side)
    for (int stop = 0; stop < 8; ++stop) state.angles_rad[side].push_back(stop * M_PI / 4);
  state.turntable_from_plate[0] = rigid({0.002, -0.003, 0}, {0.4, -0.3, 0});
  state.turntable_from_plate[1] = rigid({0.001, -0.002, 0.3}, {1.0, 0.5, 0.1});
  return state;
}

/// Every corner in every view, with noise of the given standard deviation.
inline std::vector<calibration::PlateCorner> cornersSeen(const calibration::RigState& truth,
                                                         const batch::Plate& plate,
                                                         double noise_px) {
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0, 1);
  std::vector<calibration::PlateCorner> corners;
  for (int c = 0; c < static_cast<int>(truth.cameras.size()); ++c)
    for (int side = 0; side < 2; ++side)
      for (int stop = 0; stop < 8; ++stop)
        for (int k = 0; k < static_cast<int>(plate.markers.size()) * 4; ++k) {
          const Eigen::Vector3d& p = plate.markers[k / 4].corners[k % 4];
          const Eigen::Vector3d x = truth.cameraFromPlate(c, side, stop) * p;
          const Eigen::Vector2d pixel = truth.cameras[c].intrinsics.project(x) +
                                        noise_px * Eigen::Vector2d(noise(random), noise(random));
          corners.push_back({c, side, stop, k, p, pixel, {0, 0}, 0.05});
        }
  return corners;
}

}  // namespace ostraka::rig
