#pragma once
#include <Eigen/Core>
#include <span>

#include "base/result.h"

namespace ostraka::pairing {

struct PaperCost {
  double cost = 0;  ///< radians, root mean square
  int shift = 0;    ///< start point on the second contour, of 200
};

/// The descriptor of Wang et al., ICCV 2023, section 3.1, kept as the reference: 200 samples, sums
/// of turning angles, smallest distance over the start points; size does not count. The second
/// contour is given mirrored already. Errors as turningAngles.
Result<PaperCost> paperCost(std::span<const Eigen::Vector2d> front,
                            std::span<const Eigen::Vector2d> back_mirrored);

}  // namespace ostraka::pairing
