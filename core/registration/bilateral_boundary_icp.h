#pragma once
#include <Eigen/Geometry>
#include <stop_token>

#include "base/result.h"
#include "registration/strip.h"

namespace ostraka::registration {

struct BilateralBoundaryIcpOptions {
  double first_radius_mm = 3.0;  ///< start poses hold to a third of a wall
  double last_radius_mm = 0.8;   ///< 3 sigma of two strips at 0.24 mm per pixel
  int max_rounds = 400;          ///< point to point creeps in height along steep walls
  bool free_scale = false;       ///< also the back's size: --scale free, without a known length
  double scale_margin = 0.05;    ///< beyond what the covariances say: boundaries differ in what was
                                 ///< seen of them
};

struct BilateralBoundaryFit {
  Eigen::Isometry3d front_from_back = Eigen::Isometry3d::Identity();
  double scale = 1;   ///< p_front = T (scale * p_back)
  double rms_mm = 0;  ///< point to point over all pairs of the last round
  int pairs = 0;
};

/// Wang et al., ICCV 2023, equation 2: the boundary of each scan goes to the closest
/// points of the other scan, in both directions at once, point to point. With free_scale each round
/// also has the scale that its pairs want, within bounds, as Ying, Peng, Du, Qiao: A scale stretch
/// method based on ICP for 3D data registration, IEEE T-ASE 2009. Errors: Cancelled, NotEnough
/// (fewer than 10 pairs).
Result<BilateralBoundaryFit> bilateralBoundaryIcp(const Strip& front, const Strip& back,
                                                  const Eigen::Isometry3d& start,
                                                  const BilateralBoundaryIcpOptions& options,
                                                  std::stop_token stop);

}  // namespace ostraka::registration
