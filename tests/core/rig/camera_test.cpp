#include "rig/camera.h"

#include <gtest/gtest.h>

#include "simulated_rig.h"

namespace ostraka::rig {
namespace {

TEST(Intrinsics, ProjectsByHandComputedNumbers) {
  Intrinsics i;
  i.fx = 1000;
  i.fy = 900;
  i.cx = 320;
  i.cy = 240;
  i.distortion = {0.1, 0, 0.01, 0.02, 0};
  // x = 0.2, y = 0.1, r2 = 0.05, radial 1.005; tangential x: 2*.01*.02 + .02*(.05+.08) = 0.003,
  // y: .01*(.05+.02) + 2*.02*.02 = 0.0015.
  const Eigen::Vector2d p = i.project({2, 1, 10});
  EXPECT_NEAR(p.x(), 1000 * (0.2 * 1.005 + 0.003) + 320, 1e-9);
  EXPECT_NEAR(p.y(), 900 * (0.1 * 1.005 + 0.0015) + 240, 1e-9);
}

TEST(Intrinsics, UnprojectUndoesProject) {
  const Intrinsics i = lens(2600);
  for (double x = -0.3; x <= 0.3; x += 0.1)
    for (double y = -0.2; y <= 0.2; y += 0.1)
      EXPECT_LT((i.unproject(i.project({x, y, 1})) - Eigen::Vector2d(x, y)).norm(), 1e-9);
}

}  // namespace
}  // namespace ostraka::rig
