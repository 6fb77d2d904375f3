#pragma once
#include <Eigen/Core>
#include <span>
#include <vector>

#include "base/result.h"

namespace ostraka::pairing {

/// Indices of the points on the outer border of the alpha shape of the largest connected group,
/// counter-clockwise: the points that a disc of radius alpha_mm touches while it rolls around the
/// outside (Edelsbrunner, Kirkpatrick, Seidel 1983). No index follows itself; a point at a neck may
/// stand twice. Errors: NotEnough when no ring of three points is found. O(n log n + border).
Result<std::vector<int>> alphaOutline(std::span<const Eigen::Vector2d> points, double alpha_mm);

}  // namespace ostraka::pairing
