#include "ground/sheet_rest.h"

#include <gtest/gtest.h>

namespace ostraka::ground {
namespace {

TEST(MayBeShadow, IsNoBrighterThanPaperAndNotDarkerThanATenth) {
  for (const float g : {0.119F, 0.F, -0.3F, -2.19F})
    EXPECT_TRUE(mayBeShadow(cv::Vec3f::all(g))) << g;
  for (const float g : {0.13F, 0.5F, -2.21F, -4.F})
    EXPECT_FALSE(mayBeShadow(cv::Vec3f::all(g))) << g;
}

// Off grey by d, 0, -d: 1.414 d, which may be 0.04 and half of the darkening.
TEST(MayBeShadow, HasTheColourOfItsLight) {
  const auto tinted = [](float g, float d) { return mayBeShadow({g + d, g, g - d}); };
  EXPECT_TRUE(tinted(0, 0.028F));
  EXPECT_FALSE(tinted(0, 0.029F));
  EXPECT_TRUE(tinted(-1, 0.38F));  // 0.537 of 0.54
  EXPECT_FALSE(tinted(-1, 0.385F));
}

class Shadows : public testing::Test {
 protected:
  static constexpr int kPhotographs = 5;
  Shadows() {
    for (int i = 0; i < kPhotographs; ++i) rests_.emplace_back(40, 40, cv::Vec3s(0, 0, 0));
  }
  void darken(int photograph, const cv::Rect& where, short thousandths) {
    rests_[static_cast<std::size_t>(photograph)](where).setTo(cv::Scalar::all(thousandths));
  }
  std::vector<SheetRest> rests_;
  cv::Mat1b paper_ = cv::Mat1b(80, 80, uchar{255});
};

TEST_F(Shadows, ThatStayAreOfALightThatStandsStill) {
  EXPECT_TRUE(lightStandsStill(rests_, paper_)) << "there are none";
  for (int i = 0; i < kPhotographs; ++i) darken(i, {10, 12, 8, 8}, -500);
  EXPECT_TRUE(lightStandsStill(rests_, paper_));
}

TEST_F(Shadows, ThatWanderAreOfALightThatTurns) {
  for (int i = 0; i < kPhotographs; ++i) darken(i, {1 + 7 * i, 12, 6, 6}, -500);
  EXPECT_FALSE(lightStandsStill(rests_, paper_));
  paper_.setTo(0);
  EXPECT_TRUE(lightStandsStill(rests_, paper_)) << "off the paper nothing is known";
}

// What one person moved on the sheet is no sun that wanders.
TEST_F(Shadows, AreJudgedByTheLargerPart) {
  for (int i = 0; i < kPhotographs; ++i) darken(i, {10, 12, 12, 12}, -500);
  darken(0, {30, 30, 8, 8}, -500);
  EXPECT_TRUE(lightStandsStill(rests_, paper_));
}

// Clay has grain, a shadow is even; and a spot of a few cells is none of either.
TEST_F(Shadows, AreNotTheGrainOfClayNorSpecks) {
  for (int i = 0; i < kPhotographs; ++i)
    for (int y = 0; y < 6; ++y)
      for (int x = 0; x < 6; ++x)
        darken(i, {1 + 7 * i + x, 12 + y, 1, 1}, (x + y) % 2 == 0 ? -500 : -560);
  EXPECT_TRUE(lightStandsStill(rests_, paper_));
  for (SheetRest& rest : rests_) rest.setTo(cv::Scalar::all(0));
  darken(2, {20, 20, 3, 3}, -500);  // one cell with its neighbours alike, of 7220 looks
  EXPECT_TRUE(lightStandsStill(rests_, paper_));
}

TEST_F(Shadows, AreNoneWhereNothingIsSeen) {
  for (SheetRest& rest : rests_) rest.setTo(cv::Scalar(kNoRest[0], kNoRest[1], kNoRest[2]));
  EXPECT_FALSE(isKnown(rests_[0](5, 5)));
  EXPECT_TRUE(lightStandsStill(rests_, paper_));
}

}  // namespace
}  // namespace ostraka::ground
