#include "mask/view_state.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>

namespace ostraka::mask {
namespace {

TEST(InsideOf, IsTheShareOfPixelsThatAreSurelySherd) {
  cv::Mat1f odds(4, 6, 0.F);
  odds(0, 0) = 5;
  odds(1, 1) = 2.1F;
  odds(0, 1) = 2;  // not yet
  odds.rowRange(2, 4).colRange(2, 4).setTo(9);
  odds(3, 5) = -9;
  const cv::Mat1f inside = insideOf(odds, 2);
  ASSERT_EQ(inside.size(), cv::Size(3, 2));
  EXPECT_FLOAT_EQ(inside(0, 0), 0.5F);
  EXPECT_FLOAT_EQ(inside(1, 1), 1);
  EXPECT_FLOAT_EQ(inside(0, 1), 0);
  EXPECT_FLOAT_EQ(inside(1, 2), 0);
  EXPECT_FLOAT_EQ(odds(0, 0), 5) << "the odds stay as they were";
}

TEST(SharesOf, GrowFromNothingToAllOverFourUnitsOfOdds) {
  cv::Mat1f odds(2, 8, 0.F);
  odds.colRange(0, 2).setTo(-3);
  odds.colRange(2, 4).setTo(2);
  odds.colRange(4, 6).setTo(4);
  odds.colRange(6, 8).setTo(40);
  const cv::Mat1f shares = sharesOf(odds, {4, 1});
  ASSERT_EQ(shares.size(), cv::Size(4, 1));
  EXPECT_FLOAT_EQ(shares(0, 0), 0);
  EXPECT_FLOAT_EQ(shares(0, 1), 0.5F);
  EXPECT_FLOAT_EQ(shares(0, 2), 1);
  EXPECT_FLOAT_EQ(shares(0, 3), 1);
}

class OneView : public testing::Test {
 protected:
  OneView() {
    view.residual = cv::Mat3f::zeros(4, 4);
    view.log_odds = cv::Mat1f(4, 4, 0.F);
    view.plate = cv::Mat1b(2, 2, std::uint8_t{255});
    view.hull = {&image, cv::Mat1f(2, 2, 0.25F), cv::Mat1f(2, 2, 0.8F)};
  }
  rig::PosedImage image;
  ViewState view;
};

TEST_F(OneView, IsCarvedAnewByTheSharesOfItsMask) {
  cv::Mat1b mask(4, 4, std::uint8_t{0});
  mask.rowRange(0, 2).colRange(0, 2).setTo(255);
  mask(0, 2) = 255;
  view.plate(1, 0) = 0;
  const hull::HullView carved = hullViewOf(view, mask);
  EXPECT_EQ(carved.image, &image);
  EXPECT_FLOAT_EQ(carved.inside(0, 0), 1);
  EXPECT_FLOAT_EQ(carved.clear(0, 0), 0);
  EXPECT_NEAR(carved.inside(0, 1), 0.25, 0.003);  // 63.75 of 255, rounded
  EXPECT_FLOAT_EQ(carved.inside(0, 1) + carved.clear(0, 1), 1);
  EXPECT_FLOAT_EQ(carved.clear(1, 1), 1);
  EXPECT_FLOAT_EQ(carved.inside(1, 0), 0);
  EXPECT_FLOAT_EQ(carved.clear(1, 0), 0) << "of what lies beside the plate nothing is known";
}

TEST_F(OneView, TakesWhatStandsAboveThePlateForSherd) {
  cv::Mat1f heights(2, 2, 0.F);
  heights(0, 0) = 8;
  heights(1, 1) = -8;
  addHeights(view, heights);
  EXPECT_FLOAT_EQ(view.hull.inside(0, 0), 1);
  EXPECT_FLOAT_EQ(view.hull.clear(0, 0), 0);
  for (const cv::Point cell : {cv::Point(1, 0), cv::Point(0, 1), cv::Point(1, 1)}) {
    EXPECT_FLOAT_EQ(view.hull.inside(cell), 0.25F) << cell;
    EXPECT_FLOAT_EQ(view.hull.clear(cell), 0.8F) << cell;
  }
  EXPECT_GT(view.log_odds(0, 0), 2);
  EXPECT_LE(view.log_odds(3, 3), 0);
  EXPECT_EQ(cv::countNonZero(view.height_odds != heights), 0);
}

}  // namespace
}  // namespace ostraka::mask
