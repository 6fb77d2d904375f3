#include "model/indicator.h"

#include <gtest/gtest.h>

#include "sphere.h"

namespace ostraka::model {
namespace {

TEST(Grid, InterpolatesBetweenItsNodesAndKeepsTheBordersValueOutside) {
  Grid grid;
  grid.origin = {10, 20, 30};
  grid.cell_mm = 2;
  grid.size = {3, 2, 2};
  for (int z = 0; z < 2; ++z)
    for (int y = 0; y < 2; ++y)
      for (int x = 0; x < 3; ++x) grid.values.push_back(static_cast<float>(x + 10 * y + 100 * z));
  EXPECT_EQ(grid.node(2, 1, 1), Eigen::Vector3f(14, 22, 32));
  EXPECT_FLOAT_EQ(grid.values[grid.at(2, 1, 1)], 112);
  EXPECT_FLOAT_EQ(grid.interpolated({14, 22, 32}), 112);
  EXPECT_FLOAT_EQ(grid.interpolated({11, 20.5F, 31}), 0.5F + 2.5F + 50);
  EXPECT_FLOAT_EQ(grid.interpolated({0, 21, 30}), 5);
  EXPECT_FLOAT_EQ(grid.interpolated({99, 99, 99}), 112);
}

// Gauss: chi jumps by one at a closed surface, so it is one inside, none outside, a half on it.
TEST(Indicator, IsOneInsideASphereAndNothingOutside) {
  const Surfels sphere = sphereSurfels(6, 1500);
  const Result<Grid> grid = indicator(sphere, 0.6F, 1, {});
  ASSERT_TRUE(grid.has_value());
  EXPECT_NEAR(grid->level, 0.5, 0.05);
  const auto chi = [&](float r) {
    return grid->interpolated(r * Eigen::Vector3f(0.6F, 0, 0.8F)) + grid->level;
  };
  EXPECT_NEAR(chi(0), 1, 0.05);
  EXPECT_NEAR(chi(4), 1, 0.05);
  EXPECT_NEAR(chi(8), 0, 0.05);
  // The level of the surface itself lies within half a cell of it.
  EXPECT_GT(chi(5.7F) - grid->level, 0);
  EXPECT_LT(chi(6.3F) - grid->level, 0);
}

TEST(Indicator, HoldsTheVolumeOfASphereAndItsMargin) {
  const Result<Grid> grid = indicator(sphereSurfels(6, 1500), 0.6F, 1, {});
  ASSERT_TRUE(grid.has_value());
  double inside = 0;
  for (const float value : grid->values) inside += value > 0 ? 0.6 * 0.6 * 0.6 : 0;
  EXPECT_NEAR(inside, 904.8, 0.03 * 904.8);  // 4/3 pi 6^3 mm3
  EXPECT_LE(grid->origin.maxCoeff(), -6 - kMargin_mm + 0.01F);
  for (int axis = 0; axis < 3; ++axis)
    EXPECT_GE(grid->origin[axis] + 0.6F * static_cast<float>(grid->size[axis] - 1),
              6 + kMargin_mm - 0.1F);
}

TEST(Indicator, IsTheSameWithAnyNumberOfThreads) {
  const Surfels sphere = sphereSurfels(3, 300);
  const Result<Grid> one = indicator(sphere, 0.6F, 1, {});
  for (const int threads : {3, 16})
    EXPECT_EQ(indicator(sphere, 0.6F, threads, {})->values, one->values);
}

TEST(Indicator, OfAHallIsTooLargeAndSaysSo) {
  Surfels two = sphereSurfels(1, 2);
  two.points[1] = {4000, 4000, 4000};
  const Result<Grid> grid = indicator(two, 0.5F, 1, {});
  ASSERT_FALSE(grid.has_value());
  EXPECT_EQ(grid.error().code, ErrorCode::NotEnough);
}

TEST(Indicator, EndsWhenAStopIsRequested) {
  std::stop_source stop;
  stop.request_stop();
  const Result<Grid> grid = indicator(sphereSurfels(3, 300), 0.6F, 1, stop.get_token());
  ASSERT_FALSE(grid.has_value());
  EXPECT_EQ(grid.error().code, ErrorCode::Cancelled);
}

// A fin: a double sheet that stereo has drawn 2 mm outwards from the equator, which bounds nothing.
TEST(TrustedIndicator, TakesOutWhatBoundsNoBody) {
  Surfels surfels = sphereSurfels(6, 1500);
  const std::size_t of_sphere = surfels.size();
  const float step = static_cast<float>(surfels.spacing_mm);
  for (float x = 6.5F; x < 9; x += step)
    for (float y = -2; y < 2; y += step) {
      surfels.points.emplace_back(x, y, 0);
      surfels.normals.emplace_back(0, 0, 1);
      surfels.noise.push_back(0.01F);
      surfels.confidence.push_back(1);
      surfels.area.push_back(step * step);
    }
  const int fin = static_cast<int>(surfels.size() - of_sphere);
  ASSERT_GT(fin, 20);
  const Result<Grid> grid = trustedIndicator(surfels, 0.6F, 1, {});
  ASSERT_TRUE(grid.has_value());
  EXPECT_GE(surfels.dropped, fin * 9 / 10);
  EXPECT_LE(surfels.dropped, fin + 30) << "and little of the sphere";
  EXPECT_LT(grid->interpolated({8, 0, -0.5F}), 0);
  EXPECT_GT(grid->interpolated({5, 0, 0}), 0);
}

TEST(TrustedIndicator, LeavesAWholeBodyAsItIs) {
  Surfels sphere = sphereSurfels(6, 1500);
  ASSERT_TRUE(trustedIndicator(sphere, 0.6F, 1, {}).has_value());
  EXPECT_EQ(sphere.size(), 1500U);
  EXPECT_EQ(sphere.dropped, 0);
}

}  // namespace
}  // namespace ostraka::model
