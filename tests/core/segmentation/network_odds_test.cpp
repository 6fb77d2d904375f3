#include "segmentation/network_odds.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace ostraka::segmentation {
namespace {

// The upper half of 100 x 100 cells is surely sherd, the lower one bare plate; the network is right
// in so many per cent of either.
NetworkSample sampleOf(uchar of_sherd, uchar of_plate, int right_percent) {
  NetworkSample s{cv::Mat1b(100, 100), cv::Mat1f(100, 100, 0.F), cv::Mat1f(100, 100, 0.F)};
  for (int y = 0; y < 100; ++y)
    for (int x = 0; x < 100; ++x) {
      const bool sherd = y < 50, right = x < right_percent;
      (sherd ? s.inside : s.clear)(y, x) = 1;
      s.probability(y, x) = sherd == right ? of_sherd : of_plate;
    }
  return s;
}

TEST(NetworkOdds, AreTheRatioOfHowOftenItSaysSoOfSherdsAndOfThePlate) {
  // 0.9 / 0.1, each with the doubt of 0.002: log(0.902 / 0.102) = 2.18. Its own odds are larger.
  const std::array samples{sampleOf(253, 2, 90)};
  const NetworkOdds odds = NetworkOdds::learn(samples);
  EXPECT_NEAR(odds.of(253), 2.18F, 0.01F);
  EXPECT_NEAR(odds.of(2), -2.18F, 0.01F);
}

TEST(NetworkOdds, AreNoLargerThanTheNetworksOwn) {
  // It is always right where all is sure, and p 0.8: log 4. Elsewhere that is as much as it
  // p.
  const std::array samples{sampleOf(204, 51, 100)};
  const NetworkOdds odds = NetworkOdds::learn(samples);
  EXPECT_NEAR(odds.of(204), std::log(4.F), 1e-4F);
  EXPECT_NEAR(odds.of(51), -std::log(4.F), 1e-4F);
}

TEST(NetworkOdds, AreNoneOfANetworkThatIsBlindToTheseThings) {
  // It p of sherds what it p of the plate.
  const std::array samples{sampleOf(2, 2, 100)};
  const NetworkOdds odds = NetworkOdds::learn(samples);
  for (int p = 0; p < 256; ++p) EXPECT_NEAR(odds.of(static_cast<uchar>(p)), 0, 1e-4F);
}

TEST(NetworkOdds, NeverTurnAgainstWhatTheNetwork) {
  const std::array samples{sampleOf(253, 2, 10)};  // nearly always wrong
  const NetworkOdds odds = NetworkOdds::learn(samples);
  for (int p = 0; p < 256; ++p) EXPECT_EQ(odds.of(static_cast<uchar>(p)), 0);
}

TEST(NetworkOdds, NeverFallAsTheProbabilityRises) {
  const std::array samples{sampleOf(253, 2, 80), sampleOf(160, 100, 95), sampleOf(204, 30, 60)};
  const NetworkOdds odds = NetworkOdds::learn(samples);
  for (int p = 1; p < 256; ++p)
    EXPECT_LE(odds.of(static_cast<uchar>(p - 1)), odds.of(static_cast<uchar>(p))) << p;
}

TEST(NetworkOdds, AreNoneWhereNothingIsSure) {
  NetworkSample nothing = sampleOf(253, 2, 100);
  nothing.inside.setTo(0);
  EXPECT_EQ(NetworkOdds::learn(std::array{nothing}).of(253), 0);
}

TEST(NetworkOdds, AreScaledToThePhotograph) {
  const NetworkOdds odds = NetworkOdds::learn(std::array{sampleOf(253, 2, 90)});
  const cv::Mat1f scaled = odds.of(cv::Mat1b(30, 40, uchar{253}), {400, 300});
  EXPECT_EQ(scaled.size(), cv::Size(400, 300));
  EXPECT_NEAR(scaled(150, 200), odds.of(253), 1e-5F);
}

}  // namespace
}  // namespace ostraka::segmentation
