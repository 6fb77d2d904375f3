#include "scan/touching.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scan/split.h"
#include "slabs.h"

namespace ostraka::scan {
namespace {

std::size_t sherdsIn(const PointCloud& cloud) {
  QuietProgress quiet;
  const auto found = splitScans(cloud, batch::Side::Front, {}, quiet);
  return found ? found->scans.size() : 0;
}

/// A sheet of 0.5 mm spacing between x0, x1, y0, y1 whose height is z(x), with walls at both ends.
template <class Height>
PointCloud sheet(double x0, double x1, double y0, double y1, Height z) {
  PointCloud cloud;
  for (double x = x0; x <= x1; x += 0.5)
    for (double y = y0; y <= y1; y += 0.5) {
      const double slope = (z(x + 0.01) - z(x - 0.01)) / 0.02;
      cloud.points.push_back(Eigen::Vector3d(x, y, z(x)).cast<float>());
      cloud.normals.push_back(Eigen::Vector3d(-slope, 0, 1).normalized().cast<float>());
    }
  return cloud;
}

/// 30 x 24 mm on both sides of a waist that is 14 mm wide, 0.58 of their width.
template <class Height>
PointCloud waisted(Height z) {
  PointCloud cloud = sheet(0, 30, 0, 24, z);
  test::append(cloud, sheet(30.5, 32, 5, 19, z));
  test::append(cloud, sheet(32.5, 62, 0, 24, z));
  return cloud;
}

TEST(CutTouching, AWideWaistIsCutWhereTheSurfaceStepsDown) {
  const PointCloud cloud = waisted([](double x) { return x < 31 ? 9.0 : 7.5; });
  const TouchingParts parts = cutTouching(cloud, {});
  ASSERT_EQ(parts.count, 2);
  ASSERT_EQ(parts.necks.size(), 1u);
  EXPECT_NEAR(parts.necks[0].place.x(), 31, 1);
  EXPECT_NEAR(parts.necks[0].place.y(), 12, 1.5);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (std::abs(cloud.points[i].x() - 31) < 1.1f) continue;
    EXPECT_EQ(parts.part[i] == parts.part[0], cloud.points[i].x() < 31) << cloud.points[i];
  }
}

TEST(CutTouching, SoIsOneWhereTheSurfaceIsBent) {
  EXPECT_EQ(cutTouching(waisted([](double x) { return 9 - 0.3 * std::abs(x - 31); }), {}).count, 2);
}

TEST(CutTouching, AWaistOfOneSmoothSherdIsNot) {
  const double radius = 40;  // of a cup
  const auto cup = [&](double x) { return 12 - radius + std::sqrt(1600 - std::pow(x - 31, 2)); };
  EXPECT_EQ(cutTouching(waisted(cup), {}).count, 1);
}

TEST(CutTouching, ABentSherdWithoutAWaistIsNot) {
  const auto carinated = [](double x) { return 12 - 0.5 * std::abs(x - 31); };
  EXPECT_EQ(cutTouching(sheet(0, 62, 0, 24, carinated), {}).count, 1);
}

TEST(CutTouching, WithoutNormalsOnlyANeckCounts) {
  PointCloud cloud = waisted([](double x) { return x < 31 ? 9.0 : 7.5; });
  cloud.normals.clear();
  EXPECT_EQ(cutTouching(cloud, {}).count, 1);
}

TEST(SplitScans, CutsThreeSherdsInARow) {
  PointCloud cloud = test::box(-60, 0, 30, 25, 6);
  test::append(cloud, test::box(-31, 21, 30, 25, 5));  // overlaps by 1 x 4 mm
  test::append(cloud, test::box(-2, 38, 30, 25, 8));   // by 1 x 8 mm
  EXPECT_EQ(sherdsIn(cloud), 3u);
}

}  // namespace
}  // namespace ostraka::scan
