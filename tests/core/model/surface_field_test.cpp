#include "model/surface_field.h"

#include <gtest/gtest.h>

#include "sphere.h"

namespace ostraka::model {
namespace {

class FieldOfASphere : public testing::Test {
 protected:
  static constexpr float kRadius_mm = 6;
  FieldOfASphere()
      : surfels(sphereSurfels(kRadius_mm, 3000)), grid(indicator(surfels, 0.6F, 1, {}).value()) {}
  Surfels surfels;
  Grid grid;
  const Eigen::Vector3f directions[4] = {
      {1, 0, 0}, {0, -0.6F, 0.8F}, {0.48F, 0.6F, 0.64F}, {-0.36F, 0.48F, -0.8F}};
};

TEST_F(FieldOfASphere, IsTheDistanceFromItNearItsSurface) {
  const SurfaceField field(surfels, grid);
  for (const Eigen::Vector3f& d : directions)
    for (const float off : {-0.3F, -0.1F, 0.0F, 0.1F, 0.3F}) {
      const FieldSample sample = field.sample((kRadius_mm + off) * d);
      EXPECT_NEAR(sample.distance, off, 0.015) << d.transpose() << ", " << off;
      EXPECT_GT(sample.gradient.dot(d), 0.999) << d.transpose() << ", " << off;
      EXPECT_NEAR(sample.gradient.norm(), 1, 1e-4);
      EXPECT_GT(sample.support, 0.5);
    }
}

TEST_F(FieldOfASphere, ComesFromTheIndicatorWhereNoSurfelIsNear) {
  const SurfaceField field(surfels, grid);
  for (const Eigen::Vector3f& d : directions) {
    const FieldSample inside = field.sample(2 * d), outside = field.sample(9 * d);
    EXPECT_EQ(inside.support, 0);
    EXPECT_TRUE(inside.gradient.isZero());
    EXPECT_LT(inside.distance, 0);
    EXPECT_GT(outside.distance, 0);
    EXPECT_EQ(outside.distance, field.farDistance(9 * d));
  }
}

// What was not seen is closed: the upper half alone has a side to everything.
TEST_F(FieldOfASphere, IsOfOneSideAllTheWayThroughAHole) {
  std::vector<int> kept;
  for (std::size_t i = 0; i < surfels.size(); ++i)
    if (surfels.points[i].z() < 5.5F) kept.push_back(static_cast<int>(i));
  surfels.keep(kept);
  grid = indicator(surfels, 0.6F, 1, {}).value();
  const SurfaceField field(surfels, grid);
  float last = -1;
  int crossings = 0;
  for (float z = 0; z < 9; z += 0.05F) {
    const float now = field.sample({0, 0, z}).distance;
    crossings += (now > 0) != (last > 0);
    last = now;
  }
  EXPECT_EQ(crossings, 1);
  EXPECT_GT(last, 0);
}

// Two planes that meet at a right angle: their distance ends at the edge, where a mean of both
// would round it off by a good part of the spacing.
TEST(FieldAtACrease, KeepsTheEdgeSharp) {
  Surfels s;
  const float step = 0.3F;
  for (float u = 0.15F; u < 6; u += step)
    for (float v = -3; v < 3; v += step) {
      s.points.emplace_back(-u, v, 0);  // the top face of a body that fills x < 0, z < 0
      s.normals.emplace_back(0, 0, 1);
      s.points.emplace_back(0, v, -u);
      s.normals.emplace_back(1, 0, 0);
    }
  s.noise.assign(s.points.size(), 0.01F);
  s.confidence.assign(s.points.size(), 1);
  s.area.assign(s.points.size(), step * step);
  s.spacing_mm = step;
  const Grid grid = indicator(s, 0.6F, 1, {}).value();
  const SurfaceField field(s, grid);
  EXPECT_NEAR(field.sample({-0.3F, 0, 0}).distance, 0, 0.03);
  EXPECT_NEAR(field.sample({-0.2F, 0, 0.2F}).distance, 0.2, 0.04);
  EXPECT_NEAR(field.sample({0.2F, 0, -0.2F}).distance, 0.2, 0.04);
  EXPECT_LT(field.sample({-0.15F, 0, -0.15F}).distance, -0.08);
  EXPECT_GT(field.sample({0.15F, 0, 0.15F}).distance, 0.08);
}

}  // namespace
}  // namespace ostraka::model
