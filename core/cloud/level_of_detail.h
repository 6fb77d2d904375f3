#pragma once
#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "cloud/point_cloud.h"

namespace ostraka {

/// How far the points lie apart around each of them, mm: the edge of the square that a point has
/// for itself. Counted on a grid, so that half a million points take 0.2 s; what lies alone gets
/// the grid's edge, about three times the common spacing. Empty for an empty cloud.
std::vector<float> localSpacing(const std::vector<Eigen::Vector3f>& points);

/// At most `most` of `count` indices, rising, spread evenly over them but without a pattern. The
/// same ones on every call.
std::vector<int> sampledIndices(std::size_t count, std::size_t most);

/// At most about `most` triangles between vertices of the mesh, for drawing while it turns: the
/// vertices of each cube of a grid become the one nearest to its middle. Not closed, not manifold.
/// All of the mesh's triangles when it has no more.
std::vector<std::array<int, 3>> coarseTriangles(const TriangleMesh& mesh, std::size_t most);

}  // namespace ostraka
