#pragma once
#include <Eigen/Geometry>
#include <vector>

#include "registration/strip.h"

namespace ostraka::registration {

/// How well two sides fit at a pose, which nothing moves: for poses made by hand.
struct PoseFigures {
  double fracture_rms_mm = 0;  ///< as Registration::fracture_rms_mm; 0 where no points meet
  double fracture_overlap = 0;
  double crossing_share = 0;
  double thickness_mm = 0;
};

/// The figures that registerSides reports, at this pose. About 20 ms.
PoseFigures figuresAt(const Strip& front, const Strip& back,
                      const Eigen::Isometry3d& front_from_back);

/// How far the sides' surfaces lie apart at each point of Strip::fine, mm along the normals,
/// positive: the back outside the front; NaN where the point touches nothing. Of all points of both
/// sides, those that touch are figuresAt's fracture_overlap.
struct FractureGaps {
  std::vector<float> front_mm, back_mm;
};
FractureGaps fractureGaps(const Strip& front, const Strip& back,
                          const Eigen::Isometry3d& front_from_back);

}  // namespace ostraka::registration
