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

/// One point of the fracture and how far the sides' surfaces lie apart there.
struct FractureDistance {
  Eigen::Vector3f point = Eigen::Vector3f::Zero();  ///< front's frame, mm
  float distance_mm = 0;  ///< along the normals, positive: the back outside the front
};

/// Both strips' points that meet the other side within reach_mm with normals within 45 degrees.
std::vector<FractureDistance> fractureDistances(const Strip& front, const Strip& back,
                                                const Eigen::Isometry3d& front_from_back,
                                                double reach_mm);

}  // namespace ostraka::registration
