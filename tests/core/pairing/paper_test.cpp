#include "pairing/paper.h"

#include <gtest/gtest.h>

#include "pairing/contour.h"
#include "synthetic_sherd.h"

namespace ostraka::pairing {
namespace {

TEST(PaperCost, IsSmallForAContourStartedElsewhereAndGivesTheStart) {
  const std::vector<Eigen::Vector2d> line = resampled(test::SlabSherd(1).outline(2000), 200);
  std::vector<Eigen::Vector2d> later(line.begin() + 50, line.end());
  later.insert(later.end(), line.begin(), line.begin() + 50);
  const auto cost = paperCost(line, later);
  ASSERT_TRUE(cost.has_value());
  EXPECT_LT(cost->cost, 1e-3);  // radians; the corners of the line are resampled
  EXPECT_EQ(cost->shift, 150);
}

TEST(PaperCost, DoesNotSeeSize) {
  const std::vector<Eigen::Vector2d> line = test::SlabSherd(1).outline(400);
  std::vector<Eigen::Vector2d> twice = line;
  for (Eigen::Vector2d& p : twice) p *= 2;
  EXPECT_LT(paperCost(line, twice)->cost, 1e-6);
}

TEST(PaperCost, TellsTwoSherdsApart) {
  EXPECT_GT(paperCost(test::SlabSherd(1).outline(400), test::SlabSherd(2).outline(400))->cost, 0.1);
}

TEST(PaperCost, RefusesALineOfTwoPoints) {
  const std::vector<Eigen::Vector2d> two = {{0, 0}, {1, 0}};
  EXPECT_FALSE(paperCost(two, test::SlabSherd(1).outline(400)).has_value());
}

}  // namespace
}  // namespace ostraka::pairing
