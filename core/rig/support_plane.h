#pragma once
#include <Eigen/Geometry>
#include <optional>
#include <span>
#include <vector>

#include "rig/camera.h"

namespace ostraka::rig {

/// The ball that all cameras look at: a thing that filled half of the pictures would fill it.
struct Sight {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< nearest to all optical axes
  double radius = 0;
  bool sound() const { return radius > 0 && centre.allFinite(); }
};

/// Unit and frame: those of the poses. Not sound where no camera looks at a common place.
Sight commonSight(std::span<const PosedImage> images);

/// A frame of photographs by hand whose z axis points up: away from where the cameras look, and to
/// the upper edge of the pictures as people hold a camera. Its origin is commonSight's centre.
Eigen::Isometry3d uprightFrame(std::span<const PosedImage> images);

/// What things stand on where no marker tells it: a table, a cloth, a floor.
struct SupportPlane {
  Eigen::Isometry3d plane_from_world;  ///< z = 0 is the plane, the cameras are above it
  Eigen::AlignedBox2d extent;  ///< about the origin: where points of it were seen, near the sight
};

/// Among planes through sparse points near the common sight the one with the most points on it,
/// below which next to nothing lies, and above which all cameras are (RANSAC, Fischler and Bolles
/// 1981, with fixed draws). up: roughly its normal (uprightFrame); steeper planes are walls.
/// Nothing where there is none.
std::optional<SupportPlane> findSupportPlane(std::span<const PosedImage> images,
                                             const std::vector<Eigen::Vector3d>& points,
                                             const Eigen::Vector3d& up);

}  // namespace ostraka::rig
