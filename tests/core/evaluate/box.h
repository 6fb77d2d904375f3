#pragma once
#include <array>

#include "cloud/point_cloud.h"

namespace ostraka::evaluate {

/// A closed box from the origin to (x, y, z), outward triangles, each side cut into n x n squares.
inline TriangleMesh boxMesh(float x, float y, float z, int n = 1) {
  TriangleMesh mesh;
  const Eigen::Vector3f size(x, y, z);
  for (int axis = 0; axis < 3; ++axis)
    for (const bool far_side : {false, true}) {
      const int base = static_cast<int>(mesh.vertices.size());
      for (int i = 0; i <= n; ++i)
        for (int j = 0; j <= n; ++j) {
          Eigen::Vector3f p;
          p[axis] = far_side ? 1.0f : 0.0f;
          p[(axis + 1) % 3] = static_cast<float>(i) / static_cast<float>(n);
          p[(axis + 2) % 3] = static_cast<float>(j) / static_cast<float>(n);
          mesh.vertices.push_back(p.cwiseProduct(size));
        }
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
          const int a = base + i * (n + 1) + j, b = a + n + 1, c = b + 1, d = a + 1;
          if (far_side) {
            mesh.triangles.push_back({a, b, c});
            mesh.triangles.push_back({a, c, d});
          } else {
            mesh.triangles.push_back({a, c, b});
            mesh.triangles.push_back({a, d, c});
          }
        }
    }
  return mesh;
}

}  // namespace ostraka::evaluate
