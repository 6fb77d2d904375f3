#include "mask/coarse_heights.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "base/median.h"
#include "ground/plate_geometry.h"

namespace ostraka::mask {
namespace {

constexpr int kEdge = 4;         // pixels of the reconstruction, half a window of its stereo
constexpr float kShownOdds = 6;  // as the plane sweep's at most (raised.cpp)

cv::Mat disc(int radius) {
  return cv::getStructuringElement(cv::MORPH_ELLIPSE, {2 * radius + 1, 2 * radius + 1});
}

// Where depth jumps from one pixel to the next by more than a surface seen at 76 degrees would.
cv::Mat1b jumps(const cv::Mat1f& depth, double mm_per_pixel) {
  constexpr double kSteepest = 4;
  cv::Mat1f even, nearest, farthest;
  cv::medianBlur(depth, even, 5);
  const cv::Mat around = cv::getStructuringElement(cv::MORPH_RECT, {3, 3});
  cv::erode(even, nearest, around);
  cv::dilate(even, farthest, around);
  return farthest - nearest > 2 * kSteepest * mm_per_pixel;
}

// What is enclosed by something raised is raised.
void fillHoles(cv::Mat1b& raised) {
  std::vector<std::vector<cv::Point>> outlines;
  cv::findContours(raised.clone(), outlines, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
  cv::drawContours(raised, outlines, -1, cv::Scalar(255), cv::FILLED);
}

}  // namespace

std::vector<float> heightsAbove(const PointCloud& cloud, const rig::SheetBend& bend) {
  std::vector<float> heights;
  heights.reserve(cloud.size());
  for (const Eigen::Vector3f& p : cloud.points)
    heights.push_back(p.z() - static_cast<float>(bend.at(p.x(), p.y())));
  return heights;
}

double leastRaised(std::span<const float> heights, double thickness) {
  std::vector<float> off;
  for (const float height : heights)
    if (height < 0 && height > -thickness) off.push_back(-height);
  return 4 * 1.4826 * medianOf(off);
}

cv::Mat1b shownBy(const PointCloud& cloud, std::span<const float> heights,
                  const rig::PosedImage& image, double least_raised, Gaps gaps) {
  const cv::Size size(image.intrinsics.width, image.intrinsics.height);
  cv::Mat1f depth(size, 1e9F);
  cv::Mat1b shown(size, uchar{kNothingShown});
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3d q = image.camera_from_plate * cloud.points[i].cast<double>();
    if (q.z() <= 0) continue;
    const Eigen::Vector2d pixel = image.intrinsics.project(q);
    if (!(std::abs(pixel.x()) < 1e6 && std::abs(pixel.y()) < 1e6)) continue;
    const int x0 = cvRound(pixel.x()), y0 = cvRound(pixel.y());
    const auto z = static_cast<float>(q.z());
    for (int y = std::max(0, y0 - 1); y <= std::min(size.height - 1, y0 + 1); ++y)
      for (int x = std::max(0, x0 - 1); x <= std::min(size.width - 1, x0 + 1); ++x)
        if (z < depth(y, x)) {
          depth(y, x) = z;
          shown(y, x) = heights[i] > least_raised ? kRaisedShown : kGroundShown;
        }
  }
  cv::Mat1b raised = shown == kRaisedShown, ground = shown == kGroundShown;
  cv::morphologyEx(raised, raised, cv::MORPH_OPEN, disc(2));  // single points are noise
  if (gaps == Gaps::Left) {
    // Windows of stereo reach over an outline, those of two sherds over the gap between them: they
    // meet within it, the one before the other.
    raised.setTo(0, jumps(depth, ground::millimetresPerPixel(image)));
    cv::erode(raised, raised, disc(kEdge));
    shown.setTo(kNothingShown, (shown == kRaisedShown) & ~raised);
    return shown;
  }
  // Gaps of a few pixels are not seen through.
  cv::Mat1b covered;
  cv::morphologyEx(raised, raised, cv::MORPH_CLOSE, disc(kEdge));
  cv::morphologyEx(ground, ground, cv::MORPH_CLOSE, disc(kEdge));
  fillHoles(raised);
  cv::Mat1b surely;  // the ground, seen below an arch or between sherds that lie in a ring
  cv::morphologyEx(ground, surely, cv::MORPH_OPEN, disc(2));
  cv::morphologyEx(cv::Mat1b(shown == kRaisedShown), covered, cv::MORPH_CLOSE, disc(kEdge));
  raised.setTo(0, surely & ~covered);
  shown.setTo(kNothingShown);
  shown.setTo(kGroundShown, ground);
  shown.setTo(kRaisedShown, raised);
  return shown;
}

cv::Mat1f heightsShown(const cv::Mat1b& shown, cv::Size size) {
  cv::Mat1b raised = shown == kRaisedShown, ground = shown == kGroundShown;
  cv::erode(raised, raised, disc(kEdge));
  cv::erode(ground, ground, disc(kEdge));
  cv::Mat1f odds(shown.size(), 0.F), half;
  odds.setTo(kShownOdds, raised);
  odds.setTo(-kShownOdds, ground);
  cv::resize(odds, half, {size.width / 2, size.height / 2}, 0, 0, cv::INTER_LINEAR);
  return half;
}

cv::Mat1b coveredCells(const cv::Mat1b& shown, cv::Size size, const cv::Mat2f& pixel_of_cell) {
  cv::Mat1b raised, covered;
  cv::resize(cv::Mat1b(shown == kRaisedShown), raised, size, 0, 0, cv::INTER_NEAREST);
  cv::remap(raised, covered, pixel_of_cell, cv::noArray(), cv::INTER_NEAREST, cv::BORDER_CONSTANT,
            cv::Scalar::all(0));
  return covered;
}

}  // namespace ostraka::mask
