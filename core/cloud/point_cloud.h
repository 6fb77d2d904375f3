#pragma once
#include <Eigen/Geometry>
#include <vector>

#include "cloud/points_and_meshes.h"

namespace ostraka {

/// For maps by the cells of a grid.
struct CellHash {
  std::size_t operator()(const Eigen::Vector3i& k) const {
    return static_cast<std::size_t>(k.x()) * 73856093u ^
           static_cast<std::size_t>(k.y()) * 19349663u ^
           static_cast<std::size_t>(k.z()) * 83492791u;
  }
};

PointCloud transformed(const PointCloud& cloud, const Eigen::Isometry3d& target_from_source);
TriangleMesh transformed(const TriangleMesh& mesh, const Eigen::Isometry3d& target_from_source);
/// The points with these indices, in this order.
PointCloud subset(const PointCloud& cloud, const std::vector<int>& indices);
/// The points whose normals tell a direction, with normals of unit length; without normals where
/// none does, and where there were none as it is.
PointCloud oriented(PointCloud cloud);

/// Of points at exactly the same place the first stays, with the sum of their normals, which
/// oriented() makes unit length: meshes repeat a vertex for each face that has a normal or a
/// texture of its own, and thousands at one place take a search for neighbours the square of their
/// number.
PointCloud withoutRepeats(PointCloud cloud);
/// One point per cube of this edge: the one nearest the cube's mean, in order of first appearance.
PointCloud thinned(const PointCloud& cloud, double edge_mm);
/// Median distance from a point to its nearest neighbour, mm, over at most 2000 points; 0 when < 2.
double medianSpacing(const PointCloud& cloud);

}  // namespace ostraka
