#include "mask/evidence.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "ground/plate_picture.h"

namespace ostraka::mask {
namespace {

constexpr int kSize = 120;
const cv::Rect kMiddle(40, 40, 40, 40);

// A grey plate of 100 levels, lit or in a shadow; everything in levels, before any noise.
cv::Mat1f plate() {
  return cv::Mat1f(kSize, kSize, 100.F);
}

cv::Mat1f inShadow() {
  cv::Mat1f levels = plate();
  cv::Mat1f shadow(kSize, kSize, 1.F);
  shadow(cv::Rect(20, 20, 80, 80)) = 0.5F;
  cv::GaussianBlur(shadow, shadow, {}, 6);
  return levels.mul(shadow);
}

// As a camera gives it: blurred by the lens, then noisy, the same in all channels.
cv::Mat3f photographed(const cv::Mat1f& levels, int seed) {
  cv::Mat1f seen, noise(levels.size());
  cv::GaussianBlur(levels, seen, {}, 0.7);
  cv::RNG random(seed);
  random.fill(noise, cv::RNG::NORMAL, 0.F, 1.F);
  seen += noise;
  cv::Mat3b bytes;
  cv::Mat1b grey;
  seen.convertTo(grey, CV_8U);
  cv::cvtColor(grey, bytes, cv::COLOR_GRAY2BGR);
  return smoothed(ground::logColours(bytes));
}

// Mean log odds of the middle.
double oddsOf(const cv::Mat1f& levels) {
  const cv::Mat3f bare = photographed(plate(), 1);
  const ResidualNoise noise =
      measureNoise(photographed(plate(), 2) - bare, bare, 0.5F, cv::Mat1b(bare.size(), 255));
  const Evidence evidence = weighEvidence(photographed(levels, 3) - bare, bare, noise, 0.5F);
  return cv::mean(evidence.log_odds(kMiddle))[0];
}

TEST(Evidence, ShadowOnThePlateIsPlate) {
  EXPECT_LT(oddsOf(plate()), -2);
  EXPECT_LT(oddsOf(inShadow()), -2);
}

TEST(Evidence, GrainTellsGreyClayFromShadow) {
  cv::Mat1f levels = inShadow(), grain(levels.size());
  cv::RNG random(7);
  random.fill(grain, cv::RNG::NORMAL, 0.F, 8.F);
  cv::GaussianBlur(grain, grain, {}, 0.8);
  grain.setTo(0, inShadow() > 51);
  EXPECT_GT(oddsOf(levels + grain), oddsOf(levels) + 4);
}

// White clay on a white sheet has its colour; only its grain is its own.
TEST(Evidence, StrongGrainTellsClayOfThePlatesOwnColour) {
  cv::Mat1f levels = plate(), grain(levels.size());
  cv::RNG random(7);
  random.fill(grain, cv::RNG::NORMAL, 0.F, 14.F);
  cv::GaussianBlur(grain, grain, {}, 0.8);
  cv::Mat1f middle(levels.size(), 0.F);
  grain(kMiddle).copyTo(middle(kMiddle));
  EXPECT_GT(oddsOf(levels + middle), 0);
}

// A camera that sharpens leaves more noise in shadows than the lit plate lets expect. It is
// measured where the plate lies bare in them, at each depth by itself.
TEST(Evidence, MeasuresTheNoiseOfShadowsWhereThePlateLiesBareInThem) {
  const auto noisy = [](int seed) {
    cv::Mat1f levels = inShadow(), grain(levels.size());
    cv::RNG random(seed);
    random.fill(grain, cv::RNG::NORMAL, 0.F, 3.F);
    grain.setTo(0, inShadow() > 0.7F * plate());
    return cv::Mat1f(levels + grain);
  };
  const cv::Mat3f bare = photographed(inShadow(), 1), seen = photographed(noisy(2), 3);
  const cv::Mat1b everywhere(bare.size(), 255), shade = inShadow() < 0.9F * plate();
  const ResidualNoise unaware = measureNoise(seen - bare, bare, 0.5F, everywhere);
  const ResidualNoise noise = measureNoise(seen - bare, bare, 0.5F, everywhere, shade);
  EXPECT_FLOAT_EQ(unaware.shadeTexture(0.6F), 1);
  EXPECT_FLOAT_EQ(noise.shadeTexture(0), 1);
  EXPECT_GT(noise.shadeTexture(0.6F), 2);
  EXPECT_NEAR(noise.shadeTexture(1.3F), 1, 0.01) << "shot noise explains what is darker";
  const cv::Mat3f residual = photographed(noisy(4), 5) - bare;
  const double before = cv::mean(weighEvidence(residual, bare, unaware, 0.5F).log_odds(kMiddle))[0];
  const double after = cv::mean(weighEvidence(residual, bare, noise, 0.5F).log_odds(kMiddle))[0];
  EXPECT_LT(after, before - 1);
}

// Where a sherd meets the plate hardly any light comes in: a narrow dark line, straight over a
// window's length. It is no grain.
TEST(Evidence, DarkLineBesideASherdIsNoGrain) {
  cv::Mat1f levels = inShadow();
  cv::line(levels, {20, 56}, {100, 64}, 20.F, 3, cv::LINE_AA);
  EXPECT_LT(oddsOf(levels), -2);
}

}  // namespace
}  // namespace ostraka::mask
