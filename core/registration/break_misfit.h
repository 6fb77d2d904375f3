#pragma once
#include <Eigen/Geometry>

#include "registration/strip.h"

namespace ostraka::registration {

/// How far two breaks differ where both sides show them, noise averaged away.
struct BreakMisfit {
  double rms_mm = 0;  ///< of the mean signed distance over patches of 1.5 mm radius; 0: no patch
  /// Neighbouring points of the back's strip that err together and count as one: 1 for white noise.
  double alike = 1;
  double places = 0;  ///< independent patches: what rms_mm can be trusted to, 1 / sqrt(2 places)
};

/// Noise of scans is alike over a millimetre or two, the relief by which two breaks differ over
/// several: means over patches keep the second and lose much of the first. A common fatness, even
/// or growing towards the viewer, is taken out. back is laid by front_from_back.
BreakMisfit breakMisfit(const Strip& front, const Strip& back,
                        const Eigen::Isometry3d& front_from_back);

}  // namespace ostraka::registration
