#pragma once
#include <Eigen/Core>
#include <vector>

#include "cloud/point_cloud.h"

namespace ostraka::scan {

/// Where two touching sherds were told apart.
struct Neck {
  Eigen::Vector2d place = Eigen::Vector2d::Zero();  ///< plate, mm
  double width_mm = 0;
};

struct TouchingParts {
  int count = 1;
  std::vector<int> part;  ///< per point, 0 .. count - 1
  std::vector<Neck> necks;
};

/// Sherds that touch show as one piece with a neck in its outline seen from above. The outline is
/// worn down step by step; where it falls into parts and the neck is narrower than neck_share of
/// the smaller part, each of at least min_extent_mm, the piece is cut and each point goes to the
/// part that its place is nearest to. A sherd's own waist is wider than that.
TouchingParts cutTouching(const PointCloud& piece, double neck_share, double min_extent_mm);

}  // namespace ostraka::scan
