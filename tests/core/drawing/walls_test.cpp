#include "drawing/walls.h"

#include <gtest/gtest.h>

#include <array>

#include "tests/core/drawing/wall_piece.h"

namespace ostraka::drawing {
namespace {

TEST(Walls, OfAPieceOfACylinderAreItsTwoFaces) {
  const Walls walls = findWalls(wallPiece(true));
  EXPECT_NEAR(walls.thickness_mm, 6, 0.1);
  // From here the wall stands across x, its axis of least spread.
  EXPECT_GT(std::abs(walls.axes.col(2).x()), 0.98);
  EXPECT_NEAR(walls.axes.determinant(), 1, 1e-9);
  std::array<int, 2> counts{};
  std::array<double, 2> radii{};
  for (const WallPoint& point : walls.points) {
    const double radius = point.p.head<2>().norm();
    EXPECT_NEAR(point.thickness_mm, 6, 1);
    EXPECT_NEAR(std::abs(radius - 57), 3, 1) << "not on a break or the lip";
    // Outside the normal points away from the axis, inside to it.
    EXPECT_GT(point.normal.head<2>().dot(point.p.head<2>()) * (radius - 57), 0);
    ++counts.at(static_cast<std::size_t>(point.face));
    radii.at(static_cast<std::size_t>(point.face)) += radius;
  }
  // One for each square millimetre: 60 x 40 outside, 54 x 40 inside, less at their ends.
  const std::size_t outside = radii[0] / counts[0] > 57 ? 0 : 1;
  EXPECT_NEAR(counts.at(outside), 2400, 600);
  EXPECT_NEAR(counts.at(1 - outside), 2160, 600);
  EXPECT_NEAR(radii.at(outside) / counts.at(outside), 60, 0.3);
  EXPECT_NEAR(radii.at(1 - outside) / counts.at(1 - outside), 54, 0.3);
}

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
