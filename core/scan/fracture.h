#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "cloud/point_cloud.h"

namespace ostraka::scan {

/// Per point 1 on the strip of broken edge, else 0. A scan alone tells it: the point's normal,
/// averaged over its neighbours, is steep against up, near the outline seen along up; or the point
/// lies at that outline. up: unit, towards the viewer. Normals are required; without them all is 0.
/// O(n log n).
std::vector<std::uint8_t> findFracture(const PointCloud& cloud, const Eigen::Vector3d& up);

/// The direction towards the viewer, unit: the axis of least spread (of the points thinned, so that
/// density does not count), with the sign of the mean normal. UnitZ for fewer than 3 points.
Eigen::Vector3d estimateUp(const PointCloud& cloud);

}  // namespace ostraka::scan
