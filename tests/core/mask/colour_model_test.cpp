#include "mask/colour_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>
#include <vector>

namespace ostraka::mask {
namespace {

// Three photographs of 80 x 80 pixels of one sherd on a grey plate: red clay with a dark patch in
// the left half, lit plate in the right half with a dark shadow in its lowest rows.
struct Sides {
  std::vector<cv::Mat> photographs;
  std::vector<cv::Mat1f> log_odds;
  std::vector<ColourView> views;

  Sides() {
    for (int k = 0; k < 3; ++k) {
      cv::Mat photograph(80, 80, CV_8UC3, cv::Scalar(110, 110, 110));
      cv::Mat1f odds(80, 80, -6.F);
      photograph.colRange(0, 40) = cv::Scalar(60, 80, 150);
      odds.colRange(0, 40) = 6.F;
      photograph(cv::Rect(5, 5, 20, 20)) = cv::Scalar(45, 45, 52);
      photograph(cv::Rect(40, 70, 40, 10)) = cv::Scalar(12, 12, 12);
      odds(cv::Rect(40, 70, 40, 10)) = 0.F;  // too dark to tell
      photographs.push_back(photograph);
      log_odds.push_back(odds);
    }
    log_odds[2](cv::Rect(5, 5, 20, 20)) = -1.F;  // the third photograph is in doubt of the patch
    for (int k = 0; k < 3; ++k)
      views.push_back({photographs[k], cv::Mat1b(20, 20, uchar{1}), cv::Mat1b(20, 20, uchar{255}),
                       cv::Mat1b(), cv::Mat1b(), &log_odds[k]});
  }
};

TEST(ColourModel, OnePhotographsDoubtIsSettledByTheOthers) {
  Sides sides;
  sharpenByColours(sides.views, 4, 1);
  EXPECT_GT(sides.log_odds[2](15, 15), 1);
}

TEST(ColourModel, DarkNeutralPixelsBesideABrightSherdAreShadow) {
  Sides sides;
  sharpenByColours(sides.views, 4, 1);
  for (const cv::Mat1f& odds : sides.log_odds) EXPECT_LT(odds(75, 60), -1);
}

TEST(ColourModel, TheHullsFootTeachesNothingOfTheSherd) {
  Sides sides;
  for (ColourView& view : sides.views) view.core.setTo(0);
  sharpenByColours(sides.views, 4, 1);
  EXPECT_EQ(sides.log_odds[2](15, 15), -1);
}

// A tall sherd before a blue table: the hull, which is too wide there, reaches from 40 to 60 pixels
// over what no plate lies behind, and the sherd fills the upper half of it.
TEST(ColourModel, BeforeWhatLiesBeyondThePlateThatPhotographsOwnColoursCount) {
  Sides sides;
  for (int k = 0; k < 3; ++k) {
    sides.photographs[k].colRange(40, 80) = cv::Scalar(150, 60, 40);
    sides.photographs[k](cv::Rect(40, 0, 20, 40)) = cv::Scalar(60, 80, 150);
    sides.log_odds[k].colRange(40, 80) = 0.F;
    sides.views[k].group.colRange(15, 20) = uchar{0};
    sides.views[k].beyond = cv::Mat1b(20, 20, uchar{0});
    sides.views[k].beyond.colRange(10, 20) = uchar{255};
  }
  sharpenByColours(sides.views, 4, 1);
  for (const cv::Mat1f& odds : sides.log_odds) {
    EXPECT_GT(odds(20, 50), 1);
    EXPECT_LT(odds(60, 50), -1);
    EXPECT_EQ(odds(60, 70), 0) << "beside the hull nothing is asked";
    EXPECT_EQ(odds(20, 41), 0) << "in the cells along the plate's edge colours say nothing";
  }
}

// A plate with black ink in its lower half, seen to the right of a dark sherd. The evidence is in
// doubt of two places: of ink, and of the sherd.
TEST(ColourModel, BeforeInkDarknessIsNoSignOfADarkSherd) {
  for (const bool known : {false, true}) {
    Sides sides;
    for (int k = 0; k < 3; ++k) {
      sides.photographs[k].colRange(0, 40) = cv::Scalar(30, 30, 34);
      sides.photographs[k](cv::Rect(40, 40, 40, 40)) = cv::Scalar(30, 30, 34);
      sides.photographs[k](cv::Rect(48, 52, 4, 4)) = cv::Scalar(110, 110, 110);  // paper in the ink
      sides.log_odds[k] = 6.F;
      sides.log_odds[k].colRange(40, 80) = -6.F;
      sides.log_odds[k](cv::Rect(60, 60, 8, 8)) = 0.F;
      sides.log_odds[k](cv::Rect(20, 60, 8, 8)) = 0.F;
      if (!known) continue;
      sides.views[k].ink = cv::Mat1b(80, 80, uchar{0});
      sides.views[k].ink(cv::Rect(40, 40, 40, 40)) = uchar{255};
    }
    sharpenByColours(sides.views, 4, 1);
    for (const cv::Mat1f& odds : sides.log_odds) {
      EXPECT_GT(odds(64, 24), known ? 2 : -1) << "before paper a dark place is the sherd's";
      if (known) {
        EXPECT_NEAR(odds(64, 64), std::log(1.3), 0.1)
            << "the sherd's colour as often; kShadows of ink more below it";
      }
    }
  }
}

TEST(ColourModel, IsTheSameForAnyNumberOfThreads) {
  Sides one, many;
  sharpenByColours(one.views, 4, 1);
  sharpenByColours(many.views, 4, 3);
  for (int k = 0; k < 3; ++k)
    EXPECT_EQ(cv::countNonZero(one.log_odds[k] != many.log_odds[k]), 0) << k;
}

}  // namespace
}  // namespace ostraka::mask
