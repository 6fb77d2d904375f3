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

bool isEverything(const cv::Mat1b& mask) {
  return cv::countNonZero(mask) == static_cast<int>(mask.total());
}

cv::Mat1b wholeBody(const cv::Mat1b& mask) {
  cv::Mat1i labels, measures;
  cv::Mat1d centres;
  const int count =
      cv::connectedComponentsWithStats(cv::Mat1b(mask >= 128), labels, measures, centres, 4);
  int largest = 0, area_px = 0;
  for (int k = 1; k < count; ++k)
    if (measures(k, cv::CC_STAT_AREA) > area_px) {
      largest = k;
      area_px = measures(k, cv::CC_STAT_AREA);
    }
  if (largest == 0) return cv::Mat1b(mask.size(), uchar{0});
  const cv::Mat1b body = labels == largest;
  cv::Mat1b whole = mask.clone(), near, outer;
  cv::dilate(body, near, cv::Mat());  // its edge is soft
  whole.setTo(0, near == 0);
  cv::copyMakeBorder(body, outer, 1, 1, 1, 1, cv::BORDER_CONSTANT, 0);
  cv::floodFill(outer, {0, 0}, 255);
  const cv::Rect inner(1, 1, mask.cols, mask.rows);
  whole.setTo(255, cv::Mat1b(outer == 0)(inner));  // enclosed by the body
  return whole;
}

}  // namespace ostraka::stereo
