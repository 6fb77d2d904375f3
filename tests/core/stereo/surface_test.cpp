#include "stereo/surface.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ostraka::stereo {
namespace {

/// Points 0.1 mm apart on z = 0.02 x^2, alternately 0.05 mm too high and too low.
std::vector<SurfacePoint> roughBowl() {
  std::vector<SurfacePoint> points;
  for (int j = -30; j <= 30; ++j)
    for (int i = -30; i <= 30; ++i) {
      SurfacePoint p;
      const float x = 0.1F * static_cast<float>(i), y = 0.1F * static_cast<float>(j);
      p.position = {x, y, 0.02F * x * x + (((i + j) & 1) != 0 ? 0.05F : -0.05F)};
      p.normal = Eigen::Vector3f(-0.04F * x, 0, 1).normalized();
      p.footprint_mm = 0.25F;
      p.confidence = 1;
      points.push_back(p);
    }
  return points;
}

TEST(Smoothed, TakesOffTheNoiseAndKeepsTheCurve) {
  const std::vector<SurfacePoint> smooth = smoothed(roughBowl(), {});
  ASSERT_GT(smooth.size(), 500U);  // 36 mm^2 in cubes of 0.21 mm
  ASSERT_LT(smooth.size(), 3000U);
  for (const SurfacePoint& p : smooth) {
    const float x = p.position.x();
    if (std::abs(x) > 2.2F || std::abs(p.position.y()) > 2.2F) continue;
    EXPECT_NEAR(p.position.z(), 0.02F * x * x, 0.015F);
    EXPECT_GT(p.normal.dot(Eigen::Vector3f(-0.04F * x, 0, 1).normalized()), 0.998F);
  }
}

TEST(Smoothed, LeavesASharpEdgeWhereItIs) {
  std::vector<SurfacePoint> points;
  for (int j = -20; j <= 20; ++j)
    for (int i = 0; i <= 30; ++i) {
      const float along = 0.1F * static_cast<float>(j), depth = 0.1F * static_cast<float>(i);
      points.push_back({{-depth, along, 0}, {0, 0, 1}, 0.25F, 1.0F, 0, 3});
      points.push_back({{0, along, -depth}, {1, 0, 0}, 0.25F, 1.0F, 0, 3});
    }
  for (const SurfacePoint& p : smoothed(points, {}))
    if (std::abs(p.position.y()) < 1.4F) {
      EXPECT_LT(std::min(std::abs(p.position.x()), std::abs(p.position.z())), 0.01F);
    }
}

}  // namespace
}  // namespace ostraka::stereo
