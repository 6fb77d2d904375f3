#include <meshoptimizer.h>

#include <algorithm>

#include "model/model.h"

namespace ostraka::model {
namespace {

// The mesh with fewer triangles, its unused vertices left out.
TriangleMesh simplified(const TriangleMesh& mesh, float relative_error) {
  std::vector<unsigned> indices;
  indices.reserve(mesh.triangles.size() * 3);
  for (const auto& t : mesh.triangles)
    for (const int v : t) indices.push_back(static_cast<unsigned>(v));
  std::vector<unsigned> fewer(indices.size());
  const std::size_t n = meshopt_simplify(fewer.data(), indices.data(), indices.size(),
                                         mesh.vertices[0].data(), mesh.vertices.size(),
                                         sizeof(Eigen::Vector3f), 12, relative_error, 0, nullptr);
  TriangleMesh out;
  std::vector<int> number(mesh.vertices.size(), -1);
  for (std::size_t i = 0; i < n; i += 3) {
    std::array<int, 3> t;
    for (std::size_t k = 0; k < 3; ++k) {
      const unsigned v = fewer[i + k];
      if (number[v] < 0) {
        number[v] = static_cast<int>(out.vertices.size());
        out.vertices.push_back(mesh.vertices[v]);
        if (!mesh.colors.empty()) out.colors.push_back(mesh.colors[v]);
        if (!mesh.seen.empty()) out.seen.push_back(mesh.seen[v]);
      }
      t[k] = number[v];
    }
    out.triangles.push_back(t);
  }
  if (!mesh.normals.empty()) out.normals = vertexNormals(out);
  return out;
}

}  // namespace

Result<TriangleMesh> decimated(const TriangleMesh& mesh, double max_deviation_mm) {
  std::string why;
  if (!isClosedManifold(mesh, &why))
    return Error{ErrorCode::UnusableInput, "Only a closed mesh can be thinned out. " + why, {}};
  if (!(max_deviation_mm > 0))
    return Error{
        ErrorCode::UnusableInput, "The deviation of a thinner mesh must be above 0 mm.", {}};
  const float scale =
      meshopt_simplifyScale(mesh.vertices[0].data(), mesh.vertices.size(), sizeof(Eigen::Vector3f));
  // Collapses may pinch two sheets together; a smaller error leaves them apart.
  for (double error = max_deviation_mm; error > 0.05 * max_deviation_mm; error *= 0.5) {
    TriangleMesh fewer = simplified(mesh, static_cast<float>(error) / scale);
    if (isClosedManifold(fewer)) return fewer;
  }
  return mesh;
}

}  // namespace ostraka::model
