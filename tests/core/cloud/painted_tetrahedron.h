#pragma once
#include "cloud/points_and_meshes.h"

namespace ostraka {

/// mm; with all that a mesh may have.
inline TriangleMesh paintedTetrahedron() {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {40, 0, 0}, {0, 30, 0}, {0, 0, 20}};
  mesh.normals = {{0, 0, -1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.colors = {{255, 255, 255}, {0, 0, 0}, {188, 188, 188}, {10, 10, 10}};
  mesh.seen = {1, 1, 0, 1};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  return mesh;
}

}  // namespace ostraka
