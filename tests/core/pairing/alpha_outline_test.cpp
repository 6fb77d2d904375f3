#include "pairing/alpha_outline.h"

#include <gtest/gtest.h>

#include <set>

namespace ostraka::pairing {
namespace {

/// A grid of 1 mm with the cells for which `keep` holds.
template <class Keep>
std::vector<Eigen::Vector2d> grid(int n, Keep keep) {
  std::vector<Eigen::Vector2d> points;
  for (int y = 0; y <= n; ++y) {
    for (int x = 0; x <= n; ++x) {
      if (keep(x, y)) points.emplace_back(x, y);
    }
  }
  return points;
}

std::set<std::pair<int, int>> placesOf(const std::vector<Eigen::Vector2d>& points,
                                       const std::vector<int>& outline) {
  std::set<std::pair<int, int>> places;
  for (const int i : outline) {
    const Eigen::Vector2d& p = points[static_cast<std::size_t>(i)];
    places.emplace(static_cast<int>(p.x()), static_cast<int>(p.y()));
  }
  return places;
}

double areaOf(const std::vector<Eigen::Vector2d>& points, const std::vector<int>& outline) {
  double twice = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Eigen::Vector2d& p = points[static_cast<std::size_t>(outline[i])];
    const Eigen::Vector2d& q = points[static_cast<std::size_t>(outline[(i + 1) % outline.size()])];
    twice += p.x() * q.y() - p.y() * q.x();
  }
  return twice / 2;
}

TEST(AlphaOutline, OfASquareGridIsItsBorderCounterClockwise) {
  const auto points = grid(10, [](int, int) { return true; });
  const auto outline = alphaOutline(points, 1.0);
  ASSERT_TRUE(outline.has_value());
  EXPECT_EQ(outline->size(), 40u);
  EXPECT_NEAR(areaOf(points, *outline), 100, 1e-9);
}

TEST(AlphaOutline, IsTheOuterOneWhenThereIsAHole) {
  const auto points = grid(20, [](int x, int y) { return x < 6 || x > 14 || y < 6 || y > 14; });
  const auto outline = alphaOutline(points, 1.0);
  ASSERT_TRUE(outline.has_value());
  EXPECT_NEAR(areaOf(points, *outline), 400, 1e-9);
}

TEST(AlphaOutline, GoesIntoABayWiderThanTheDiscAndNotIntoANarrowOne) {
  const auto wide = grid(20, [](int x, int y) { return y < 10 || x < 8 || x > 12; });
  const auto into = alphaOutline(wide, 1.5);  // the bay is 6 mm between its shores
  ASSERT_TRUE(into.has_value());
  EXPECT_TRUE(placesOf(wide, *into).contains({10, 9}));
  const auto narrow = grid(20, [](int x, int y) { return y < 10 || x < 10 || x > 10; });
  const auto past = alphaOutline(narrow, 1.5);  // 2 mm between its shores
  ASSERT_TRUE(past.has_value());
  EXPECT_FALSE(placesOf(narrow, *past).contains({10, 9}));
}

TEST(AlphaOutline, FollowsTheLargestGroupOnly) {
  auto points = grid(10, [](int, int) { return true; });
  for (int i = 0; i < 5; ++i) points.emplace_back(3 + i, -20);  // lower, but small
  const auto outline = alphaOutline(points, 1.0);
  ASSERT_TRUE(outline.has_value());
  EXPECT_NEAR(areaOf(points, *outline), 100, 1e-9);
}

TEST(AlphaOutline, RefusesPointsThatLieFarApart) {
  const std::vector<Eigen::Vector2d> points = {{0, 0}, {10, 0}, {0, 10}, {10, 10}};
  const auto outline = alphaOutline(points, 1.0);
  ASSERT_FALSE(outline.has_value());
  EXPECT_EQ(outline.error().code, ErrorCode::NotEnough);
}

}  // namespace
}  // namespace ostraka::pairing
