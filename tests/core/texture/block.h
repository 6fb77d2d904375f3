#pragma once
#include <cmath>
#include <map>

#include "cloud/point_cloud.h"
#include "model/model.h"
#include "texture/atlas.h"
#include "texture/view.h"

namespace ostraka::texture {

/// A closed box about the origin in the xy plane, from z = 0 up, of squares of two triangles with
/// an edge of about cell_mm. `bend` moves each point.
template <class Bend>
TriangleMesh block(const Eigen::Vector3f& size, float cell_mm, Bend bend) {
  TriangleMesh mesh;
  std::map<std::array<long, 3>, int> there;
  const auto vertex = [&](const Eigen::Vector3f& p) {
    const std::array<long, 3> key = {std::lround(p.x() * 1000), std::lround(p.y() * 1000),
                                     std::lround(p.z() * 1000)};
    const auto [found, is_new] = there.try_emplace(key, static_cast<int>(mesh.vertices.size()));
    if (is_new) mesh.vertices.push_back(p);
    return found->second;
  };
  for (int axis = 0; axis < 3; ++axis)
    for (int end = 0; end < 2; ++end) {
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      const int nu = std::max(1, static_cast<int>(std::lround(size[u] / cell_mm)));
      const int nv = std::max(1, static_cast<int>(std::lround(size[v] / cell_mm)));
      const auto at = [&](int i, int k) {
        Eigen::Vector3f p;
        p[axis] = end == 0 ? 0 : size[axis];
        p[u] = size[u] * static_cast<float>(i) / static_cast<float>(nu);
        p[v] = size[v] * static_cast<float>(k) / static_cast<float>(nv);
        return vertex(p - Eigen::Vector3f(size.x() / 2, size.y() / 2, 0));
      };
      for (int i = 0; i < nu; ++i)
        for (int k = 0; k < nv; ++k) {
          const int a = at(i, k), b = at(i + 1, k), c = at(i + 1, k + 1), d = at(i, k + 1);
          if (end == 1)
            mesh.triangles.insert(mesh.triangles.end(), {{a, b, c}, {a, c, d}});
          else
            mesh.triangles.insert(mesh.triangles.end(), {{a, c, b}, {a, d, c}});
        }
    }
  for (Eigen::Vector3f& p : mesh.vertices) p = bend(p);
  mesh.normals = model::vertexNormals(mesh);
  return mesh;
}
inline TriangleMesh block(const Eigen::Vector3f& size, float cell_mm) {
  return block(size, cell_mm, [](const Eigen::Vector3f& p) { return p; });
}

/// A camera of 800 x 600 pixels, focal length 1000, at `from`, that looks at `at`.
inline rig::PosedImage lookingAt(const Eigen::Vector3d& from, const Eigen::Vector3d& at) {
  rig::PosedImage image;
  image.intrinsics = {800, 600, 1000, 1000, 399.5, 299.5, {}};
  const Eigen::Vector3d z = (at - from).normalized();
  Eigen::Vector3d x = z.cross(Eigen::Vector3d::UnitZ());
  if (x.norm() < 1e-6) x = Eigen::Vector3d::UnitX();
  x.normalize();
  Eigen::Matrix3d axes;
  axes.row(0) = x;
  axes.row(1) = z.cross(x);
  axes.row(2) = z;
  image.camera_from_plate.linear() = axes;
  image.camera_from_plate.translation() = -axes * from;
  return image;
}

/// Where a texel of a chart lies on the mesh, mm.
inline Eigen::Vector3d pointOf(const TriangleMesh& mesh, const Texels& texels, int x, int y) {
  const auto& t = mesh.triangles[static_cast<std::size_t>(texels.face(y, x))];
  const cv::Vec2f& w = texels.weights(y, x);
  return (w[0] * mesh.vertices[t[0]] + w[1] * mesh.vertices[t[1]] +
          (1 - w[0] - w[1]) * mesh.vertices[t[2]])
      .cast<double>();
}

}  // namespace ostraka::texture
