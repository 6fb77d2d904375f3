#include "stereo/background.h"

#include <opencv2/imgproc.hpp>
#include <vector>

#include "base/median.h"

namespace ostraka::stereo {
namespace {

double borderMedian(const cv::Mat1b& grey) {
  std::vector<std::uint8_t> border;
  for (int x = 0; x < grey.cols; ++x) {
    border.push_back(grey(0, x));
    border.push_back(grey(grey.rows - 1, x));
  }
  for (int y = 0; y < grey.rows; ++y) {
    border.push_back(grey(y, 0));
    border.push_back(grey(y, grey.cols - 1));
  }
  return medianOf(border);
}

/// Closes dark spots of up to this many pixels across: shadows in the object's relief.
constexpr int kShadow_px = 5;

}  // namespace

cv::Mat1b possibleObject(const cv::Mat& photograph) {
  cv::Mat1b grey, mask;
  cv::cvtColor(photograph, grey, cv::COLOR_BGR2GRAY);
  cv::GaussianBlur(grey, grey, {}, 0.8);
  const double bright = cv::threshold(grey, mask, 0, 255, cv::THRESH_BINARY | cv::THRESH_OTSU);
  const double dark = borderMedian(grey);
  if (dark > 0.5 * bright) return cv::Mat1b(photograph.size(), 255);
  // midway between background and what divides the picture best: shadows belong to the object
  cv::threshold(grey, mask, 0.5 * (dark + bright), 255, cv::THRESH_BINARY);
  const cv::Mat element = cv::getStructuringElement(cv::MORPH_ELLIPSE, {kShadow_px, kShadow_px});
  cv::morphologyEx(mask, mask, cv::MORPH_CLOSE, element);
  cv::dilate(mask, mask, cv::Mat());
  return mask;
}

}  // namespace ostraka::stereo
