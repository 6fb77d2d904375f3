#include "ground/exponential.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ostraka::ground {
namespace {

TEST(Exponential, IsTheLibrarysToSevenDigits) {
  for (double x = -86; x < 86; x += 0.0137) {
    const auto at = static_cast<float>(x);
    const double expected = std::exp(static_cast<double>(at));
    EXPECT_NEAR(expOf(at) / expected, 1, 3e-7) << x;
  }
  EXPECT_EQ(expOf(0), 1.F);
}

TEST(Exponential, StaysFiniteFarOut) {
  EXPECT_NEAR(expOf(-1e30F), 0, 1e-37);
  EXPECT_TRUE(std::isfinite(expOf(1e30F)));
}

TEST(Logarithm, IsTheLibrarysToSevenDigits) {
  for (double x = 1e-30; x < 1e30; x *= 1.037) {
    const auto at = static_cast<float>(x);
    const double expected = std::log(static_cast<double>(at));
    EXPECT_NEAR(logOf(at), expected, 3e-7 * (1 + std::abs(expected))) << x;
  }
  EXPECT_EQ(logOf(1), 0.F);
}

}  // namespace
}  // namespace ostraka::ground
