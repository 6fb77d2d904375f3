#include "stereo/frame.h"

#include <algorithm>
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

/// Where the pixels of a part of the picture without distortion lie in the picture as it was shot.
struct Lens {
  cv::Rect part;
  cv::Mat map_x, map_y;  ///< empty: in the same place

  Lens(const rig::Intrinsics& lens, const cv::Rect& wanted) : part(wanted) {
    if (!lens.hasDistortion()) return;
    const cv::Matx33d k(lens.fx, 0, lens.cx, 0, lens.fy, lens.cy, 0, 0, 1);
    const cv::Matx33d moved(lens.fx, 0, lens.cx - part.x, 0, lens.fy, lens.cy - part.y, 0, 0, 1);
    cv::initUndistortRectifyMap(k, lens.distortion, cv::noArray(), moved, part.size(), CV_32F,
                                map_x, map_y);
  }
  cv::Mat1f seen(const cv::Mat& picture, int interpolation, int border) const {
    if (map_x.empty()) return picture(part).clone();
    cv::Mat1f result;
    cv::remap(picture, result, map_x, map_y, interpolation, border, 0);
    return result;
  }
};

cv::Mat1f coverageOf(const View& view, const Lens& lens) {
  cv::Mat coverage;
  if (view.mask.empty())
    coverage = cv::Mat1f(view.camera.intrinsics.height, view.camera.intrinsics.width, 1.0F);
  else
    view.mask.convertTo(coverage, CV_32F, 1.0 / 255.0);
  return lens.seen(coverage, cv::INTER_LINEAR, cv::BORDER_CONSTANT);
}

cv::Mat1f greyOf(const cv::Mat& photograph, const Lens& lens) {
  cv::Mat grey8, grey;
  cv::cvtColor(photograph, grey8, cv::COLOR_BGR2GRAY);
  grey8.convertTo(grey, CV_32F);
  return lens.seen(grey, cv::INTER_LANCZOS4, cv::BORDER_REPLICATE);
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

cv::Rect wholeOf(const View& view) {
  return {0, 0, view.camera.intrinsics.width, view.camera.intrinsics.height};
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
  return coarse;
}

}  // namespace

std::vector<Frame> buildPyramid(const View& view, const cv::Mat& photograph, const cv::Rect& part,
                                int levels) {
  std::vector<Frame> pyramid;
  const Lens lens(view.camera.intrinsics, part);
  Frame frame = frameOf(view, part);
  frame.coverage = coverageOf(view, lens);
  frame.grey =
      blurInside(greyOf(photograph, lens), mostlyCovered(frame.coverage), kPresmoothing_px);
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
  Outline outline{frameOf(view, whole), 0};
  outline.frame.coverage = coverageOf(view, Lens(view.camera.intrinsics, whole));
  outline.shown = cv::countNonZero(outline.frame.coverage >= kMinCoverage);
  for (int level = 1; level < levels; ++level) outline.frame = halved(outline.frame, {});
  return outline;
}

}  // namespace ostraka::stereo
