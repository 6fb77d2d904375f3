#include "mask/coarse_heights.h"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>
#include <random>

namespace ostraka::mask {
namespace {

// 400 x 300 pixels, 500 mm above the ground, straight down: a pixel is 1 mm on the ground.
rig::PosedImage fromAbove() {
  rig::PosedImage image;
  image.intrinsics = {400, 300, 500, 500, 199.5, 149.5, {}};
  image.camera_from_plate.linear() =
      Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX()).toRotationMatrix();
  image.camera_from_plate.translation().z() = 500;
  return image;
}

// A block of 80 x 60 mm and 20 mm height on a ground of 200 x 160 mm that scatters by 0.5 mm. Its
// top is smooth: nothing was found there but along the rim, 10 mm wide.
PointCloud block() {
  std::mt19937 random(2);
  std::normal_distribution<float> noise(0, 0.5F);
  PointCloud cloud;
  for (int x = -100; x <= 100; ++x)
    for (int y = -80; y <= 80; ++y) {
      const bool on_block = std::abs(x) <= 40 && std::abs(y) <= 30;
      const bool smooth = std::abs(x) < 30 && std::abs(y) < 20;
      if (!smooth)
        cloud.points.emplace_back(static_cast<float>(x), static_cast<float>(y),
                                  (on_block ? 20 : 0) + noise(random));
    }
  return cloud;
}

cv::Mat1b shownFromAbove(const PointCloud& cloud, Gaps gaps = Gaps::Filled) {
  return shownBy(cloud, heightsAbove(cloud, {}), fromAbove(), 2, gaps);
}

TEST(CoarseHeights, WhatIsRaisedLiesFourDeviationsAboveTheGround) {
  EXPECT_NEAR(leastRaised(heightsAbove(block(), {}), 5), 2, 0.1);
  EXPECT_EQ(leastRaised({}, 5), 0);
}

TEST(CoarseHeights, WhatIsRaisedIsToldThoughThinSherdsCoverMostOfTheGround) {
  std::mt19937 random(3);
  std::normal_distribution<float> noise(0, 0.5F);
  std::vector<float> heights;
  for (int k = 0; k < 10000; ++k) heights.push_back((k % 4 == 0 ? 0.F : 4.F) + noise(random));
  EXPECT_NEAR(leastRaised(heights, 5), 2, 0.15);
}

TEST(CoarseHeights, ShowTheBlockWholeAndTheGroundAroundItAndNothingBeyond) {
  const cv::Mat1b shown = shownFromAbove(block());
  ASSERT_EQ(shown.size(), cv::Size(400, 300));
  // 20 mm nearer to the camera the block is larger by 500 / 480.
  const double expected = 81.0 * 61 * (500.0 / 480) * (500.0 / 480);
  EXPECT_NEAR(cv::countNonZero(shown == kRaisedShown), expected, 0.06 * expected);
  EXPECT_EQ(shown(150, 200), kRaisedShown) << "the smooth middle is enclosed";
  EXPECT_EQ(shown(150, 260), kGroundShown);
  EXPECT_EQ(shown(150, 350), kNothingShown);
}

TEST(CoarseHeights, ShowNothingWhereNoPointLiesIfGapsAreLeft) {
  const cv::Mat1b shown = shownFromAbove(block(), Gaps::Left);
  EXPECT_EQ(shown(150, 200), kNothingShown);
  EXPECT_EQ(shown(150, 200 + 36), kRaisedShown);
  EXPECT_EQ(shown(150, 260), kGroundShown);
}

// Two blocks behind each other, and the gap between them filled by windows that reach over it.
TEST(CoarseHeights, ShowNothingWhereDepthJumpsIfGapsAreLeft) {
  PointCloud cloud;
  for (int x = -60; x <= 60; ++x)
    for (int y = -40; y <= 40; ++y)
      cloud.points.emplace_back(static_cast<float>(x), static_cast<float>(y), x < 0 ? 20.F : 50.F);
  const cv::Mat1b left = shownFromAbove(cloud, Gaps::Left);
  EXPECT_EQ(left(150, 170), kRaisedShown);
  EXPECT_EQ(left(150, 230), kRaisedShown);
  EXPECT_EQ(left(150, 198), kNothingShown);
  EXPECT_EQ(left(150, 202), kNothingShown);
  EXPECT_EQ(shownFromAbove(cloud)(150, 198), kRaisedShown) << "where nothing else tells";
}

TEST(CoarseHeights, LieAboveABentSheet) {
  rig::SheetBend bend;
  bend.reach_mm = 100;
  bend.coefficients_mm[0] = 3;
  PointCloud cloud;
  cloud.points = {{50, 20, static_cast<float>(bend.at(50, 20))}, {0, 0, 7}};
  const std::vector<float> heights = heightsAbove(cloud, bend);
  EXPECT_NE(bend.at(50, 20), 0);
  EXPECT_NEAR(heights[0], 0, 1e-5);
  EXPECT_NEAR(heights[1], 7 - bend.at(0, 0), 1e-5);
}

TEST(CoarseHeights, SayNothingAlongTheEdge) {
  const cv::Mat1b shown = shownFromAbove(block());
  const cv::Mat1f odds = heightsShown(shown, {800, 600});
  ASSERT_EQ(odds.size(), cv::Size(400, 300));
  EXPECT_GT(odds(150, 200), 3);
  EXPECT_LT(odds(150, 260), -3);
  const int edge = 200 + 42;
  EXPECT_EQ(odds(150, edge), 0);
  EXPECT_EQ(odds(150, 350), 0);
}

// Cells of a grid that a photograph of twice the size shows at every other pixel.
TEST(CoarseHeights, CoverTheCellsBehindWhatIsRaised) {
  const cv::Mat1b shown = shownFromAbove(block());
  cv::Mat2f pixels(300, 400);
  for (int y = 0; y < pixels.rows; ++y)
    for (int x = 0; x < pixels.cols; ++x) pixels(y, x) = cv::Vec2f(2.F * x, 2.F * y);
  pixels(150, 201) = cv::Vec2f(-5, -5);  // it shows this one nowhere
  const cv::Mat1b covered = coveredCells(shown, {800, 600}, pixels);
  EXPECT_EQ(covered(150, 200), 255);
  EXPECT_EQ(covered(150, 201), 0);
  EXPECT_EQ(covered(150, 260), 0);
}

TEST(CoarseHeights, IgnoreSinglePointsInTheAir) {
  PointCloud cloud = block();
  cloud.points.emplace_back(70.F, 60.F, 30.F);
  EXPECT_EQ(cv::countNonZero(shownFromAbove(cloud) != shownFromAbove(block())), 0)
      << "and the ground below it is closed again";
}

}  // namespace
}  // namespace ostraka::mask
