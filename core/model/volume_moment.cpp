#include "model/volume_moment.h"

#include <cmath>

namespace ostraka::model {

VolumeMoment volumeMoment(const TriangleMesh& mesh) {
  using Eigen::Vector3d;
  VolumeMoment m;
  if (mesh.vertices.empty()) return m;
  const Vector3d shift = mesh.vertices[0].cast<double>();  // near the mesh: less cancellation
  Vector3d sum = Vector3d::Zero();
  for (const auto& t : mesh.triangles) {
    const Vector3d a = mesh.vertices[t[0]].cast<double>() - shift,
                   b = mesh.vertices[t[1]].cast<double>() - shift,
                   c = mesh.vertices[t[2]].cast<double>() - shift;
    const double part = a.dot(b.cross(c)) / 6;
    m.volume_mm3 += part;
    sum += part * (a + b + c) / 4;
  }
  m.centre = std::abs(m.volume_mm3) > 1e-12 ? Vector3d(sum / m.volume_mm3 + shift) : shift;
  return m;
}

}  // namespace ostraka::model
