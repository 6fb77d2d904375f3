#include "vessels/clay.h"

#include <gtest/gtest.h>

namespace ostraka::vessels {
namespace {

TEST(Gloss, GlassReflectsFourPercentAtRightAnglesAndAllAtGrazingOnes) {
  EXPECT_NEAR(fresnel(1), 0.04, 1e-6);
  EXPECT_NEAR(fresnel(0), 1, 1e-6);
}

TEST(Clay, WidenedOnesAreShinyAsOftenAsAskedAndOftenNeutral) {
  Random random(8);
  int shiny = 0, neutral = 0, black = 0, white = 0;
  for (int i = 0; i < 1000; ++i) {
    Clay clay = makeClay(false, random);
    widen(clay, 0.4, random);
    shiny += clay.shine.weight > 0;
    neutral += clay.body.maxCoeff() < 1.1f * clay.body.minCoeff();
    black += clay.body.maxCoeff() < 0.05f;
    white += clay.body.minCoeff() > 0.45f;
  }
  // Binomial: SD of 1000 draws of 0.4 is 15.
  EXPECT_NEAR(shiny, 400, 50);
  EXPECT_GT(neutral, 350);
  EXPECT_GT(black, 40);
  EXPECT_GT(white, 40);
}

}  // namespace
}  // namespace ostraka::vessels
