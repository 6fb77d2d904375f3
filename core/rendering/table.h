#pragma once
#include <Eigen/Core>

#include "rendering/hand_held.h"
#include "vessels/gloss.h"
#include "vessels/noise.h"

namespace ostraka::rendering {

/// The table that a sheet lies on, and what is seen beyond its edges.
class TableSurface {
 public:
  TableSurface(TableKind kind, vessels::Random& random);

  /// p: in the sheet's frame, mm.
  bool holds(const Eigen::Vector2f& p) const;
  Eigen::Vector3f albedo(const Eigen::Vector2f& p) const;
  Eigen::Vector3f meanAlbedo() const { return mean_; }
  const vessels::Gloss& gloss() const { return gloss_; }
  /// Linear albedo of the floor at a point on it.
  Eigen::Vector3f floor(const Eigen::Vector2f& p) const;
  Eigen::Vector3f wall() const { return wall_; }

 private:
  Eigen::Vector3f wood(const Eigen::Vector2f& q) const;
  Eigen::Vector3f cloth(const Eigen::Vector2f& q) const;
  Eigen::Vector3f granite(const Eigen::Vector2f& q) const;
  Eigen::Vector3f cuttingMat(const Eigen::Vector2f& q) const;

  TableKind kind_;
  std::uint32_t seed_;
  Eigen::Matrix2f turn_;  // table from sheet
  Eigen::Vector2f shift_;
  Eigen::Vector2f low_, high_;  // the table's corners
  Eigen::Vector3f body_, second_, mean_, floor_, wall_;
  float period_mm_;  // of planks, checks
  vessels::Gloss gloss_;
};

}  // namespace ostraka::rendering
