#include "hull/hull_odds.h"

#include <gtest/gtest.h>

namespace ostraka::hull {
namespace {

// Columns of none to seven voxels behind, all four high; every second of 100 samples is lit plate
// in the first four columns and the others are sure sherd.
HullSight sight() {
  HullSight sight{cv::Mat1f(100, 8), cv::Mat1f(100, 8, 4.F), cv::Mat1b(100, 8, uchar{1}),
                  cv::Mat1f(100, 8, 0.F), cv::Mat1f(100, 8, 0.F)};
  for (int y = 0; y < 100; ++y)
    for (int x = 0; x < 8; ++x) {
      sight.behind(y, x) = static_cast<float>(x);
      const bool plate = x < 4 && y % 2 == 0;
      sight.clear(y, x) = plate ? 1.F : 0.F;
      sight.log_odds(y, x) = plate ? -8.F : 5.F;
    }
  return sight;
}

HullOdds learnt() {
  const HullSight one = sight();
  return learnHullOdds(std::span(&one, 1), 1);
}

TEST(HullOdds, FollowTheShareOfSureSherdByWhatIsBehindAndBelow) {
  const HullOdds odds = learnt();
  EXPECT_NEAR(odds.by[2][4], 0, 0.01);  // 50 of each
  EXPECT_NEAR(odds.by[5][4], 2, 0.01);  // 100 against none would be 2.4
  EXPECT_FLOAT_EQ(odds.by[5][2], 0);    // no sample is so low
}

TEST(HullOdds, AreOnlyEvidenceForASherdAndLeaveTheOutermostVoxelAlone) {
  const HullOdds odds = learnt();
  const cv::Mat1f behind = (cv::Mat1f(1, 4) << 0.F, 0.5F, 5.F, 5.F),
                  below = (cv::Mat1f(1, 4) << 4.F, 4.F, 0.9F, 4.F);
  const cv::Mat1f of = odds.of(behind, below, behind.size());
  EXPECT_FLOAT_EQ(of(0, 0), 0);
  EXPECT_FLOAT_EQ(of(0, 1), 0);
  EXPECT_FLOAT_EQ(of(0, 2), 0);
  EXPECT_NEAR(of(0, 3), 2, 0.01);
}

TEST(HullOdds, AreOfAPhotographsOwnSize) {
  const cv::Mat1f deep(5, 6, 6.F), high(5, 6, 4.F);
  const cv::Mat1f of = learnt().of(deep, high, {24, 20});
  ASSERT_EQ(of.size(), cv::Size(24, 20));
  EXPECT_NEAR(of(10, 10), 2, 0.01);
}

TEST(HullOdds, SayNothingWhereNoSampleIsSure) {
  HullSight one = sight();
  one.clear.setTo(0);
  one.log_odds.setTo(0);
  EXPECT_EQ(learnHullOdds(std::span(&one, 1), 1).by, HullOdds().by);
}

}  // namespace
}  // namespace ostraka::hull
