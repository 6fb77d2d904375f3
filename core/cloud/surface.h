#pragma once
#include <Eigen/Core>
#include <array>
#include <span>
#include <stop_token>
#include <vector>

#include "cloud/point_cloud.h"

namespace ostraka {

/// The point of triangle abc nearest to p (regions of Voronoi; Ericson, Real-Time Collision
/// Detection, 5.1.5).
Eigen::Vector3d closestOnTriangle(const Eigen::Vector3d& p, const Eigen::Vector3d& a,
                                  const Eigen::Vector3d& b, const Eigen::Vector3d& c);

struct SurfacePoint {
  double distance_mm = 0;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  int triangle = -1;  ///< of the mesh, or the vertex where it has none
};

/// Exact closest points of a mesh by a tree of boxes; of a mesh without triangles, of its vertices.
/// The mesh must have a vertex. Queries are const and may run on several threads.
class Surface {
 public:
  explicit Surface(const TriangleMesh& mesh);
  SurfacePoint closest(const Eigen::Vector3d& query) const;
  /// Of each query. Stopped, the rest is at distance 0.
  std::vector<SurfacePoint> closest(std::span<const Eigen::Vector3d> queries, int threads,
                                    const std::stop_token& stop = {}) const;

 private:
  struct Node {
    Eigen::Vector3d low, high;
    int first = 0, count = 0;  // of order_, for a leaf; count 0 and first = right child else
  };
  int build(int first, int count);
  void boxOf(int item, Eigen::Vector3d& low, Eigen::Vector3d& high) const;

  std::vector<Eigen::Vector3d> vertices_;
  std::vector<std::array<int, 3>> items_;  // a vertex stands for itself three times
  std::vector<int> order_;
  std::vector<Node> nodes_;
};

}  // namespace ostraka
