#include "mask/raised.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "mask/plate_geometry.h"
#include "mask/plate_picture.h"

namespace ostraka::mask {
namespace {

constexpr int kWindow = 9;          // cells, of two pixels: holds some grains of temper
constexpr int kReach = 13;          // a window that lies a third on a sherd agrees already
constexpr float kByChance = 0.45F;  // unrelated windows hardly ever agree more on their best plane
constexpr float kSlope = 12;        // agreement 0.85 against none: 5 in the logarithm
constexpr float kMost = 6;
constexpr float kNoise = 1;  // levels of 255 that noise leaves after halving
constexpr float kUnseen = -1e3F;
constexpr double kHighest = 20;  // mm: sherds lie flat; what stands higher is seen by its colour
constexpr double kThinnest = 2;  // mm: below, a plate of coarse texture still agrees
constexpr double kSlideCells = 1.5;  // between two planes; a grain is two cells wide

/// One photograph on one plane.
struct Laid {
  cv::Mat1f value, mean;
  cv::Mat1f strength;  ///< 1 / SD, damped by the noise's, so that even surfaces do not agree
  cv::Mat1b seen;
};

cv::Mat1f boxMean(const cv::Mat1f& values) {
  cv::Mat1f mean;
  cv::boxFilter(values, mean, CV_32F, {kWindow, kWindow}, {-1, -1}, true, cv::BORDER_REPLICATE);
  return mean;
}

cv::Mat1f halfBrightness(const cv::Mat& photograph) {
  cv::Mat half;
  cv::resize(photograph, half, {photograph.cols / 2, photograph.rows / 2}, 0, 0, cv::INTER_AREA);
  cv::Mat1f brightness;
  cv::transform(logColours(half), brightness, cv::Matx13f(1 / 3.F, 1 / 3.F, 1 / 3.F));
  return brightness;
}

// The camera of the halved photograph, with the plate lifted: its z = 0 is then the plane itself.
rig::PosedImage halfOf(const rig::PosedImage& image, double height_mm) {
  rig::PosedImage half = image;
  half.intrinsics.width /= 2, half.intrinsics.height /= 2;
  half.intrinsics.fx /= 2, half.intrinsics.fy /= 2;
  half.intrinsics.cx = 0.5 * (image.intrinsics.cx - 0.5);
  half.intrinsics.cy = 0.5 * (image.intrinsics.cy - 0.5);
  half.camera_from_plate = image.camera_from_plate * Eigen::Translation3d(0, 0, height_mm);
  return half;
}

// By how much the photographs slide over each other on a plane that rises by 1 mm: for each its
// nearest neighbour, of these the largest; in mm.
double largestSlide(std::span<const rig::PosedImage* const> images) {
  double largest = 0.1;  // cameras side by side at the same height still want some planes
  for (std::size_t i = 0; i < images.size(); ++i) {
    double nearest = 1e9;
    for (std::size_t j = 0; j < images.size(); ++j) {
      const Eigen::Vector3d a = images[i]->centre(), b = images[j]->centre();
      const double slide = (a.head<2>() / a.z() - b.head<2>() / b.z()).norm();
      if (j != i) nearest = std::min(nearest, slide);
    }
    largest = std::max(largest, nearest);
  }
  return largest;
}

Laid layOn(const rig::PosedImage& image, const cv::Mat1f& brightness, const PlateGrid& grid) {
  Laid laid;
  cv::remap(brightness, laid.value, pixelsOfGrid(image, grid), cv::noArray(), cv::INTER_LINEAR,
            cv::BORDER_CONSTANT, cv::Scalar::all(kUnseen));
  laid.seen = laid.value >= 0;
  laid.value.setTo(0, ~laid.seen);
  cv::Mat1b plate(grid.size, grid.size, uchar{0});
  cv::circle(plate, {grid.size / 2, grid.size / 2}, cvFloor(grid.radius_mm / grid.pitch_mm), 255,
             cv::FILLED);
  laid.seen &= plate;
  cv::erode(laid.seen, laid.seen, cv::getStructuringElement(cv::MORPH_RECT, {kWindow, kWindow}));
  laid.mean = boxMean(laid.value);
  laid.strength = boxMean(laid.value.mul(laid.value)) - laid.mean.mul(laid.mean);
  for (int y = 0; y < laid.strength.rows; ++y)
    for (int x = 0; x < laid.strength.cols; ++x) {
      const float noise = kNoise * std::exp(-laid.mean(y, x));
      laid.strength(y, x) = 1 / std::sqrt(std::max(0.F, laid.strength(y, x)) + noise * noise);
    }
  return laid;
}

// Normalised cross correlation; 0 where one of them sees nothing.
cv::Mat1f agreement(const Laid& a, const Laid& b) {
  cv::Mat1f ncc = boxMean(a.value.mul(b.value)) - a.mean.mul(b.mean);
  ncc = ncc.mul(a.strength).mul(b.strength);
  ncc.setTo(0, ~(a.seen & b.seen));
  return ncc;
}

/// Where the rays of a halved photograph meet planes parallel to the plate.
struct Rays {
  cv::Mat2f on_plate;  ///< grid coordinates at height 0
  cv::Scalar centre;   ///< the camera's own, seen from above
  double height_mm;    ///< of the camera

