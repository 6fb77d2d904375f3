#include "mask/hull_odds.h"

#include <gtest/gtest.h>

namespace ostraka::mask {
namespace {

// Columns of none to eleven half voxels; every second of 100 samples is lit plate in the
// first six columns and the others are sure sherd.
HullSight sight() {
  HullSight sight{cv::Mat1f(100, 12), cv::Mat1b(100, 12, uchar{1}), cv::Mat1f(100, 12, 0.F),
                  cv::Mat1f(100, 12, 0.F)};
  for (int y = 0; y < 100; ++y)
    for (int x = 0; x < 12; ++x) {
      sight.voxels(y, x) = 0.5F * static_cast<float>(x);
      const bool plate = x < 6 && y % 2 == 0;
      sight.clear(y, x) = plate ? 1.F : 0.F;
      sight.log_odds(y, x) = plate ? -8.F : 5.F;
    }
  return sight;
}

TEST(HullOdds, FollowTheShareOfSureSherdByDepth) {
  const HullSight one = sight();
  const HullOdds odds = learnHullOdds(std::span(&one, 1), 1);
  EXPECT_NEAR(odds.steps[2], 0, 0.01);  // 50 of each
  EXPECT_NEAR(odds.steps[8], 2, 0.01);  // 100 against none would be 2.4
}

TEST(HullOdds, AreOnlyEvidenceForASherdAndLeaveTheOutermostVoxelAlone) {
  const HullSight one = sight();
  const HullOdds odds = learnHullOdds(std::span(&one, 1), 1);
  cv::Mat1f log_odds(1, 3, -1.F), voxels(1, 3);
  voxels(0, 0) = 0;
  voxels(0, 1) = 0.5F;
  voxels(0, 2) = 4;
  odds.addTo(log_odds, voxels);
  EXPECT_FLOAT_EQ(log_odds(0, 0), -1);
  EXPECT_FLOAT_EQ(log_odds(0, 1), -1);
  EXPECT_NEAR(log_odds(0, 2), 1, 0.01);
  EXPECT_NEAR(odds.without(log_odds, voxels)(0, 2), -1, 0.01);
}

TEST(HullOdds, SayNothingWhereNoSampleIsSure) {
  HullSight one = sight();
  one.clear.setTo(0);
  one.log_odds.setTo(0);
  for (const float step : learnHullOdds(std::span(&one, 1), 1).steps) EXPECT_FLOAT_EQ(step, 0);
}

}  // namespace
}  // namespace ostraka::mask
