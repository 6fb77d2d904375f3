#include "vessels/noise.h"

#include <gtest/gtest.h>

namespace ostraka::vessels {
namespace {

TEST(Noise, HasTheGradientThatItsDifferencesSay) {
  constexpr float kStep = 1e-2f;
  for (const Eigen::Vector3f& p :
       {Eigen::Vector3f(0.3f, 0.6f, 0.2f), Eigen::Vector3f(-2.4f, 5.7f, 1.5f)}) {
    const NoiseValue here = noiseWithGradient(p, 7);
    EXPECT_NEAR(here.value, noise(p, 7), 1e-6);
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3f d = kStep * Eigen::Vector3f::Unit(k);
      EXPECT_NEAR(here.gradient[k], (noise(p + d, 7) - noise(p - d, 7)) / (2 * kStep), 1e-3);
    }
  }
}

TEST(Noise, IsLevelAtTheLatticeAndAnotherForAnotherSeed) {
  EXPECT_EQ(noiseWithGradient({3, -2, 5}, 7).gradient.norm(), 0);
  EXPECT_NE(noise({3, -2, 5}, 7), noise({3, -2, 5}, 8));
  EXPECT_EQ(fractalNoise({0.3f, 0.6f, 0.2f}, 7, 1), noise({0.3f, 0.6f, 0.2f}, 7));
}

// Four parts of 16 bits, each 0 to 65535: the sum is 131070 in the middle.
TEST(QuickNormal, LiesWithinTheSquareRootOfTwelve) {
  EXPECT_NEAR(quickNormal(0), -3.464, 1e-3);
  EXPECT_NEAR(quickNormal(~std::uint64_t{0}), 3.464, 1e-3);
  EXPECT_EQ(quickNormal(0x0000FFFF0000FFFFull), 0);
}

TEST(SmoothStep, IsHalfInTheMiddleAndLevelBeyondItsEnds) {
  EXPECT_EQ(smoothStep(1, 3, 2), 0.5f);
  EXPECT_EQ(smoothStep(1, 3, 0), 0);
  EXPECT_EQ(smoothStep(1, 3, 4), 1);
  EXPECT_EQ(smoothStep(3, 1, 0), 1);
}

TEST(Random, GivesTheSameNumbersForTheSameSeed) {
  Random a(5), b(5), other(6);
  double sum = 0;
  for (int i = 0; i < 1000; ++i) {
    const double drawn = a.uniform();
    EXPECT_EQ(drawn, b.uniform());
    EXPECT_GE(drawn, 0);
    EXPECT_LT(drawn, 1);
    sum += drawn;
  }
  EXPECT_NEAR(sum / 1000, 0.5, 0.05) << "five times what a mean of 1000 scatters";
  EXPECT_NE(Random(5).next(), other.next());
}

}  // namespace
}  // namespace ostraka::vessels
