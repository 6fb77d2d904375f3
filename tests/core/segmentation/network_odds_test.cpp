#include "segmentation/network_odds.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ostraka::segmentation {
namespace {

// Of 100 x 100 cells the upper half is surely sherd, the lower one bare plate; the network says
// `right` of so many per cent of either and the contrary of the rest.
NetworkSight sight(uchar says_sherd, uchar says_plate, int right_percent) {
  NetworkSight s{cv::Mat1b(100, 100), cv::Mat1f(100, 100, 0.F), cv::Mat1f(100, 100, 0.F)};
  for (int y = 0; y < 100; ++y)
    for (int x = 0; x < 100; ++x) {
      const bool sherd = y < 50, right = x < right_percent;
      (sherd ? s.inside : s.clear)(y, x) = 1;
      s.says(y, x) = sherd == right ? says_sherd : says_plate;
    }
  return s;
}

TEST(NetworkOdds, AreTheRatioOfHowOftenItSaysSoOfSherdsAndOfThePlate) {
  // 0.9 / 0.1, each with the doubt of 0.002: log(0.902 / 0.102) = 2.18. Its own odds are larger.
  const std::array sights{sight(253, 2, 90)};
  const NetworkOdds odds = NetworkOdds::learn(sights);
  EXPECT_NEAR(odds.of(253), 2.18F, 0.01F);
  EXPECT_NEAR(odds.of(2), -2.18F, 0.01F);
}

TEST(NetworkOdds, AreNoLargerThanTheNetworksOwn) {
  // It is always right where all is sure, and says 0.8: log 4. Elsewhere that is as much as it
  // says.
  const std::array sights{sight(204, 51, 100)};
  const NetworkOdds odds = NetworkOdds::learn(sights);
  EXPECT_NEAR(odds.of(204), std::log(4.F), 1e-4F);
  EXPECT_NEAR(odds.of(51), -std::log(4.F), 1e-4F);
}

TEST(NetworkOdds, AreNoneOfANetworkThatIsBlindToTheseThings) {
  // It says of sherds what it says of the plate.
  const std::array sights{sight(2, 2, 100)};
  const NetworkOdds odds = NetworkOdds::learn(sights);
  for (int says = 0; says < 256; ++says) EXPECT_NEAR(odds.of(static_cast<uchar>(says)), 0, 1e-4F);
}

TEST(NetworkOdds, NeverTurnAgainstWhatTheNetworkSays) {
  const std::array sights{sight(253, 2, 10)};  // nearly always wrong
  const NetworkOdds odds = NetworkOdds::learn(sights);
  for (int says = 0; says < 256; ++says) EXPECT_EQ(odds.of(static_cast<uchar>(says)), 0);
}

TEST(NetworkOdds, NeverFallAsTheProbabilityRises) {
  const std::array sights{sight(253, 2, 80), sight(160, 100, 95), sight(204, 30, 60)};
  const NetworkOdds odds = NetworkOdds::learn(sights);
  for (int says = 1; says < 256; ++says)
    EXPECT_LE(odds.of(static_cast<uchar>(says - 1)), odds.of(static_cast<uchar>(says))) << says;
}

TEST(NetworkOdds, AreNoneWhereNothingIsSure) {
  NetworkSight nothing = sight(253, 2, 100);
  nothing.inside.setTo(0);
  EXPECT_EQ(NetworkOdds::learn(std::array{nothing}).of(253), 0);
}

TEST(NetworkOdds, AreScaledToThePhotograph) {
  const NetworkOdds odds = NetworkOdds::learn(std::array{sight(253, 2, 90)});
  const cv::Mat1f scaled = odds.of(cv::Mat1b(30, 40, uchar{253}), {400, 300});
  EXPECT_EQ(scaled.size(), cv::Size(400, 300));
  EXPECT_NEAR(scaled(150, 200), odds.of(253), 1e-5F);
}

}  // namespace
}  // namespace ostraka::segmentation
