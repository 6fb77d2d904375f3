#include "cloud/nearest.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace ostraka {
namespace {

std::vector<Eigen::Vector3f> randomPoints(int count) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> at(-5, 5);
  std::vector<Eigen::Vector3f> points;
  for (int i = 0; i < count; ++i) points.emplace_back(at(random), at(random), at(random));
  return points;
}

TEST(KdTree, FindsWhatTryingAllPointsFinds) {
  const std::vector<Eigen::Vector3f> points = randomPoints(500);
  const KdTree tree(points);
  std::vector<Neighbour> found;
  for (const Eigen::Vector3f& query : randomPoints(50)) {
    std::vector<std::pair<float, int>> all;
    for (int i = 0; i < 500; ++i) all.emplace_back((points[i] - query).squaredNorm(), i);
    std::sort(all.begin(), all.end());
    EXPECT_EQ(tree.nearest(query).index, all[0].second);
    tree.nearest(query, 7, found);
    ASSERT_EQ(found.size(), 7u);
    for (int k = 0; k < 7; ++k) EXPECT_EQ(found[k].index, all[k].second);
    tree.within(query, 1.5f, found);
    const auto near =
        std::count_if(all.begin(), all.end(), [](const auto& p) { return p.first < 2.25f; });
    EXPECT_EQ(found.size(), static_cast<std::size_t>(near));
    EXPECT_TRUE(std::is_sorted(found.begin(), found.end(), [](const auto& a, const auto& b) {
      return a.squared_distance < b.squared_distance;
    }));
  }
}

TEST(KdTree, KeepsWithinTheGreatestDistance) {
  const KdTree tree(std::vector<Eigen::Vector3f>{{0, 0, 0}});
  EXPECT_EQ(tree.nearest({3, 4, 0}, 4.9f).index, -1);
  EXPECT_TRUE(std::isinf(tree.nearest({3, 4, 0}, 4.9f).squared_distance));
  EXPECT_EQ(tree.nearest({3, 4, 0}, 5.1f).index, 0);
  EXPECT_FLOAT_EQ(tree.nearest({3, 4, 0}).squared_distance, 25);
}

TEST(KdTree, OfNothingFindsNothing) {
  const KdTree tree(std::vector<Eigen::Vector3f>{});
  std::vector<Neighbour> found{{1, 1}};
  EXPECT_EQ(tree.nearest({0, 0, 0}).index, -1);
  EXPECT_TRUE(std::isinf(tree.nearest({0, 0, 0}).squared_distance));
  tree.nearest({0, 0, 0}, 3, found);
  EXPECT_TRUE(found.empty());
  tree.within({0, 0, 0}, 10, found);
  EXPECT_TRUE(found.empty());
}

TEST(KdTree, GivesAllPointsWhenAskedForMore) {
  const KdTree tree(std::vector<Eigen::Vector3f>{{0, 0, 0}, {1, 0, 0}});
  std::vector<Neighbour> found;
  tree.nearest({0.9f, 0, 0}, 10, found);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].index, 1);
}

}  // namespace
}  // namespace ostraka
