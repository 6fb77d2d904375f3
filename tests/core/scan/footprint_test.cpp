#include "scan/footprint.h"

#include <gtest/gtest.h>

namespace ostraka::scan {
namespace {

std::vector<Eigen::Vector2d> square(double low, double high) {
  std::vector<Eigen::Vector2d> points;
  for (double x = low; x <= high; x += 0.25) {
    for (double y = low; y <= high; y += 0.25) points.emplace_back(x, y);
  }
  return points;
}

TEST(Footprint, DepthIsTheDistanceToTheOutside) {
  const Footprint footprint(square(0, 20), 0.5);
  EXPECT_NEAR(footprint.depth({10, 10}), 10, 0.7);  // a cell, and 6 % of the chamfer
  EXPECT_NEAR(footprint.depth({3, 10}), 3, 0.7);
  EXPECT_EQ(footprint.depth({-0.9, 10}), 0);
}

TEST(Footprint, AHoleIsNotOutside) {
  std::vector<Eigen::Vector2d> ring;
  for (const Eigen::Vector2d& p : square(0, 20)) {
    if ((p - Eigen::Vector2d(10, 10)).norm() > 4) ring.push_back(p);
  }
  EXPECT_NEAR(Footprint(ring, 0.5).depth({10, 10}), 10, 0.7);
}

}  // namespace
}  // namespace ostraka::scan
