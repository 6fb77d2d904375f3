#include "drawing/walls.h"

#include <gtest/gtest.h>

namespace ostraka::drawing {
namespace {

TEST(Walls, OfATetrahedronAreNone) {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {30, 0, 0}, {0, 30, 0}, {0, 0, 30}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  const Walls walls = findWalls(mesh);
  EXPECT_TRUE(walls.points.empty()) << "no face runs opposite to another";
  EXPECT_EQ(walls.thickness_mm, 0);
}

}  // namespace
}  // namespace ostraka::drawing
