#pragma once
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "cloud/point_cloud.h"

namespace ostraka::model {

struct RayHit {
  float distance_mm = 0;
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();  ///< of the triangle, outward
};

/// Triangles sorted into cubes for rays through a closed mesh. Keeps a reference to the mesh.
class RayGrid {
 public:
  explicit RayGrid(const TriangleMesh& mesh);
  /// Where a ray that starts on triangle `from` and runs inward leaves the body.
  std::optional<RayHit> leaving(const Eigen::Vector3f& start, const Eigen::Vector3f& direction,
                                int from) const;

 private:
  std::optional<float> meets(int triangle, const Eigen::Vector3f& start,
                             const Eigen::Vector3f& direction) const;

  const TriangleMesh& mesh_;
  Eigen::Vector3f low_;
  float edge_;
  Eigen::Array3i size_;
  std::vector<int> start_, triangles_;
};

}  // namespace ostraka::model
