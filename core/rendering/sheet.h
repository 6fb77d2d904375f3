#pragma once
#include <array>
#include <vector>

#include "batch/batch.h"
#include "rendering/hand_held.h"
#include "rendering/lighting.h"
#include "vessels/noise.h"

namespace ostraka::rendering {

/// The sheet as it lies there: paper, print, and how it bends.
class SheetSurface final : public Ground {
 public:
  SheetSurface(rig::SheetSize size, double bend_mm, vessels::Random& random);

  const batch::Plate& plate() const { return plate_; }
  bool holds(const Eigen::Vector2f& p) const {
    return std::abs(p.x()) < half_.x() && std::abs(p.y()) < half_.y();
  }
  /// Negative on the paper, else the distance from it, mm.
  float distance(const Eigen::Vector2f& p) const;
  /// Inside of all markers: blank.
  bool blank(const Eigen::Vector2f& p) const {
    return std::abs(p.x()) < blank_.x() && std::abs(p.y()) < blank_.y();
  }
  Eigen::Vector3f albedo(const Eigen::Vector2f& p) const;
  Eigen::Vector3f meanAlbedo(const Eigen::Vector2f& p) const override;
  /// Above the table, mm, and its slope.
  float height(const Eigen::Vector2f& p) const;
  Eigen::Vector2f slope(const Eigen::Vector2f& p) const;
  /// The frame in which plate.json states its markers, as a bent sheet has it: origin in the middle
  /// of the paper, z across it there.
  Eigen::Isometry3d tableFromPlate() const;

 private:
  bool ink(const Eigen::Vector2f& p) const;

  batch::Plate plate_;
  Eigen::Vector2f half_, blank_;
  std::vector<std::array<std::uint8_t, 49>> bits_;  // 7 x 7 with the black border; 1 = white
  std::vector<int> cells_;                          // marker + 1 by cells of 2 mm
  int columns_ = 0;
  float paper_, ink_, spread_mm_;
  std::array<float, 5> bend_{};  // of x, y, xx, xy, yy in halves of the paper; then lifted to 0
  float lift_ = 0;
};

/// plate_from_model of a sherd that lay at rest on an even sheet: tilted with the paper below it,
/// and touching it.
Eigen::Isometry3d restingOn(const SheetSurface& sheet, const Eigen::Isometry3d& pose,
                            const std::vector<Eigen::Vector3f>& vertices_model);

}  // namespace ostraka::rendering
