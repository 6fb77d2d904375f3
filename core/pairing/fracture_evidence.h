#pragma once
#include <span>
#include <vector>

namespace ostraka::pairing {

/// What one registered candidate says.
struct FractureFigures {
  int front = 0, back = 0;
  double outline_log_likelihood = 0;  ///< of the start that the registration came from
  double misfit_mm = 0;               ///< how far the two breaks differ; above 0
  double places = 0;                  ///< independent places that misfit_mm comes from
};

/// Per candidate the logarithm of the ratio of likelihoods of its breaks' misfit: one sherd against
/// a near-duplicate. How well true breaks fit depends on the scans (0.04 mm clean, 0.15 mm of
/// ragged stereo), and a single scan does not tell: the batch says it itself, through all the pairs
/// that outlines alone make certain. Some of them may be non-matches, two sherds of like outlines
/// whose other sides are not there: how many is unknown too, so one that fits far worse than the
/// others is suspected, and then the others a little more. One registration in a hundred fails on a
/// true pair, so a bad fracture never says more than -4.6.
std::vector<double> fractureLogLikelihoods(std::span<const FractureFigures> candidates);

}  // namespace ostraka::pairing
