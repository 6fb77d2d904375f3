#pragma once
#include <Eigen/Geometry>
#include <span>
#include <vector>

#include "registration/evidence.h"

namespace ostraka::registration {

struct OutlineOptions {
  double cell_mm = 0.25;     ///< half a scan spacing and more; the outline itself is sub-cell
  double blur_mm = 0.6;      ///< one to two scan spacings: single points do not shape it
  double reach_mm = 2.0;     ///< outlines farther apart show different things
  double correlation_mm = 2.0;  ///< neighbours along the outline err together this far
};

/// The outer border of points seen along `up`: where the blurred picture of covered cells falls
/// through a half. Points lie in the plane through the origin of the frame, mm.
struct Outline {
  std::vector<Eigen::Vector2d> points, normals;  ///< outward normals, unit
};
Outline outlineOf(std::span<const Eigen::Vector2f> plan, double spacing_mm,
                  const OutlineOptions& options);

/// Both sides of a sherd end, seen along one direction, at the same outermost line, however little
/// of the strip each of them shows. Says nothing of height. sigma_mm comes from the misfit itself.
struct OutlineFit {
  Evidence evidence;
  double sigma_mm = 0;
  int pairs = 0;
};
OutlineFit fitOutlines(std::span<const Eigen::Vector3f> front, std::span<const Eigen::Vector3f> back,
                       double spacing_mm, const Eigen::Isometry3d& front_from_back,
                       const Eigen::Vector3d& up, const Eigen::Vector3d& pivot,
                       const OutlineOptions& options);

}  // namespace ostraka::registration
