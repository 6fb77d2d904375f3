#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "cloud/point_cloud.h"

namespace ostraka::scan {

struct FractureOptions {
  Eigen::Vector3d up = Eigen::Vector3d::Zero();  ///< unit; zero = take estimateUp
  double steep_rad =
      0.80;              ///< 46 degrees: break faces run at 60-90, vessel walls below 40 as a rule
  double edge_mm = 1.0;  ///< always fracture: this close to the outline seen along up
  double reach_mm = 12.0;  ///< steep points further inside belong to the vessel's shape; walls are
                           ///< 3-10 mm thick, and an oblique break is as wide as the wall is thick
};

/// Per point 1 on the strip of broken edge, else 0. A scan alone tells it: the point's normal,
/// averaged over its neighbours, is steep against up, near the outline seen along up; or the point
/// lies at that outline. Normals are required; without them all is 0. O(n log n).
std::vector<std::uint8_t> findFracture(const PointCloud& cloud, const FractureOptions& options);

/// The direction towards the viewer, unit: the axis of least spread (of the points thinned, so that
/// density does not count), with the sign of the mean normal. UnitZ for fewer than 3 points.
Eigen::Vector3d estimateUp(const PointCloud& cloud);

}  // namespace ostraka::scan
