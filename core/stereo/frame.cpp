#include "stereo/frame.h"

#include <algorithm>
#include <cmath>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

namespace ostraka::stereo {
namespace {

/// A pixel serves for comparing when the object has the greater part of it. Asking for whole pixels
/// would cost a strip along every outline, and broken edges are seen there.
constexpr float kMinCoverage = 0.5F;
/// Takes off the single pixel's noise, and the interpolation's dependence on the sub-pixel phase.
constexpr double kPresmoothing_px = 0.4;
/// Before every second pixel is left out.
constexpr double kHalvingBlur_px = 1.0;
/// Beyond the photograph frames end at multiples of it, so that their levels lie on each other.
constexpr double kBlock_px = 16;
constexpr double kBorder_px = 2;  // of a frame, which counts as outside

/// Blur that reads nothing outside the mask: blur(image mask) / blur(mask).
cv::Mat1f blurInside(const cv::Mat1f& image, const cv::Mat1f& inside, double sigma_px) {
  cv::Mat1f weighted = image.mul(inside), weight;
  cv::GaussianBlur(weighted, weighted, {}, sigma_px, sigma_px, cv::BORDER_REPLICATE);
  cv::GaussianBlur(inside, weight, {}, sigma_px, sigma_px, cv::BORDER_REPLICATE);
  cv::Mat1f result(image.size(), 0.0F);
  for (int y = 0; y < image.rows; ++y)
    for (int x = 0; x < image.cols; ++x)
      if (weight(y, x) > 1e-3F) result(y, x) = weighted(y, x) / weight(y, x);
  return result;
}

cv::Mat1f mostlyCovered(const cv::Mat1f& coverage) {
  cv::Mat1f covered(coverage.size());
  for (int y = 0; y < coverage.rows; ++y)
    for (int x = 0; x < coverage.cols; ++x)
      covered(y, x) = coverage(y, x) >= kMinCoverage ? 1.0F : 0.0F;
  return covered;
}

std::uint32_t toByte(float grey) {
  return grey <= 0.0F ? 0U : static_cast<std::uint32_t>(std::clamp(grey + 0.5F, 1.0F, 255.0F));
}

void pack(Frame& frame) {
  const int w = frame.width, h = frame.height;
  frame.packed.assign(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), 0U);
  for (int y = 0; y + 1 < h; ++y) {
    const float* row = frame.grey[y];
    const float* below = frame.grey[y + 1];
    std::uint32_t* to = frame.packed.data() + static_cast<std::ptrdiff_t>(y) * w;
    for (int x = 0; x + 1 < w; ++x)
      to[x] = toByte(row[x]) | toByte(row[x + 1]) << 8U | toByte(below[x]) << 16U |
              toByte(below[x + 1]) << 24U;
  }
}

/// Sets grey outside the mask and on the border to 0, so that lookups clamped to it are outside.
void blank(Frame& frame, const cv::Mat1f& covered) {
  for (int y = 0; y < frame.height; ++y)
    for (int x = 0; x < frame.width; ++x) {
      const bool border = x < 1 || y < 1 || x + 2 > frame.width || y + 2 > frame.height;
      float& grey = frame.grey(y, x);
      grey = border || covered(y, x) == 0.0F ? 0.0F : std::clamp(grey, 1.0F, 255.0F);
    }
}

cv::Mat1f coverageOf(const View& view, const StraightPart& straight) {
  cv::Mat coverage;
  if (view.mask.empty())
    coverage = cv::Mat1f(view.camera.intrinsics.height, view.camera.intrinsics.width, 1.0F);
  else
    view.mask.convertTo(coverage, CV_32F, 1.0 / 255.0);
  return straight.of(coverage, cv::INTER_LINEAR, cv::BORDER_CONSTANT);
}

cv::Mat1f greyOf(const cv::Mat& photograph, const StraightPart& straight) {
  cv::Mat grey8, grey;
  cv::cvtColor(photograph, grey8, cv::COLOR_BGR2GRAY);
  grey8.convertTo(grey, CV_32F);
  return straight.of(grey, cv::INTER_LANCZOS4, cv::BORDER_REPLICATE);
}

/// Empty within the photograph's rectangle, of whose corners a lens leaves slivers.
cv::Mat1b shownOf(const View& view, const cv::Rect& part, const StraightPart& straight) {
  const cv::Rect photograph(0, 0, view.camera.intrinsics.width, view.camera.intrinsics.height);
  if ((part & photograph) == part) return {};
  return straight.of(cv::Mat1b(photograph.size(), uchar{255}), cv::INTER_LINEAR,
                     cv::BORDER_CONSTANT) == 255;
}

/// The view's camera for a part of its pixels.
Frame frameOf(const View& view, const cv::Rect& part) {
  Frame frame;
  const rig::Intrinsics& lens = view.camera.intrinsics;
  frame.light = view.camera.stop;
  frame.width = part.width;
  frame.height = part.height;
  frame.fx = static_cast<float>(lens.fx);
  frame.fy = static_cast<float>(lens.fy);
  frame.cx = static_cast<float>(lens.cx - part.x);
  frame.cy = static_cast<float>(lens.cy - part.y);
  frame.rotation = view.camera.camera_from_plate.linear().cast<float>();
  frame.translation = view.camera.camera_from_plate.translation().cast<float>();
  frame.centre = view.camera.centre().cast<float>();
  return frame;
}

/// Without grey values where there are none.
Frame halved(const Frame& fine, const cv::Mat1f& blurred) {
  Frame coarse;
  coarse.light = fine.light;
  coarse.width = fine.width / 2;
  coarse.height = fine.height / 2;
  coarse.fx = fine.fx / 2;
  coarse.fy = fine.fy / 2;
  coarse.cx = (fine.cx + 0.5F) / 2 - 0.5F;
  coarse.cy = (fine.cy + 0.5F) / 2 - 0.5F;
  coarse.rotation = fine.rotation;
  coarse.translation = fine.translation;
  coarse.centre = fine.centre;
  const cv::Rect even(0, 0, coarse.width * 2, coarse.height * 2);
  if (!blurred.empty())
    cv::resize(blurred(even), coarse.grey, {coarse.width, coarse.height}, 0, 0, cv::INTER_AREA);
  cv::resize(fine.coverage(even), coarse.coverage, {coarse.width, coarse.height}, 0, 0,
             cv::INTER_AREA);
  if (!fine.shown.empty()) {
    cv::Mat share;
    cv::resize(fine.shown(even), share, {coarse.width, coarse.height}, 0, 0, cv::INTER_AREA);
    coarse.shown = share == 255;
  }
  return coarse;
}

}  // namespace

