#include "stereo/window.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ostraka::stereo {
namespace {

/// A frame through a camera at the origin; grey by a function of the pixel.
template <class Grey>
Frame frameOf(Grey grey) {
  View view;
  view.camera.intrinsics = {64, 48, 100, 100, 31.5, 23.5, {}};
  view.photograph = cv::Mat(48, 64, CV_8UC3);
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 64; ++x) {
      const auto value = static_cast<std::uint8_t>(std::lround(grey(x, y)));
      view.photograph.at<cv::Vec3b>(y, x) = {value, value, value};
    }
  return buildPyramid(view, 1).front();
}

double waves(double x, double y) {
  return 120 + 40 * std::sin(0.9 * x + 0.3 * y) + 30 * std::sin(1.1 * y - 0.2 * x);
}

constexpr AffineMap kSame{30, 20, 1, 0, 0, 1};

TEST(Window, OfTheSamePictureDiffersByNothing) {
  const Frame frame = frameOf(waves);
  Window window;
  ASSERT_TRUE(cutWindow(frame, 30, 20, window));
  EXPECT_NEAR(dissimilarity(window, frame, kSame), 0.0, 0.01);
}

TEST(Window, DoesNotMindGainAndOffset) {
  const Frame frame = frameOf(waves);
  const Frame darker = frameOf([](double x, double y) { return 0.5 * waves(x, y) + 30; });
  Window window;
  ASSERT_TRUE(cutWindow(frame, 30, 20, window));
  EXPECT_NEAR(dissimilarity(window, darker, kSame), 0.0, 0.02);
}

TEST(Window, OfTheNegativeDiffersByTwo) {
  const Frame frame = frameOf(waves);
  const Frame negative = frameOf([](double x, double y) { return 250 - waves(x, y); });
  Window window;
  ASSERT_TRUE(cutWindow(frame, 30, 20, window));
  EXPECT_NEAR(dissimilarity(window, negative, kSame), 2.0, 0.02);
}

TEST(Window, FindsAShiftBetweenThePixels) {
  const Frame frame = frameOf(waves);
  const Frame shifted = frameOf([](double x, double y) { return waves(x - 1.4, y + 0.7); });
  Window window;
  ASSERT_TRUE(cutWindow(frame, 30, 20, window));
  const float right = dissimilarity(window, shifted, {31.4F, 19.3F, 1, 0, 0, 1});
  EXPECT_LT(right, 0.02F);
  EXPECT_GT(dissimilarity(window, shifted, {31.9F, 19.3F, 1, 0, 0, 1}), right + 0.02F);
}

TEST(Window, OutsideTheOtherPictureSaysNothing) {
  const Frame frame = frameOf(waves);
  Window window;
  ASSERT_TRUE(cutWindow(frame, 30, 20, window));
  EXPECT_LT(dissimilarity(window, frame, {-20, 20, 1, 0, 0, 1}), 0.0F);
  EXPECT_LT(dissimilarity(window, frame, {1e6F, -1e6F, 1, 0, 0, 1}), 0.0F);
}

}  // namespace
}  // namespace ostraka::stereo
