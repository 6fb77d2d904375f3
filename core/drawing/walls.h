#pragma once
#include <Eigen/Core>
#include <vector>

#include "cloud/point_cloud.h"

namespace ostraka::drawing {

/// A place on one of the two faces of the wall, about one per mm^2.
struct WallPoint {
  Eigen::Vector3d p, normal;
  double thickness_mm = 0;
  int face = 0;  ///< 0 or 1: the two sides of the wall; no meaning beyond telling them apart
};

struct Walls {
  TriangleMesh smooth;  ///< the mesh with noise below 1 mm taken off, with normals
  std::vector<WallPoint> points;
  double thickness_mm = 0;  ///< median
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  Eigen::Matrix3d axes =
      Eigen::Matrix3d::Identity();  ///< columns: longest, middle, across the wall
};

/// The wall's faces: where a ray against the normal leaves through a face that runs opposite, at
/// about the usual thickness. Breaks, lips and knobs are none. mesh: closed, outward.
Walls findWalls(const TriangleMesh& mesh);

}  // namespace ostraka::drawing
