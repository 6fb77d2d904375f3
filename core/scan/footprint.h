#pragma once
#include <Eigen/Core>
#include <span>
#include <vector>

#include "cloud/point_cloud.h"

namespace ostraka::scan {

/// Squares of 1 mm that hold points, seen from above.
double areaFromAbove_mm2(const PointCloud& piece);

/// The cells that points occupy, seen along an axis; holes are filled. A margin of free cells
/// surrounds them.
class Footprint {
 public:
  /// At least one point; mm.
  Footprint(std::span<const Eigen::Vector2d> points, double cell_mm);

  /// Distance from the point's cell to the outside, mm, within 6 % (3x3 chamfer); 0 outside.
  double depth(const Eigen::Vector2d& p) const { return depth_[cellOf(p)]; }

  std::size_t cellOf(const Eigen::Vector2d& p) const;

 private:
  void sweep();

  double cell_mm_;
  Eigen::Vector2d low_;
  int columns_ = 0, rows_ = 0;
  std::vector<double> depth_;
};

}  // namespace ostraka::scan
