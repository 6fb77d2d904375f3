#include "pairing/turning_angles.h"

#include <gtest/gtest.h>

#include <numbers>
#include <numeric>

#include "synthetic_sherd.h"

namespace ostraka::pairing {
namespace {

const std::vector<Eigen::Vector2d> kSquare = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};

TEST(TurningAngles, OfASquareAreFourRightAngles) {
  const auto angles = turningAngles(kSquare, 4);
  ASSERT_TRUE(angles.has_value());
  for (const double a : *angles) EXPECT_NEAR(a, std::numbers::pi / 2, 1e-12);
}

TEST(TurningAngles, OfAnyClosedLineSumToAFullTurn) {
  const auto angles = turningAngles(test::SlabSherd(3).outline(777), 200);
  ASSERT_TRUE(angles.has_value());
  EXPECT_NEAR(std::accumulate(angles->begin(), angles->end(), 0.0), 2 * std::numbers::pi, 1e-9);
}

TEST(TurningAngles, RefuseALineOfTwoPoints) {
  const std::vector<Eigen::Vector2d> two = {{0, 0}, {1, 0}};
  const auto angles = turningAngles(two, 200);
  ASSERT_FALSE(angles.has_value());
  EXPECT_EQ(angles.error().code, ErrorCode::NotEnough);
}

TEST(Accumulated, StartsAtTheGivenPointAndWrapsAround) {
  const std::vector<double> angles = {1, 2, 4};
  EXPECT_EQ(accumulated(angles, 1), (std::vector<double>{2, 6, 7}));
}

TEST(ShiftCosts, AreZeroAtTheShiftBetweenTwoEqualLines) {
  const std::vector<double> a = {0.1, 0.5, -0.2, 0.7, 0.3};
  const std::vector<double> b = {0.7, 0.3, 0.1, 0.5, -0.2};  // b[i + 2] = a[i]
  const std::vector<double> costs = shiftCosts(a, b, Offset::None);
  EXPECT_NEAR(costs[2], 0, 1e-12);
  EXPECT_GT(costs[0], 0.1);
}

TEST(ShiftCosts, FreeOffsetTakesAConstantTurnOut) {
  const std::vector<double> a = {0.5, 0, 0}, b = {0.8, 0, 0};  // sums differ by 0.3 everywhere
  EXPECT_NEAR(shiftCosts(a, b, Offset::Free)[0], 0, 1e-9);
  EXPECT_NEAR(shiftCosts(a, b, Offset::None)[0], 0.3, 1e-12);
}

}  // namespace
}  // namespace ostraka::pairing
