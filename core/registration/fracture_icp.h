#pragma once
#include <Eigen/Geometry>
#include <vector>

#include "registration/evidence.h"
#include "registration/strip.h"

namespace ostraka::registration {

struct FracturePairing {
  double radius_mm = 1;     ///< closest pairs farther apart do not count
  double min_cos = 0.7071;  ///< normals must agree to 45 degrees
  double robust_mm = 1;     ///< Tukey's biweight is zero from here on
  double sigma_mm = 0.1;    ///< SD of one pair's distance along the normal
  double correlated = 10;   ///< pairs that carry the information of one independent pair
  double bias_mm = 0.02;    ///< SD of the strips' common error in height at the fracture's ends
};

struct FractureFit {
  Evidence evidence;    ///< the common error in height and tilt already taken out
  double rms_mm = 0;    ///< along the normal, over all pairs in the radius
  double sigma_mm = 0;  ///< robust SD along the normal
  double overlap = 0;   ///< pairs / points asked
  double spread = 0;    ///< mean of min(r^2 / robust^2, 1); a point without partner counts 1
  int pairs = 0;
};

/// Which point of `to` each point of `from` touches: the nearest within radius_mm whose normal
/// agrees; -1: none. What every figure and picture of a fracture takes for contact.
std::vector<int> partnersOf(const StripLevel& from, const StripLevel& to,
                            const Eigen::Isometry3d& to_from_from, const FracturePairing& pairing);

/// Symmetric point-to-plane on closest pairs in both directions (Rusinkiewicz 2019's symmetric
/// normal): r = n . (T q - p), n along n_p + n_q. The strips' fatness is an unknown b(x, y) n.up,
/// b linear over the sherd with SD bias_mm, which is marginalised: fat strips say nothing of
/// height.
FractureFit fitFracture(const StripLevel& front, const StripLevel& back,
                        const Eigen::Vector3d& front_up, const Eigen::Isometry3d& front_from_back,
                        const Eigen::Vector3d& pivot, double radius_of_sherd_mm,
                        const FracturePairing& pairing);

}  // namespace ostraka::registration
