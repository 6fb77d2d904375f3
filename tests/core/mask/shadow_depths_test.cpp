#include "mask/shadow_depths.h"

#include <gtest/gtest.h>

#include <cmath>

#include "ground/plate_picture.h"

namespace ostraka::mask {
namespace {

// A plate of level 200, a fifth of it in shadows of up to `deepest` (log), and a hull in the last
// columns whose clay is as dark as `clay`.
struct ShadedPlate {
  ShadedPlate(float deepest, uchar clay)
      : residual(100, 100, cv::Vec3f::all(0)),
        group(100, 100, uchar{0}),
        plate(100, 100, uchar{255}),
        photograph(100, 100, CV_8UC3, cv::Scalar::all(200)),
        log_odds(100, 100, -5.F) {
    for (int y = 0; y < 100; ++y)
      for (int x = 0; x < 20; ++x)
        residual(y, x) = cv::Vec3f::all(-deepest * static_cast<float>(y + 1) / 100);
    group.colRange(80, 100) = 1;
    log_odds.colRange(80, 100) = 5;
    photograph.colRange(80, 100).setTo(cv::Scalar::all(clay));
  }
  ShadowDepths learnt() const {
    const ShadowSight sight{residual, group, plate, photograph, log_odds};
    return learnShadowDepths(std::span(&sight, 1), 1);
  }
  cv::Mat3f residual;
  cv::Mat1b group, plate;
  cv::Mat photograph;
  cv::Mat1f log_odds;
};

float shadeOddsAt(const ShadowDepths& depths, float darkness, uchar level) {
  cv::Mat1f odds(1, 1, 0.F);
  depths.addTo(odds, cv::Mat3f(1, 1, cv::Vec3f::all(-darkness)),
               cv::Mat(1, 1, CV_8UC3, cv::Scalar::all(level)));
  return odds(0, 0);
}

TEST(ShadowDepths, WhatIsFarDarkerThanTheShadowsBesideIsClay) {
  const ShadowDepths depths = ShadedPlate(0.4F, 30).learnt();
  EXPECT_FLOAT_EQ(shadeOddsAt(depths, 0.3F, 30), 0);  // as deep as seen
  EXPECT_FLOAT_EQ(shadeOddsAt(depths, 1.1F, 30),
                  0);  // at a foot they are up to three times as deep
  EXPECT_GT(shadeOddsAt(depths, 2, 30), 2);
  EXPECT_GT(shadeOddsAt(depths, 9, 30), 2);
}

TEST(ShadowDepths, DeepShadowsLeaveNothingToSay) {
  EXPECT_FLOAT_EQ(shadeOddsAt(ShadedPlate(2.5F, 30).learnt(), 2.2F, 30), 0);
}

TEST(ShadowDepths, WhatIsDarkerThanAnyClayIsNone) {
  const ShadowDepths depths = ShadedPlate(0.4F, 60).learnt();
  EXPECT_LT(depths.darkest_clay, std::log(60 + ground::kDarkLevel));
  EXPECT_GT(shadeOddsAt(depths, 2, 60), 2);
  EXPECT_FLOAT_EQ(shadeOddsAt(depths, 2, 20), 0);
}

TEST(ShadowDepths, ColouredAndBrightPixelsBesideTheHullAreNoShadows) {
  ShadedPlate scene(0.4F, 30);
  scene.residual.colRange(20, 60).setTo(cv::Scalar(-2.5F, -1.5F, -0.5F));  // a tag
  scene.residual.colRange(60, 70).setTo(cv::Scalar::all(2));
  EXPECT_GT(shadeOddsAt(scene.learnt(), 2, 30), 2);
}

TEST(ShadowDepths, NeverSpeakOfWhatIsLit) {
  const ShadowDepths depths = ShadedPlate(0.4F, 30).learnt();
  EXPECT_FLOAT_EQ(shadeOddsAt(depths, -1, 250), 0);
  EXPECT_FLOAT_EQ(shadeOddsAt(depths, 0, 250), 0);
}

TEST(ShadowDepths, OfLastingShadeAreThoseThatTheSheetShows) {
  ground::SheetPicture sheet;
  EXPECT_FLOAT_EQ(shadeOddsAt(depthsOfLastingShade(sheet), 3, 30), 0) << "nothing is known";
  sheet.shade = cv::Mat1b(60, 60, uchar{0});
  sheet.correction = cv::Mat3f(60, 60, cv::Vec3f::all(-3));  // of stains, which are no shade
  sheet.shade.colRange(10, 30) = 255;
  for (int x = 10; x < 30; ++x)
    sheet.correction.col(x).setTo(cv::Scalar::all(-0.05 * (x - 9)));  // to -1
  const ShadowDepths depths = depthsOfLastingShade(sheet);
  EXPECT_FLOAT_EQ(shadeOddsAt(depths, 0.9F, 30), 0);
  EXPECT_FLOAT_EQ(shadeOddsAt(depths, 1.35F, 30), 0) << "half as deep again towards the foot";
  EXPECT_GT(shadeOddsAt(depths, 1.8F, 30), 2);
  EXPECT_GT(shadeOddsAt(depths, 1.8F, 1), 2) << "whatever clay is like";
}

}  // namespace
}  // namespace ostraka::mask
