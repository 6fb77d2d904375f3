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

}  // namespace
}  // namespace ostraka::stereo
