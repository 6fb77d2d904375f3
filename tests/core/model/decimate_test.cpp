#include <gtest/gtest.h>

#include "model/contouring.h"
#include "model/model.h"
#include "shapes.h"

namespace ostraka::model {
namespace {

TriangleMesh fineBall(float radius) {
  Grid grid;
  grid.cell_mm = 0.5f;
  grid.size = {48, 48, 48};
  for (int z = 0; z < 48; ++z)
    for (int y = 0; y < 48; ++y)
      for (int x = 0; x < 48; ++x)
        grid.values.push_back((grid.node(x, y, z) - Eigen::Vector3f(11.6f, 11.7f, 11.8f)).norm() -
                              radius);
  TriangleMesh mesh = contour(grid);
  mesh.seen.assign(mesh.vertices.size(), 1);
  mesh.colors.assign(mesh.vertices.size(), Color{9, 8, 7});
  return mesh;
}

TEST(Decimation, ABallKeepsItsShapeWithATenthOfTheFaces) {
  const TriangleMesh ball = fineBall(9);
  const auto fewer = decimated(ball, 0.03);
  ASSERT_TRUE(fewer.has_value());
  Message why;
  EXPECT_TRUE(isClosedManifold(*fewer, &why)) << why;
  EXPECT_LT(fewer->triangles.size(), ball.triangles.size() / 10);
  EXPECT_NEAR(measure(*fewer).volume_mm3, measure(ball).volume_mm3,
              0.01 * measure(ball).volume_mm3);
  for (const Eigen::Vector3f& v : fewer->vertices)
    ASSERT_NEAR((v - Eigen::Vector3f(11.6f, 11.7f, 11.8f)).norm(), 9, 0.06);  // twice the bound
  EXPECT_EQ(fewer->seen.size(), fewer->vertices.size());
  EXPECT_EQ(fewer->colors.at(0), (Color{9, 8, 7}));
}

TEST(Decimation, ASmallMeshStaysClosedHoweverCoarse) {
  const auto fewer = decimated(fineBall(1.5f), 5);
  ASSERT_TRUE(fewer.has_value());
  EXPECT_TRUE(isClosedManifold(*fewer));
}

TEST(Decimation, OpenMeshesAndSillyBoundsAreRefused) {
  TriangleMesh open = boxMesh({1, 1, 1});
  open.triangles.pop_back();
  EXPECT_EQ(decimated(open, 0.1).error().code, ErrorCode::UnusableInput);
  EXPECT_EQ(decimated(boxMesh({1, 1, 1}), 0).error().code, ErrorCode::UnusableInput);
}

}  // namespace
}  // namespace ostraka::model
