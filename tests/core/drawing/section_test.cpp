#include "drawing/section.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ostraka::drawing {
namespace {

// A closed box from low to high.
TriangleMesh box(const Eigen::Vector3f& low, const Eigen::Vector3f& high) {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.vertices.emplace_back(i & 1 ? high.x() : low.x(), i & 2 ? high.y() : low.y(),
                               i & 4 ? high.z() : low.z());
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

double area(const Loop& loop) {
  double sum = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Eigen::Vector2d &p = loop[i], &q = loop[(i + 1) % loop.size()];
    sum += 0.5 * (p.x() * q.y() - q.x() * p.y());
  }
  return std::abs(sum);
}

TEST(Cut, OfABoxIsItsRectangle) {
  const auto loops = cut(box({-1, -2, -3}, {4, 5, 6}), Eigen::Isometry3d::Identity());
  ASSERT_EQ(loops.size(), 1U);
  EXPECT_NEAR(area(loops[0]), 7 * 9, 1e-4);
}

TEST(Cut, ThroughVerticesClosesToo) {
  const auto loops = cut(box({0, -2, -3}, {4, 5, 6}), Eigen::Isometry3d::Identity());
  ASSERT_LE(loops.size(), 1U);
  if (!loops.empty()) {
    EXPECT_NEAR(area(loops[0]), 7 * 9, 1e-3);
  }
}

TEST(Cut, BesideTheBodyIsEmpty) {
  EXPECT_TRUE(cut(box({1, 0, 0}, {2, 1, 1}), Eigen::Isometry3d::Identity()).empty());
}

TEST(Hatch, FillsASquareLineByLine) {
  const Shape lines = hatched({{{0, 0}, {10, 0}, {10, 10}, {0, 10}}}, 0, 2, 0.1);
  // At 0, 2, 4, 6, 8: each 10 mm long.
  ASSERT_EQ(lines.lines.size(), 5U);
  for (const auto& line : lines.lines) EXPECT_NEAR((line[1] - line[0]).norm(), 10, 1e-9);
}

TEST(Hatch, LeavesHolesOpen) {
  const Shape lines =
      hatched({{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {{4, 4}, {6, 4}, {6, 6}, {4, 6}}}, 0, 5, 0.1);
  // At 0 through, at 5 in two pieces of 4 mm.
  ASSERT_EQ(lines.lines.size(), 3U);
  EXPECT_NEAR((lines.lines[1][1] - lines.lines[1][0]).norm(), 4, 1e-9);
  EXPECT_NEAR((lines.lines[2][1] - lines.lines[2][0]).norm(), 4, 1e-9);
}

}  // namespace
}  // namespace ostraka::drawing
