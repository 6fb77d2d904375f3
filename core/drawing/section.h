#pragma once
#include <Eigen/Geometry>
#include <vector>

#include "cloud/point_cloud.h"
#include "paper/sheet.h"

namespace ostraka::drawing {

using Loop = std::vector<Eigen::Vector2d>;

/// Where the plane x = 0 cuts a closed mesh: closed loops in (y, z), mm; the body is inside by the
/// even-odd rule.
std::vector<Loop> cut(const TriangleMesh& mesh, const Eigen::Isometry3d& view_from_model);

/// Parallel lines within loops, by the even-odd rule. direction: radians from x; spacing in mm.
Shape hatched(const std::vector<Loop>& loops, double direction_rad, double spacing_mm,
              double stroke_mm);

}  // namespace ostraka::drawing