StraightPart::StraightPart(const rig::Intrinsics& camera, const cv::Rect& part) : part_(part) {
  if (!camera.hasDistortion()) return;
  const cv::Matx33d k(camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1);
  const double cx = camera.cx - part.x, cy = camera.cy - part.y;
  const cv::Matx33d moved(camera.fx, 0, cx, 0, camera.fy, cy, 0, 0, 1);
  const std::vector<double> terms = camera.distortion.list();
  if (camera.distortion.lens == rig::Lens::Fisheye)
    cv::fisheye::initUndistortRectifyMap(k, terms, cv::Matx33d::eye(), moved, part.size(), CV_32F,
                                         map_x_, map_y_);
  else
    cv::initUndistortRectifyMap(k, terms, cv::noArray(), moved, part.size(), CV_32F, map_x_,
                                map_y_);
  // Beyond, the model folds back into the photograph, which does not show that.
  const double most = camera.distortion.reach() * camera.distortion.reach();
  const auto squared = [&](double x, double y) {
    return std::pow((x - cx) / camera.fx, 2) + std::pow((y - cy) / camera.fy, 2);
  };
  if (squared(cx < part.width / 2.0 ? part.width : 0, cy < part.height / 2.0 ? part.height : 0) <
      most)
    return;
  for (int y = 0; y < part.height; ++y)
    for (int x = 0; x < part.width; ++x)
      if (squared(x, y) > most) map_x_.at<float>(y, x) = map_y_.at<float>(y, x) = -1e4F;
}

