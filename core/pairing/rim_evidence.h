#pragma once
#include <span>
#include <vector>

namespace ostraka::pairing {

/// What one registered candidate says.
struct RimFigures {
  int front = 0, back = 0;
  double outline_log_likelihood = 0;  ///< of the start that the registration came from
  double rim_rms_mm = 0;              ///< of the registered strips
  double rim_log_likelihood = 0;      ///< the registration's own, used where the batch is too small
};

/// Per candidate the logarithm of the ratio of likelihoods of its rim's RMS: one sherd against a
/// look-alike. How well true rims fit depends on the scans (0.1 mm clean, 0.3 mm of ragged stereo):
/// the batch says it itself, as the median over the pairs that outlines alone make certain; with
/// fewer than three of them, the registration's own figure stands. One registration in twenty fails
/// on a true pair, so a bad rim never says more than -3.
std::vector<double> rimLogLikelihoods(std::span<const RimFigures> candidates);

}  // namespace ostraka::pairing
