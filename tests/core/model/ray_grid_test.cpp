#include "model/ray_grid.h"

#include <gtest/gtest.h>

#include "shapes.h"

namespace ostraka::model {
namespace {

constexpr int kTop = 3;  // the half of boxMesh's upper face that the start lies in

TEST(RayGrid, ARayLeavesABoxAtTheFaceOpposite) {
  const TriangleMesh box = boxMesh({24, 18, 5});
  const RayGrid grid(box);
  const auto through = grid.leaving({1, 2, 2.5f}, {0, 0, -1}, kTop);
  ASSERT_TRUE(through.has_value());
  EXPECT_NEAR(through->distance_mm, 5, 1e-4);
  EXPECT_TRUE(through->normal.isApprox(Eigen::Vector3f(0, 0, -1), 1e-5f));
  // 3-4-5: 5 mm down are 6.25 mm of the way, 3.75 mm aside.
  const auto aslant = grid.leaving({1, 2, 2.5f}, {0.6f, 0, -0.8f}, kTop);
  ASSERT_TRUE(aslant.has_value());
  EXPECT_NEAR(aslant->distance_mm, 6.25, 1e-4);
}

TEST(RayGrid, ARayOutwardsLeavesNothing) {
  const TriangleMesh box = boxMesh({24, 18, 5});
  EXPECT_FALSE(RayGrid(box).leaving({1, 2, 2.5f}, {0, 0, 1}, kTop).has_value());
}

}  // namespace
}  // namespace ostraka::model
