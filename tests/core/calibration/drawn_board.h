#pragma once
#include <cmath>
#include <opencv2/aruco/charuco.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "batch/batch.h"

namespace ostraka::calibration {

inline const batch::Board kBoard{"DICT_5X5_100", 9, 7, 22, 16};

// A tilted board as a camera of this width sees it, and where its inner corners are then.
struct Rendered {
  cv::Mat picture;
  std::vector<cv::Point2f> corners;
};

inline constexpr double kPerMm = 10;  // steps of a drawing

inline Rendered photographed(const cv::Mat& drawing, const std::vector<cv::Point2f>& corners_mm,
                             int width, double blur_px) {
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

inline Rendered render(int width, double blur_px) {
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

}  // namespace ostraka::calibration
