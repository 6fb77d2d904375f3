#pragma once
#include <array>
#include <vector>

#include "batch/batch.h"
#include "rendering/lighting.h"
#include "vessels/noise.h"

namespace ostraka::rendering {

enum class PlateColor { Dark, Grey, Light, White };

/// The plate that the rig turns: 24 markers of DICT_4X4_100 on a ring, tops outward.
batch::Plate standardPlate();

/// Linear albedo of the plate's top: felt, marker paper and ink.
class PlateSurface final : public Ground {
 public:
  PlateSurface(PlateColor color, std::uint64_t seed);

  Eigen::Vector3f albedo(const Eigen::Vector2f& p) const;
  Eigen::Vector3f meanAlbedo(const Eigen::Vector2f&) const override { return felt_; }
  Eigen::Vector3f felt() const { return felt_; }
  /// Sides of the ring in which paper may lie, mm from the axis: sharp edges only there.
  static constexpr float kRingInner = 127, kRingOuter = 163;
  static constexpr float kRadius = 165;
  /// A cloth lies on the markers [0, count).
  void coverMarkers(int count) { covered_ = count; }

 private:
  bool ink(int marker, float right, float down) const;

  std::vector<std::array<std::uint8_t, 36>> bits_;  // 6 x 6 with the black border; 1 = white
  Eigen::Vector3f felt_;
  std::uint32_t seed_;
  int covered_ = 0;
};

/// The ChArUco board as a picture, 1 = paper, and its size.
class BoardSurface {
 public:
  BoardSurface();
  /// Linear brightness at a point of the board, mm from its upper left corner, y down; < 0 outside
  /// of the paper.
  float brightness(const Eigen::Vector2f& p) const;
  float width() const { return width_; }
  float height() const { return height_; }

 private:
  static constexpr float kMargin = 8;  // mm of paper around the squares
  float width_, height_, pixels_per_mm_;
  int columns_ = 0, rows_ = 0;
  std::vector<std::uint8_t> pixels_;
};

}  // namespace ostraka::rendering
