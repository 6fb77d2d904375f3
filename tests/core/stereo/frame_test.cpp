#include "stereo/frame.h"

#include <gtest/gtest.h>

#include <cmath>

#include "stereo/stereo.h"

namespace ostraka::stereo {
namespace {

View viewOf(const cv::Mat1b& grey, const rig::Intrinsics& lens) {
  View view;
  view.camera.intrinsics = lens;
  view.camera.stop = 7;
  view.camera.camera_from_plate.translation() = Eigen::Vector3d(1, 2, 100);
  cv::merge(std::vector<cv::Mat>{grey, grey, grey}, view.photograph);
  return view;
}

cv::Mat1b rising(int width, int height) {
  cv::Mat1b grey(height, width);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) grey(y, x) = static_cast<unsigned char>(10 + 3 * x + 5 * y);
  return grey;
}

// A pixel of the next level covers four: its centre lies in their middle.
TEST(Frame, OfTheNextLevelSeesAPointWhereItsFourPixelsWent) {
  const auto pyramid = buildPyramid(viewOf(rising(31, 20), {31, 20, 50, 60, 15.2, 9.7, {}}), 3);
  ASSERT_EQ(pyramid.size(), 3u);
  EXPECT_EQ(pyramid[1].width, 15);
  EXPECT_EQ(pyramid[1].height, 10);
  EXPECT_EQ(pyramid[2].width, 7);
  const Eigen::Vector3f p(4, -3, 20);
  Eigen::Vector2f at = pyramid[0].project(pyramid[0].toCamera(p));
  EXPECT_NEAR(at.x(), 50 * 5 / 120.0 + 15.2, 1e-4);
  EXPECT_NEAR(at.y(), 60 * -1 / 120.0 + 9.7, 1e-4);
  for (const Frame& frame : {pyramid[1], pyramid[2]}) {
    at = (at + Eigen::Vector2f(0.5F, 0.5F)) / 2 - Eigen::Vector2f(0.5F, 0.5F);
    EXPECT_LT((frame.project(frame.toCamera(p)) - at).norm(), 1e-4);
    EXPECT_EQ(frame.light, 7);
    EXPECT_LT((frame.centre - Eigen::Vector3f(-1, -2, -100)).norm(), 1e-4);
  }
}

TEST(Frame, PacksFourNeighboursInOneWord) {
  const Frame frame = buildPyramid(viewOf(rising(16, 12), {16, 12, 50, 50, 7.5, 5.5, {}}), 1)[0];
  // A slope stays what it is under the blur: 10 + 3 * 5 + 5 * 4 and its neighbours.
  EXPECT_EQ(frame.packed[4 * 16 + 5], 45U | 48U << 8U | 50U << 16U | 53U << 24U);
  EXPECT_EQ(frame.packed[0] & 0xFFU, 0U) << "the border is outside";
  EXPECT_EQ(frame.packed[0] >> 24U, 18U);
  EXPECT_EQ(frame.packed[11 * 16 + 3], 0U) << "nothing lies below the last row";
}

// Else a sherd's outline would be as dark as what lies beside it, and match there.
TEST(Frame, ReadsNothingBesideTheMask) {
  cv::Mat1b grey(20, 40, static_cast<unsigned char>(0));
  grey.colRange(0, 20) = 100;
  View view = viewOf(grey, {40, 20, 50, 50, 19.5, 9.5, {}});
  view.mask = cv::Mat1b(grey.size(), static_cast<unsigned char>(0));
  view.mask.colRange(0, 20) = 255;
  for (const Frame& frame : buildPyramid(view, 2))
    for (int x = 1; x + 1 < frame.width; ++x)
      EXPECT_NEAR(frame.grey(5, x), x < frame.width / 2 ? 100 : 0, 1e-3) << x;
}

TEST(Frame, HasNoDistortion) {
  const rig::Intrinsics lens{200, 160, 100, 100, 99.5, 79.5, {{0.5}}};
  const Eigen::Vector3d p(0.3, 0.2, 1);
  const Eigen::Vector2d seen = lens.project(p);
  ASSERT_GT((seen - Eigen::Vector2d(129.5, 99.5)).norm(), 2) << "the lens bends";
  cv::Mat1b grey(160, 200);
  for (int y = 0; y < grey.rows; ++y)
    for (int x = 0; x < grey.cols; ++x)
      grey(y, x) = static_cast<unsigned char>(
          20 + 200 * std::exp(-(Eigen::Vector2d(x, y) - seen).squaredNorm() / 8));
  const Frame frame = buildPyramid(viewOf(grey, lens), 1)[0];
  cv::Point brightest;
  cv::minMaxLoc(frame.grey, nullptr, nullptr, nullptr, &brightest);
  EXPECT_LE(std::abs(brightest.x - 129.5), 1);
  EXPECT_LE(std::abs(brightest.y - 99.5), 1);
}

// The photograph of a spot of light that a lens draws to (8, 6), near the corner.
View cornerSpot(const rig::Distortion& lens) {
  cv::Mat1b grey(160, 200, static_cast<unsigned char>(20));
  for (int y = 0; y < grey.rows; ++y)
    for (int x = 0; x < grey.cols; ++x)
      grey(y, x) = static_cast<unsigned char>(
          20 + 200 * std::exp(-Eigen::Vector2d(x - 8, y - 6).squaredNorm() / 8));
  View view = viewOf(grey, {200, 160, 100, 100, 99.5, 79.5, lens});
  view.mask = cv::Mat1b(grey.size(), static_cast<unsigned char>(0));
  view.mask(cv::Rect(4, 2, 10, 10)) = 255;
  return view;
}

TEST(Frame, HasAPlaceForACornerThatTheLensDrewIn) {
  const rig::Distortion barrel{{-0.1}, rig::Lens::Standard};
  const rig::Distortion fisheye{{}, rig::Lens::Fisheye};
  for (const rig::Distortion& lens : {barrel, fisheye}) {
    const View view = cornerSpot(lens);
    const Eigen::Vector2d n = view.camera.intrinsics.unproject({8, 6});
    const Eigen::Vector2d straight(100 * n.x() + 99.5, 100 * n.y() + 79.5);
    ASSERT_LT(straight.maxCoeff(), -10) << "beyond the photograph";
    const cv::Rect whole = wholeOf(view);
    EXPECT_EQ(whole.x % 16, 0);
    EXPECT_EQ(whole.y % 16, 0);
    EXPECT_EQ(whole.br(), cv::Point(200, 160)) << "nothing of the object is there";
    const Frame frame = buildPyramid(view, 1)[0];
    EXPECT_EQ(cv::Size(frame.width, frame.height), whole.size());
    const Eigen::Vector2f at = frame.project(Eigen::Vector3d(n.x(), n.y(), 1).cast<float>());
    ASSERT_TRUE(frame.holds(at));
    cv::Point brightest;
    cv::minMaxLoc(frame.grey, nullptr, nullptr, nullptr, &brightest);
    // A pixel of the photograph is as large as 3 and 7 of these.
    EXPECT_NEAR(brightest.x, at.x(), 3);
    EXPECT_NEAR(brightest.y, at.y(), 3);
    EXPECT_EQ(outlineOf(view, 1).whole, whole);
  }
}

// Else what the photograph cut off would count as seen beside the object.
TEST(Frame, SaysNothingOfWhatLiesBeyondThePhotograph) {
  const View view = cornerSpot({{-0.1}, rig::Lens::Standard});
  for (const Frame& frame : buildPyramid(view, 2)) {
    const float scale = frame.fx / 100;
    const auto shows = [&](double x, double y) {
      const Eigen::Vector2d n = view.camera.intrinsics.unproject({x, y});
      return frame.shows({static_cast<float>(n.x()) * frame.fx + frame.cx,
                          static_cast<float>(n.y()) * frame.fy + frame.cy});
    };
    EXPECT_TRUE(shows(8, 6)) << scale;
    EXPECT_TRUE(shows(100, 80)) << scale;
    EXPECT_TRUE(frame.holds({2, 112 * scale}));
    EXPECT_FALSE(frame.shows({2, 112 * scale})) << "left of the photograph's left edge";
  }
  const Frame whole = buildPyramid(viewOf(rising(31, 20), {31, 20, 50, 60, 15.2, 9.7, {}}), 1)[0];
  EXPECT_TRUE(whole.shown.empty());
}

TEST(Frame, IsThePhotographsWhereTheObjectStaysWithin) {
  View view = cornerSpot({{-0.1}, rig::Lens::Standard});
  view.mask = cv::Mat1b(view.mask.size(), static_cast<unsigned char>(0));
  EXPECT_EQ(wholeOf(view), cv::Rect(0, 0, 200, 160)) << "no object";
  view.mask(cv::Rect(60, 60, 70, 40)) = 255;
  EXPECT_EQ(wholeOf(view), cv::Rect(0, 0, 200, 160));
  view.mask.release();
  view.camera.intrinsics.distortion = {};
  EXPECT_EQ(wholeOf(view), cv::Rect(0, 0, 200, 160)) << "no lens";
}

// r - 0.3 r^3 grows up to r = 1.054; at 1.3 it shows again what is at 0.78.
TEST(Frame, ShowsNothingBeyondTheFoldOfALens) {
  View view = viewOf(cv::Mat1b(160, 200, static_cast<unsigned char>(100)),
                     {200, 160, 100, 100, 99.5, 79.5, {{-0.3}, rig::Lens::Standard}});
  const Frame frame = buildPyramid(view, view.photograph, {-80, 0, 280, 160}, 1)[0];
  const auto coverageAt = [&](double r) {
    return frame.coverage(80, static_cast<int>(std::lround(99.5 - 100 * r)) + 80);
  };
  EXPECT_NEAR(coverageAt(1.0), 1, 1e-3);
  EXPECT_EQ(coverageAt(1.3), 0);
}

}  // namespace
}  // namespace ostraka::stereo