cv::Mat StraightPart::of(const cv::Mat& picture, int interpolation, int border) const {
  if (map_x_.empty()) return picture(part_).clone();
  cv::Mat result;
  cv::remap(picture, result, map_x_, map_y_, interpolation, border, 0);
  return result;
}

cv::Rect wholeOf(const View& view) {
  const rig::Intrinsics& camera = view.camera.intrinsics;
  const cv::Rect photograph(0, 0, camera.width, camera.height);
  if (!camera.hasDistortion()) return photograph;
  const cv::Rect object = view.mask.empty() ? photograph : cv::boundingRect(view.mask);
  if (object.empty()) return photograph;
  // The outermost stays outermost.
  Eigen::AlignedBox2d shown;
  const auto extend = [&](int x, int y) {
    const Eigen::Vector2d n = camera.unproject({x, y});
    shown.extend(Eigen::Vector2d(camera.fx * n.x() + camera.cx, camera.fy * n.y() + camera.cy));
  };
  for (int x = object.x; x < object.x + object.width; ++x)
    for (const int y : {object.y, object.y + object.height - 1}) extend(x, y);
  for (int y = object.y; y < object.y + object.height; ++y)
    for (const int x : {object.x, object.x + object.width - 1}) extend(x, y);
  const auto beyond = [](double pixels, int most) {
    return pixels <= 0 ? 0
                       : static_cast<int>(std::min(std::ceil((pixels + kBorder_px) / kBlock_px),
                                                   std::floor(most / kBlock_px)) *
                                          kBlock_px);
  };
  const int left = beyond(-shown.min().x(), camera.width),
            top = beyond(-shown.min().y(), camera.height),
            right = beyond(shown.max().x() - (camera.width - 1), camera.width),
            bottom = beyond(shown.max().y() - (camera.height - 1), camera.height);
  return {-left, -top, left + camera.width + right, top + camera.height + bottom};
}

std::vector<Frame> buildPyramid(const View& view, const cv::Mat& photograph, const cv::Rect& part,
                                int levels) {
  std::vector<Frame> pyramid;
  const StraightPart straight(view.camera.intrinsics, part);
  Frame frame = frameOf(view, part);
  frame.coverage = coverageOf(view, straight);
  frame.shown = shownOf(view, part, straight);
  frame.grey =
      blurInside(greyOf(photograph, straight), mostlyCovered(frame.coverage), kPresmoothing_px);
  for (int level = 0; level < levels; ++level) {
    const cv::Mat1f covered = mostlyCovered(frame.coverage);
    Frame next;
    if (level + 1 < levels)
      next = halved(frame, blurInside(frame.grey, covered, kHalvingBlur_px / 2));
    blank(frame, covered);
    pack(frame);
    pyramid.push_back(std::move(frame));
    frame = std::move(next);
  }
  return pyramid;
}

std::vector<Frame> buildPyramid(const View& view, int levels) {
  return buildPyramid(view, view.photograph, wholeOf(view), levels);
}

Outline outlineOf(const View& view, int levels) {
  const cv::Rect whole = wholeOf(view);
  Outline outline{whole, frameOf(view, whole), 0};
  const StraightPart straight(view.camera.intrinsics, whole);
  outline.frame.coverage = coverageOf(view, straight);
  outline.frame.shown = shownOf(view, whole, straight);
  outline.shown = cv::countNonZero(outline.frame.coverage >= kMinCoverage);
  for (int level = 1; level < levels; ++level) outline.frame = halved(outline.frame, {});
  return outline;
}

}  // namespace ostraka::stereo
