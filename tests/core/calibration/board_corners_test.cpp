#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/aruco/charuco.hpp>

#include "calibration/intrinsics.h"
#include "tests/core/calibration/drawn_board.h"

namespace ostraka::calibration {
namespace {

const MarkerGrid kGrid{"DICT_6X6_250", 5, 4, 32, 6, 0};

Rendered renderGrid(int width, double blur_px) {
  const auto board = cv::aruco::GridBoard::create(
      kGrid.markers_x, kGrid.markers_y, static_cast<float>(kGrid.marker_mm),
      static_cast<float>(kGrid.gap_mm),
      cv::aruco::getPredefinedDictionary(cv::aruco::DICT_6X6_250));
  const double step = kGrid.marker_mm + kGrid.gap_mm;
  cv::Mat drawing;  // a gap of paper all round
  board->draw(cv::Size(cvRound((kGrid.markers_x * step + kGrid.gap_mm) * kPerMm),
                       cvRound((kGrid.markers_y * step + kGrid.gap_mm) * kPerMm)),
              drawing, cvRound(kGrid.gap_mm * kPerMm), 1);
  std::vector<cv::Point2f> corners;
  for (int y = 0; y < kGrid.markers_y; ++y)
    for (int x = 0; x < kGrid.markers_x; ++x)
      for (const cv::Point2f& c : {cv::Point2f(0, 0), {1, 0}, {1, 1}, {0, 1}})
        corners.emplace_back(static_cast<float>(kGrid.gap_mm + x * step + c.x * kGrid.marker_mm),
                             static_cast<float>(kGrid.gap_mm + y * step + c.y * kGrid.marker_mm));
  return photographed(drawing, corners, width, blur_px);
}

// Which corner is which is the dictionary's matter; here each must lie on one.
double worstDistance(const TargetView& view, const std::vector<cv::Point2f>& corners) {
  double worst = 0;
  for (const Eigen::Vector2d& pixel : view.pixels) {
    double nearest = 1e9;
    for (const cv::Point2f& corner : corners)
      nearest = std::min(nearest, std::hypot(pixel.x() - corner.x, pixel.y() - corner.y));
    worst = std::max(worst, nearest);
  }
  return worst;
}

// Of a picture of 1200 pixels: 0.7 px is sharp, 1.5 px soft. Larger pictures of the same lens are
// blurred in proportion; what is found must not get worse with them.
TEST(FindBoard, FindsCornersOfSharpSoftAndLargePictures) {
  for (const auto& [width, blur] : {std::pair(1200, 0.7), {1200, 1.5}, {3600, 2.1}, {3600, 4.5}}) {
    const Rendered board = render(width, blur);
    const Result<TargetView> view = findBoard(board.picture, kBoard);
    ASSERT_TRUE(view.has_value()) << view.error().sentence();
    EXPECT_EQ(view->pixels.size(), 48U) << width << ", " << blur;
    EXPECT_LT(worstDistance(*view, board.corners), 0.1) << width << ", " << blur;
  }
}

// A marker's outer corner, unlike a saddle, seems to move inwards in soft pictures; edges do not.
TEST(FindGrid, FindsCornersOfSharpSoftAndLargePictures) {
  for (const auto& [width, blur] : {std::pair(1200, 0.7), {1200, 1.5}, {3600, 2.1}, {3600, 4.5}}) {
    const Rendered grid = renderGrid(width, blur);
    const Result<TargetView> view = findGrid(grid.picture, kGrid);
    ASSERT_TRUE(view.has_value()) << view.error().sentence();
    EXPECT_EQ(view->pixels.size(), 80U) << width << ", " << blur;
    EXPECT_LT(worstDistance(*view, grid.corners), 0.1) << width << ", " << blur;
  }
}

}  // namespace
}  // namespace ostraka::calibration
