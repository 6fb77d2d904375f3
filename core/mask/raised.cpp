#include "mask/raised.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "ground/plate_geometry.h"
#include "ground/plate_picture.h"
#include "mask/plane_sweep.h"

namespace ostraka::mask {
namespace {

constexpr int kWindow = 9;          // cells of the sweep
constexpr int kReach = 13;          // a window that lies a third on a sherd agrees already
constexpr float kByChance = 0.45F;  // unrelated windows hardly ever agree more on their best plane
constexpr float kSlope = 12;        // agreement 0.85 against none: 5 in the logarithm
constexpr float kMostRaised = 6;
constexpr double kHighest = 20;  // mm: sherds lie flat; what stands higher is seen by its colour
constexpr double kThinnest = 2;  // mm: below, a plate of coarse texture still agrees
constexpr double kSlideCells = 1.5;  // between two planes; a grain is two cells wide

cv::Mat1f halfBrightness(const cv::Mat& photograph) {
  cv::Mat half;
  cv::resize(photograph, half, {photograph.cols / 2, photograph.rows / 2}, 0, 0, cv::INTER_AREA);
  cv::Mat1f brightness;
  cv::transform(ground::logColours(half), brightness, cv::Matx13f(1 / 3.F, 1 / 3.F, 1 / 3.F));
  return brightness;
}

rig::PosedImage halfOf(const rig::PosedImage& image) {
  rig::PosedImage half = image;
  half.intrinsics.width /= 2, half.intrinsics.height /= 2;
  half.intrinsics.fx /= 2, half.intrinsics.fy /= 2;
  half.intrinsics.cx = 0.5 * (image.intrinsics.cx - 0.5);
  half.intrinsics.cy = 0.5 * (image.intrinsics.cy - 0.5);
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

// What the agreement on the plate and above it says, spread as far as the windows' place is known.
// cell_px: a cell of the sweep in pixels of half size.
cv::Mat1f oddsOf(const rig::PosedImage& image, double cell_px, const cv::Mat1f& on_plate,
                 const cv::Mat1f& above) {
  cv::Mat1f odds(above.size());
  for (int y = 0; y < odds.rows; ++y)
    for (int x = 0; x < odds.cols; ++x) {
      const float high = std::max(0.F, above(y, x) - kByChance),
                  low = std::max(0.F, on_plate(y, x) - kByChance);
      odds(y, x) = std::clamp(kSlope * (high - low), -kMostRaised, kMostRaised);
    }
  const double sine = std::abs(image.centre().normalized().z());
  const int half = cvRound(cell_px * (kReach / 2)), even = cvRound(cell_px * kWindow);
  const cv::Mat window =
      cv::getStructuringElement(cv::MORPH_ELLIPSE, {2 * half + 1, 2 * cvRound(sine * half) + 1});
  // Grain is uneven, so agreement is spotty.
  cv::medianBlur(odds, odds, 5);
  cv::blur(odds, odds, {even, even});
  cv::Mat1f sure = cv::max(odds, 0), against = cv::max(-odds, 0);
  cv::erode(sure, sure, window);
  cv::erode(against, against, window);
  return sure - against;
}

}  // namespace

double sweepPitch_mm(const rig::PosedImage& image, const batch::Plate& plate) {
  return std::max(2 * ground::millimetresPerPixel(image), ground::finestPitch_mm(plate));
}

std::vector<cv::Mat1f> weighHeights(std::span<const rig::PosedImage* const> images,
                                    std::span<const cv::Mat* const> photographs,
                                    const batch::Plate& plate, double max_height_mm,
                                    double bend_mm) {
  std::vector<cv::Mat1f> odds;
  if (images.size() < 2) {
    for (const cv::Mat* photograph : photographs)
      odds.emplace_back(photograph->rows / 2, photograph->cols / 2, 0.F);
    return odds;
  }
  const double pitch = sweepPitch_mm(*images[0], plate);
  const double step = kSlideCells * pitch / largestSlide(images);
  const int planes = static_cast<int>(std::min(max_height_mm, kHighest) / step);
  // No sherd stands on the ring of markers.
  PlaneSweep sweep(pitch, ground::gridOver(plate, pitch).ring_inner_mm);
  std::vector<cv::Mat1f> on_plate, above;
  for (std::size_t i = 0; i < images.size(); ++i) {
    sweep.add(halfOf(*images[i]), halfBrightness(*photographs[i]), planes * step);
    on_plate.emplace_back(sweep.ground(i), 0.F);
    above.emplace_back(sweep.ground(i), 0.F);
  }
  for (int plane = 0; plane <= planes; ++plane)
    sweep.agreeOn(plane * step, plane * step < kThinnest + bend_mm ? on_plate : above);
  ground::PlateGrid millimetres;
  millimetres.pitch_mm = 1;
  millimetres.size = 1;
  for (std::size_t i = 0; i < images.size(); ++i) {
    const cv::Mat2f plate_mm = ground::gridOfPixels(halfOf(*images[i]), millimetres);
    const double usual = 2 * ground::millimetresPerPixel(*images[0]);
    odds.push_back(oddsOf(*images[i], pitch / usual, sweep.seenFrom(i, on_plate[i], plate_mm),
                          sweep.seenFrom(i, above[i], plate_mm)));
  }
  return odds;
}

cv::Mat1f heightsInTheLight(const cv::Mat1f& odds, const cv::Mat3f& residual) {
  cv::Mat1f full;
  cv::resize(odds, full, residual.size(), 0, 0, cv::INTER_LINEAR);
  for (int y = 0; y < full.rows; ++y)
    for (int x = 0; x < full.cols; ++x) {
      const cv::Vec3f& v = residual(y, x);
      const float darker = std::exp(-(v[0] + v[1] + v[2]) / 3);
      full(y, x) *= std::clamp(2 - darker / 3, 0.F, 1.F);
    }
  return full;
}

}  // namespace ostraka::mask
