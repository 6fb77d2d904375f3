#include "rendering/plate_surface.h"

#include <cmath>
#include <numbers>
#include <opencv2/aruco/charuco.hpp>

#include "rig/plate_print.h"

namespace ostraka::rendering {
namespace {

constexpr int kMarkers = 24;
constexpr double kRing = 145, kSide = 24;  // mm: middle of the markers, their edge
constexpr float kPaperMargin = 3.5f;       // mm of white around the black border
constexpr float kPaper = 0.72f, kInk = 0.028f;

Eigen::Vector3f feltOf(PlateColor color) {
  switch (color) {
    case PlateColor::Dark:
      return {0.029f, 0.030f, 0.034f};
    case PlateColor::Grey:
      return {0.205f, 0.207f, 0.21f};
    case PlateColor::Light:
      return {0.43f, 0.43f, 0.42f};
    case PlateColor::White:
      return {0.70f, 0.705f, 0.70f};
  }
  return {0.029f, 0.030f, 0.034f};
}

}  // namespace

batch::Plate standardPlate() {
  return rig::ringPlate(2 * PlateSurface::kRadius, kSide, "DICT_4X4_100");
}

PlateSurface::PlateSurface(PlateColor color, std::uint64_t seed)
    : felt_(feltOf(color)), seed_(static_cast<std::uint32_t>(vessels::mixed(seed))) {
  const auto dictionary = cv::aruco::getPredefinedDictionary(cv::aruco::DICT_4X4_100);
  for (int id = 0; id < kMarkers; ++id) {
    cv::Mat picture;
    cv::aruco::drawMarker(dictionary, id, 6, picture, 1);
    std::array<std::uint8_t, 36> bits;
    for (int i = 0; i < 36; ++i) bits[i] = picture.at<std::uint8_t>(i / 6, i % 6) > 127;
    bits_.push_back(bits);
  }
}

bool PlateSurface::ink(int marker, float right, float down) const {
  const auto side = static_cast<float>(kSide);
  const float u = right / side + 0.5f, v = down / side + 0.5f;
  if (u < 0 || v < 0 || u >= 1 || v >= 1) return false;
  return !bits_[marker][static_cast<int>(v * 6) * 6 + static_cast<int>(u * 6)];
}

Eigen::Vector3f PlateSurface::albedo(const Eigen::Vector2f& p) const {
  const float radius = p.norm();
  if (radius > kRingInner && radius < kRingOuter) {
    const float step = 2 * std::numbers::pi_v<float> / kMarkers;
    const int id =
        (static_cast<int>(std::lround(std::atan2(p.y(), p.x()) / step)) + kMarkers) % kMarkers;
    const float c = std::cos(step * static_cast<float>(id)),
                s = std::sin(step * static_cast<float>(id));
    const float down = static_cast<float>(kRing) - (c * p.x() + s * p.y()),
                right = s * p.x() - c * p.y();
    const float reach = static_cast<float>(kSide) / 2 + kPaperMargin;
    if (id >= covered_ && std::abs(down) < reach && std::abs(right) < reach) {
      const float fibre = 1 + 0.02f * vessels::noise({p.x() * 2, p.y() * 2, 0}, seed_ + 9);
      return Eigen::Vector3f(0.98f, 1.f, 0.97f) * (fibre * (ink(id, right, down) ? kInk : kPaper));
    }
    if (id < covered_)
      return Eigen::Vector3f(0.10f, 0.12f, 0.2f) *
             (1 + 0.3f * vessels::noise({p.x(), p.y(), 3}, seed_ + 8));
  }
  const float cloud = vessels::fractalNoise({p.x() / 14, p.y() / 14, 0}, seed_, 2);
  const float fibre = vessels::fractalNoise({p.x() / 1.1f, p.y() / 1.1f, 0}, seed_ + 4, 2);
  return felt_ * (1 + 0.10f * cloud + 0.12f * fibre);
}

BoardSurface::BoardSurface() : pixels_per_mm_(8) {
  const batch::Board b = rig::standardBoard();
  const auto board = cv::aruco::CharucoBoard::create(
      b.squares_x, b.squares_y, static_cast<float>(b.square_mm), static_cast<float>(b.marker_mm),
      cv::aruco::getPredefinedDictionary(cv::aruco::DICT_5X5_100));
  width_ = static_cast<float>(b.squares_x * b.square_mm);
  height_ = static_cast<float>(b.squares_y * b.square_mm);
  columns_ = static_cast<int>(std::lround(width_ * pixels_per_mm_));
  rows_ = static_cast<int>(std::lround(height_ * pixels_per_mm_));
  cv::Mat picture;
  board->draw({columns_, rows_}, picture, 0, 1);
  pixels_.assign(picture.data, picture.data + static_cast<std::size_t>(columns_) * rows_);
}

float BoardSurface::brightness(const Eigen::Vector2f& p) const {
  if (p.x() < -kMargin || p.y() < -kMargin || p.x() > width_ + kMargin || p.y() > height_ + kMargin)
    return -1;
  const int x = static_cast<int>(std::floor(p.x() * pixels_per_mm_)),
            y = static_cast<int>(std::floor(p.y() * pixels_per_mm_));
  if (x < 0 || y < 0 || x >= columns_ || y >= rows_) return kPaper;
  return pixels_[static_cast<std::size_t>(y) * columns_ + x] > 127 ? kPaper : kInk;
}

}  // namespace ostraka::rendering
