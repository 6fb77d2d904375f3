#include "capture/silhouettes.h"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

namespace ostraka::capture {
namespace {

// Corners in mm; half a millimetre a pixel.
MapPiece pieceOf(const std::vector<cv::Point>& corners_mm) {
  cv::Mat1b mask(200, 300, uchar{0});
  std::vector<cv::Point> corners;
  for (const cv::Point& p : corners_mm) corners.push_back(2 * p + cv::Point(20, 20));
  cv::fillPoly(mask, std::vector<std::vector<cv::Point>>{corners}, 255);
  std::vector<std::vector<cv::Point>> outlines;
  cv::findContours(mask, outlines, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
  return {.outline = outlines.at(0), .area_mm2 = cv::contourArea(outlines[0]) / 4};
}

TEST(MayBeSeveral, DoubtsTwoSherdsThatLieSideBySideWithoutAWaist) {
  // Two of 40 x 30 mm that touch along 24 mm: 0.91 of their hull, and the neck is 0.8 of a width.
  EXPECT_TRUE(mayBeSeveral(
      pieceOf({{0, 0}, {40, 0}, {40, 6}, {80, 6}, {80, 36}, {40, 36}, {40, 30}, {0, 30}})));
  // The same with one step only, and a plain one.
  EXPECT_FALSE(mayBeSeveral(pieceOf({{0, 0}, {40, 0}, {40, 6}, {80, 6}, {80, 30}, {0, 30}})));
  EXPECT_FALSE(mayBeSeveral(pieceOf({{0, 10}, {30, 0}, {70, 8}, {80, 36}, {20, 40}})));
}

}  // namespace
}  // namespace ostraka::capture
