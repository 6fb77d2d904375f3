#include "mask/outline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <random>
#include <utility>

namespace ostraka::mask {
namespace {

// Linear light to sRGB, 0..255.
double encoded(double linear) {
  const double v = linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
  return 255 * v;
}

TEST(Outline, TheSoftEdgeLiesWhereTheLightIsMixedInHalves) {
  // A straight edge at x = 30.3 between clay and a dark plate: pixel 30 covers [29.5, 30.5] and is
  // 0.8 sherd. The crossing of 127.5 must come out at 30.3 however bright the sides are.
  const double edge = 30.3, clay = 0.5, ground = 0.02;
  cv::Mat photograph(40, 60, CV_8UC3);
  cv::Mat1b cut(40, 60, uchar{0});
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 60; ++x) {
      const double share = std::clamp(edge - (x - 0.5), 0.0, 1.0);
      const double v = encoded(share * clay + (1 - share) * ground);
      photograph.at<cv::Vec3b>(y, x) = cv::Vec3b::all(cv::saturate_cast<uchar>(v));
      if (x <= 31 && y > 2 && y < 37) cut(y, x) = 255;  // a pixel too wide
    }
  const cv::Mat1b soft = softenOutline(cut, photograph);
  int x = 29;
  while (soft(20, x + 1) >= 127.5) ++x;
  const double t = (soft(20, x) - 127.5) / (soft(20, x) - soft(20, x + 1));
  EXPECT_NEAR(x + t, 30.3, 0.15);
}

TEST(Outline, TheSoftEdgeStaysWhereThePlateDarkensTowardsTheContact) {
  // As above on a grey plate, blurred by the lens; the contact shadow leaves half of the light at
  // the edge and fades over 4 pixels. Half a pixel of bias would cost a small sherd 2 % of its
  // area.
  const double edge = 30.3, clay = 0.4, ground = 0.15;
  cv::Mat1d light(40, 240);  // four samples a pixel
  for (int x = 0; x < 240; ++x) {
    const double p = (x - 1.5) / 4;
    light.col(x) = p < edge ? clay : ground * (1 - 0.5 * std::exp(-(p - edge) / 4));
  }
  cv::GaussianBlur(light, light, {}, 2.8, 0.1);  // 0.7 pixels
  cv::resize(light, light, {60, 40}, 0, 0, cv::INTER_AREA);
  cv::Mat photograph(40, 60, CV_8UC3);
  cv::Mat1b cut(40, 60, uchar{0});
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 60; ++x) {
      photograph.at<cv::Vec3b>(y, x) =
          cv::Vec3b::all(cv::saturate_cast<uchar>(encoded(light(y, x))));
      if (x <= 31 && y > 2 && y < 37) cut(y, x) = 255;
    }
  const cv::Mat1b soft = softenOutline(cut, photograph);
  int x = 28;
  while (soft(20, x + 1) >= 127.5) ++x;
  const double t = (soft(20, x) - 127.5) / (soft(20, x) - soft(20, x + 1));
  EXPECT_NEAR(x + t, 30.3, 0.25);
}

// A square sherd on a plate, its last half pixel darker by `shade` on all sides but the upper one;
// where the outline crosses its middle on the upper and on the lower side after both passes.
std::pair<double, double> heightsOfOutline(double shade, const cv::Vec2f& up) {
  const double top = 20.3, bottom = 50.3, clay = 0.4, ground = 0.06;
  cv::Mat1d light(8 * 72, 8 * 72);
  for (int y = 0; y < light.rows; ++y)
    for (int x = 0; x < light.cols; ++x) {
      const double px = (x - 3.5) / 8, py = (y - 3.5) / 8;
      const bool inside = px > top && px < bottom && py > top && py < bottom;
      const double foot = std::min({px - top, bottom - px, bottom - py});
      light(y, x) = !inside ? ground : foot < 0.5 ? clay * (1 - shade) : clay;
    }
  cv::resize(light, light, {72, 72}, 0, 0, cv::INTER_AREA);
  cv::Mat photograph(72, 72, CV_8UC3);
  cv::Mat1b cut(72, 72, uchar{0});
  for (int y = 0; y < 72; ++y)
    for (int x = 0; x < 72; ++x) {
      photograph.at<cv::Vec3b>(y, x) =
          cv::Vec3b::all(cv::saturate_cast<uchar>(encoded(light(y, x))));
      if (x >= 20 && x <= 51 && y >= 20 && y <= 51) cut(y, x) = 255;
    }
  const cv::Mat1b soft = refineOutline(softenOutline(cut, photograph), photograph, up);
  int first = 10, last = 35;
  while (soft(first + 1, 35) < 127.5) ++first;
  while (soft(last + 1, 35) >= 127.5) ++last;
  const auto crossing = [&](int y) {
    const double a = soft(y, 35), b = soft(y + 1, 35);
    return y + (127.5 - a) / (b - a);
  };
  return {crossing(first), crossing(last)};
}