  Rays(const rig::PosedImage& image, const PlateGrid& grid)
      : on_plate(gridOfPixels(halfOf(image, 0), grid)), height_mm(image.centre().z()) {
    const Eigen::Vector3d at = image.centre() / grid.pitch_mm;
    centre = cv::Scalar(at.x() + grid.middle(), at.y() + grid.middle());
  }
  // Along a ray the place moves towards the camera's in proportion to the height.
  cv::Mat2f at(double plane_mm) const {
    const double share = plane_mm / height_mm;
    return cv::Mat2f(on_plate * (1 - share) + centre * share);
  }
};

}  // namespace

std::vector<cv::Mat1f> weighHeights(std::span<const rig::PosedImage* const> images,
                                    std::span<const cv::Mat* const> photographs,
                                    const batch::Plate& plate, double max_height_mm) {
  std::vector<cv::Mat1f> on_plate(images.size()), above(images.size()), brightness;
  for (const cv::Mat* photograph : photographs) brightness.push_back(halfBrightness(*photograph));
  for (std::size_t i = 0; i < images.size(); ++i) {
    on_plate[i] = cv::Mat1f(brightness[i].size(), 0.F);
    above[i] = on_plate[i].clone();
  }
  if (images.size() < 2) return above;
  PlateGrid grid = gridOver(plate, millimetresPerPixel(*images[0]));
  grid.pitch_mm = 2 * millimetresPerPixel(*images[0]);
  grid.size = 2 * static_cast<int>(std::ceil(grid.radius_mm / grid.pitch_mm)) + 1;
  const double step = kSlideCells * grid.pitch_mm / largestSlide(images);
  const int planes = static_cast<int>(std::min(max_height_mm, kHighest) / step);
  std::vector<Rays> rays;
  for (const rig::PosedImage* image : images) rays.emplace_back(*image, grid);
  for (int plane = 0; plane <= planes; ++plane) {
    const double height = plane * step;
    std::vector<Laid> laid;
    for (std::size_t i = 0; i < images.size(); ++i)
      laid.push_back(layOn(halfOf(*images[i], height), brightness[i], grid));
    std::vector<cv::Mat1f> best(images.size());
    for (std::size_t i = 0; i < images.size(); ++i) best[i] = cv::Mat1f(laid[i].value.size(), 0.F);
    for (std::size_t i = 0; i < images.size(); ++i)
      for (std::size_t j = i + 1; j < images.size(); ++j) {
        const cv::Mat1f ncc = agreement(laid[i], laid[j]);
        best[i] = cv::max(best[i], ncc);
        best[j] = cv::max(best[j], ncc);
      }
    std::vector<cv::Mat1f>& side = height < kThinnest ? on_plate : above;
    for (std::size_t i = 0; i < images.size(); ++i) {
      cv::Mat1f seen;
      cv::remap(best[i], seen, rays[i].at(height), cv::noArray(), cv::INTER_LINEAR,
                cv::BORDER_CONSTANT, cv::Scalar::all(0));
      side[i] = cv::max(side[i], seen);
    }
  }
  for (std::size_t i = 0; i < images.size(); ++i) {
    cv::Mat1f& odds = above[i];
    for (int y = 0; y < odds.rows; ++y)
      for (int x = 0; x < odds.cols; ++x) {
        const float high = std::max(0.F, odds(y, x) - kByChance),
                    low = std::max(0.F, on_plate[i](y, x) - kByChance);
        odds(y, x) = std::clamp(kSlope * (high - low), -kMost, kMost);
      }
    const double sine = std::abs(images[i]->centre().normalized().z());
    const cv::Mat window = cv::getStructuringElement(
        cv::MORPH_ELLIPSE, {kReach, 2 * cvRound(sine * (kReach / 2)) + 1});
    // Grain is uneven, so agreement is spotty.
    cv::medianBlur(odds, odds, 5);
    cv::blur(odds, odds, {kWindow, kWindow});
    cv::Mat1f sure = cv::max(odds, 0), against = cv::max(-odds, 0);
    cv::erode(sure, sure, window);
    cv::erode(against, against, window);
    odds = sure - against;
  }
  return above;
}

}  // namespace ostraka::mask
