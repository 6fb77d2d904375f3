#include "stereo/background.h"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

namespace ostraka::stereo {
namespace {

TEST(PossibleObject, IsTheLitThingWithItsShadowsAndAPixelAround) {
  cv::Mat photograph(100, 120, CV_8UC3, cv::Scalar::all(8));
  cv::rectangle(photograph, {30, 20, 50, 40}, cv::Scalar::all(150), cv::FILLED);
  cv::rectangle(photograph, {50, 40, 3, 3}, cv::Scalar::all(10), cv::FILLED);  // a hole in shadow
  const cv::Mat1b mask = possibleObject(photograph);
  EXPECT_EQ(mask(41, 51), 255);
  EXPECT_EQ(mask(20, 30), 255);
  EXPECT_EQ(mask(19, 40), 255);
  EXPECT_EQ(mask(10, 40), 0);
  EXPECT_EQ(mask(90, 110), 0);
}

TEST(PossibleObject, IsEverythingWhereTheBorderIsBright) {
  cv::Mat photograph(60, 80, CV_8UC3, cv::Scalar::all(180));
  cv::rectangle(photograph, {20, 20, 20, 20}, cv::Scalar::all(60), cv::FILLED);
  EXPECT_EQ(cv::countNonZero(possibleObject(photograph)), 60 * 80);
}

TEST(WholeBody, IsTheLargestPieceWithItsSoftEdgeAndWithoutHoles) {
  cv::Mat1b mask(60, 80, uchar{0});
  cv::rectangle(mask, {20, 15, 30, 25}, 255, cv::FILLED);
  cv::rectangle(mask, {30, 20, 4, 4}, 0, cv::FILLED);    // a hole
  cv::rectangle(mask, {70, 50, 5, 5}, 255, cv::FILLED);  // a spot elsewhere
  mask(25, 50) = 90;                                     // half a pixel beside the edge
  const cv::Mat1b body = wholeBody(mask);
  EXPECT_EQ(body(21, 31), 255) << "holes are filled";
  EXPECT_EQ(body(52, 72), 0) << "other pieces are left out";
  EXPECT_EQ(body(25, 50), 90) << "the soft edge stays as it is";
  EXPECT_EQ(body(5, 5), 0);
  EXPECT_EQ(cv::countNonZero(body == 255), 30 * 25);
}

TEST(WholeBody, IsNothingWhereNothingIsInside) {
  const cv::Mat1b body = wholeBody(cv::Mat1b(20, 30, uchar{127}));
  EXPECT_EQ(cv::countNonZero(body), 0);
}

TEST(IsEverything, HoldsForAMaskWithoutZeros) {
  cv::Mat1b mask(20, 30, uchar{1});
  EXPECT_TRUE(isEverything(mask));
  mask(19, 29) = 0;
  EXPECT_FALSE(isEverything(mask));
}

}  // namespace
}  // namespace ostraka::stereo
