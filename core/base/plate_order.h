#pragma once
#include <Eigen/Core>
#include <cmath>

namespace ostraka {

/// Whether the piece with its middle at a is numbered before the one at b, both on the plate in mm:
/// rows of 40 mm from the far edge (+y) to the near one, each from left to right. The same rule
/// while the plate is photographed and for its results; their middles differ by some millimetres,
/// so pieces near the border of two rows may change places.
inline bool comesBefore(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  constexpr double kRow_mm = 40;
  const double row_a = std::floor(-a.y() / kRow_mm), row_b = std::floor(-b.y() / kRow_mm);
  return row_a != row_b ? row_a < row_b : a.x() < b.x();
}

}  // namespace ostraka