TEST(Outline, TheUpperRimLiesWhereTheLightIsMixedInHalves) {
  const auto [top, bottom] = heightsOfOutline(0, {0, -1});
  EXPECT_NEAR(top, 20.3, 0.1);
  // The lower side is taken for a foot; light that is not missing there costs a fifth of a pixel.
  EXPECT_NEAR(bottom, 50.3, 0.25);
}

TEST(Outline, TheSherdsDarkFootIsSherdStill) {
  const auto [top, bottom] = heightsOfOutline(0.5, {0, -1});
  EXPECT_NEAR(top, 20.3, 0.1);
  EXPECT_NEAR(bottom, 50.3, 0.1);
}

TEST(Outline, WithoutContrastTheCutStays) {
  const cv::Mat photograph(40, 60, CV_8UC3, cv::Scalar::all(90));
  cv::Mat1b cut(40, 60, uchar{0});
  cut.colRange(10, 30) = 255;
  const cv::Mat1b soft = softenOutline(cut, photograph);
  EXPECT_GE(soft(20, 29), 128);
  EXPECT_LT(soft(20, 30), 128);
}

TEST(Outline, TheCutFollowsTheContrastWhereTheEvidenceIsWeak) {
  cv::Mat1f odds(40, 60, 0.F);
  cv::Mat3f residual(40, 60, cv::Vec3f::all(0));
  std::mt19937 random(5);
  std::normal_distribution<float> noise(0, 0.02F);
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 60; ++x) {
      odds(y, x) = x < 15 ? 5.F : x > 45 ? -5.F : 0.F;
      residual(y, x) = cv::Vec3f::all((x < 27 ? 0.5F : 0.F) + noise(random));
    }
  const cv::Mat1b cut = cutOutline(odds, cv::Mat1b(40, 60, uchar{255}), residual, {});
  for (int y = 0; y < 40; ++y) {
    EXPECT_EQ(cut(y, 26), 255) << y;
    EXPECT_EQ(cut(y, 27), 0) << y;
  }
}

TEST(Outline, CrumbsAndPinholesBelowTheAreaGo) {
  cv::Mat1f odds(60, 80, -5.F);
  odds(cv::Rect(10, 10, 40, 40)) = 5.F;
  odds(cv::Rect(25, 25, 6, 6)) = -5.F;  // a hole of 36 pixels
  odds(cv::Rect(65, 20, 8, 8)) = 5.F;   // a crumb of 64 pixels
  const cv::Mat1b cut = cutOutline(odds, cv::Mat1b(60, 80, uchar{255}),
                                   cv::Mat3f(60, 80, cv::Vec3f::all(0)), {2.5, 100});
  EXPECT_EQ(cut(28, 28), 255);
  EXPECT_EQ(cut(24, 69), 0);
  EXPECT_EQ(cut(12, 12), 255);
}

// A sherd to x = 30 at least, perhaps to x = 37, beside lit plate: its residual by column, with
// grain.
int outlineBeside(float (*residual)(int)) {
  cv::Mat1b surely(60, 80, uchar{0}), perhaps(60, 80, uchar{0});
  cv::Mat3f residuals(60, 80);
  std::mt19937 random(1);
  std::normal_distribution<float> grain(0, 0.1F);
  for (int y = 0; y < 60; ++y)
    for (int x = 0; x < 80; ++x) {
      const bool row = y > 4 && y < 55;
      if (row && x > 4 && x <= 30) surely(y, x) = 255;
      if (row && x > 4 && x <= 37) perhaps(y, x) = 255;
      residuals(y, x) = cv::Vec3f::all(residual(x) + grain(random));
    }
  const cv::Mat1b settled = settleStrips(surely, perhaps, 12, residuals, {});
  int x = 20;
  while (settled(30, x + 1) != 0) ++x;
  return x;
}

TEST(Outline, AStripThatOnlyTheHullHoldsIsTheSherdsWhereItEndsSharply) {
  // A dark break, a little darker than the face: it ends where the lit plate begins.
  EXPECT_EQ(outlineBeside([](int x) { return x <= 30 ? -0.8F : x <= 37 ? -1.1F : 0.F; }), 37);
  // The plate in its contact shadow: sharp against the sherd, and fading.
  EXPECT_EQ(outlineBeside([](int x) {
              return x <= 30 ? 0.6F : -0.8F * std::max(0.F, 1 - static_cast<float>(x - 30) / 12);
            }),
            30);
}

TEST(Outline, WhatTheHullHoldsWiderThanAStripIsTheSherds) {
  cv::Mat1b surely(60, 80, uchar{0}), perhaps(60, 80, uchar{0});
  perhaps(cv::Rect(20, 10, 40, 40)) = 255;
  const cv::Mat3f residual(60, 80, cv::Vec3f::all(-1));
  EXPECT_GT(cv::countNonZero(settleStrips(surely, perhaps, 12, residual, {})), 1500);
  perhaps.setTo(0);
  perhaps(cv::Rect(20, 10, 40, 7)) = 255;
  EXPECT_EQ(cv::countNonZero(settleStrips(surely, perhaps, 12, residual, {})), 0);
}

}  // namespace
}  // namespace ostraka::mask
