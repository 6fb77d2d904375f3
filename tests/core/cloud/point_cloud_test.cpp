#include "cloud/point_cloud.h"

#include <gtest/gtest.h>

#include <numbers>

namespace ostraka {
namespace {

PointCloud grid(int n, float step) {
  PointCloud cloud;
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < n; ++k) {
      cloud.points.emplace_back(static_cast<float>(i) * step, static_cast<float>(k) * step, 0.0f);
      cloud.normals.emplace_back(0.0f, 0.0f, 1.0f);
      cloud.quality.push_back(static_cast<float>(i));
    }
  return cloud;
}

TEST(Transformed, MovesPointsAndOnlyTurnsNormals) {
  Eigen::Isometry3d pose = Eigen::Translation3d(10, 0, 0) *
                           Eigen::AngleAxisd(std::numbers::pi / 2, Eigen::Vector3d::UnitX()) *
                           Eigen::Isometry3d::Identity();
  const PointCloud cloud{{{1, 2, 3}}, {{0, 0, 1}}, {{1, 2, 3}}, {0.5f}};
  const PointCloud moved = transformed(cloud, pose);
  EXPECT_LT((moved.points[0] - Eigen::Vector3f(11, -3, 2)).norm(), 1e-5f);
  EXPECT_LT((moved.normals[0] - Eigen::Vector3f(0, -1, 0)).norm(), 1e-6f);
  EXPECT_EQ(moved.colors, cloud.colors);
  EXPECT_EQ(moved.quality, cloud.quality);
}

TEST(Subset, KeepsTheOrderAskedForAndOnlyWhatIsThere) {
  const PointCloud part = subset(grid(3, 1), {8, 0, 4});
  ASSERT_EQ(part.size(), 3u);
  EXPECT_EQ(part.points[0], Eigen::Vector3f(2, 2, 0));
  EXPECT_EQ(part.quality, (std::vector<float>{2, 0, 1}));
  EXPECT_TRUE(part.colors.empty());
}

TEST(WithoutRepeats, LeavesTheFirstOfAPlaceWithTheNormalsOfAll) {
  const PointCloud cloud{{{1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 0, -0.f}, {2, 0, 0}},
                         {{0, 0, 1}, {0, 0, 1}, {0, 1, 0}, {0, 0, 1}, {1, 0, 0}},
                         {},
                         {1, 2, 3, 4, 5}};
  const PointCloud once = withoutRepeats(cloud);
  ASSERT_EQ(once.size(), 3u);
  EXPECT_EQ(once.points[0], Eigen::Vector3f(1, 0, 0));
  EXPECT_EQ(once.points[1], Eigen::Vector3f(0, 0, 0));
  EXPECT_EQ(once.points[2], Eigen::Vector3f(2, 0, 0));
  EXPECT_EQ(once.quality, (std::vector<float>{1, 2, 5}));
  const PointCloud directed = oriented(once);
  EXPECT_LT((directed.normals[0] - Eigen::Vector3f(0, 1, 1).normalized()).norm(), 1e-6f);
  EXPECT_EQ(directed.normals[1], Eigen::Vector3f(0, 0, 1));
  EXPECT_EQ(withoutRepeats(grid(3, 1)).points, grid(3, 1).points);
  EXPECT_TRUE(withoutRepeats({}).empty());
}

TEST(Thinned, LeavesOnePointForEachCube) {
  // 40 x 40 points, 0.1 apart from 0: cubes of 1 mm hold 10 x 10 of them.
  const PointCloud thin = thinned(grid(40, 0.1f), 1.0);
  EXPECT_EQ(thin.size(), 16u);
  for (const Eigen::Vector3f& p : thin.points) {
    const Eigen::Vector3f in_cube = p - p.array().floor().matrix();
    EXPECT_NEAR(in_cube.x(), 0.45, 0.06);  // the one nearest the cube's mean
  }
}

TEST(MedianSpacing, IsTheGridsStepAndZeroForOnePoint) {
  EXPECT_NEAR(medianSpacing(grid(20, 0.4f)), 0.4, 1e-5);
  EXPECT_EQ(medianSpacing(grid(1, 1)), 0);
  EXPECT_EQ(medianSpacing({}), 0);
}

}  // namespace
}  // namespace ostraka
