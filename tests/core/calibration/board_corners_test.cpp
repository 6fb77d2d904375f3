#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/aruco/charuco.hpp>
#include <opencv2/imgproc.hpp>

#include "calibration/intrinsics.h"

namespace ostraka::calibration {
namespace {

const batch::Board kBoard{"DICT_5X5_100", 9, 7, 22, 16};

// A tilted board as a camera of this width sees it, and where its inner corners are then.
struct Rendered {
  cv::Mat picture;
  std::vector<cv::Point2f> corners;
};

constexpr double kPerMm = 10;  // steps of a drawing

Rendered photographed(const cv::Mat& drawing, const std::vector<cv::Point2f>& corners_mm, int width,
                      double blur_px) {
  const double across = drawing.cols / kPerMm, down = drawing.rows / kPerMm;
  constexpr int kFineWidth = 3600;  // then averaged down: pixels cover an area
  const auto w = static_cast<float>(kFineWidth), h = 0.75F * w;
  const std::vector<cv::Point2f> sheet{{0, 0},
                                       {static_cast<float>(across), 0},
                                       {static_cast<float>(across), static_cast<float>(down)},
                                       {0, static_cast<float>(down)}};
  const std::vector<cv::Point2f> seen{{0.12F * w, 0.14F * h},
                                      {0.91F * w, 0.08F * h},
                                      {0.84F * w, 0.86F * h},
                                      {0.17F * w, 0.93F * h}};
  const cv::Mat pixel_from_mm = cv::getPerspectiveTransform(sheet, seen);
  // A drawing's pixel k covers k to k + 1 steps of 1 / kPerMm; a picture's centre is its integer.
  const cv::Mat drawing_from_mm =
      (cv::Mat_<double>(3, 3) << kPerMm, 0, -0.5, 0, kPerMm, -0.5, 0, 0, 1);
  Rendered out;
  cv::warpPerspective(drawing, out.picture, drawing_from_mm * pixel_from_mm.inv(),
                      cv::Size(kFineWidth, cvRound(h)), cv::INTER_LINEAR | cv::WARP_INVERSE_MAP,
                      cv::BORDER_CONSTANT, cv::Scalar(255));
  const float share = static_cast<float>(width) / kFineWidth;
  cv::resize(out.picture, out.picture, {}, share, share, cv::INTER_AREA);
  cv::GaussianBlur(out.picture, out.picture, {}, blur_px);
  // A lens blurs light; the file stores its sRGB values.
  cv::Mat1b stored(1, 256);
  for (int i = 0; i < 256; ++i) {
    const double light = 0.03 + 0.7 * i / 255.0;  // of ink and paper
    stored(0, i) =
        cv::saturate_cast<std::uint8_t>(255 * (1.055 * std::pow(light, 1 / 2.4) - 0.055));
  }
  cv::LUT(out.picture, stored, out.picture);
  cv::perspectiveTransform(corners_mm, out.corners, pixel_from_mm);
  for (cv::Point2f& corner : out.corners)
    corner = share * (corner + cv::Point2f(0.5F, 0.5F)) - cv::Point2f(0.5F, 0.5F);
  return out;
}

Rendered render(int width, double blur_px) {
  const auto board = cv::aruco::CharucoBoard::create(
      kBoard.squares_x, kBoard.squares_y, static_cast<float>(kBoard.square_mm),
      static_cast<float>(kBoard.marker_mm),
      cv::aruco::getPredefinedDictionary(cv::aruco::DICT_5X5_100));
  cv::Mat drawing;
  board->draw(cv::Size(cvRound(kBoard.squares_x * kBoard.square_mm * kPerMm),
                       cvRound(kBoard.squares_y * kBoard.square_mm * kPerMm)),
              drawing, 0, 1);
  std::vector<cv::Point2f> inner;
  for (int y = 1; y < kBoard.squares_y; ++y)
    for (int x = 1; x < kBoard.squares_x; ++x)
      inner.emplace_back(static_cast<float>(x * kBoard.square_mm),
                         static_cast<float>(y * kBoard.square_mm));
  return photographed(drawing, inner, width, blur_px);
}

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
