#pragma once
#include <span>

#include "registration/evidence.h"

namespace ostraka::registration {

/// What one constraint says of a pose, and how far it is believed.
struct Constraint {
  Evidence evidence;
  double weight = 1;  ///< 0..1, a factor of its information
};

/// All evidence, each constraint as far as it is believed.
Evidence together(std::span<const Constraint> constraints);

/// Learns the weights from how far each constraint contradicts the others at the present pose: its
/// chi-square beside what its redundancy lets expect, as variance components are estimated
/// (Foerstner 1979), with Student's t for a prior. A scan that ends before the corner on which the
/// sherd stands, a mask that took a shadow for clay: what no scan shows of itself, the others tell.
/// start: information of the start pose, which keeps directions apart that a constraint is silent
/// of.
void learnWeights(std::span<Constraint> constraints, const Matrix6& start);

/// How much farther constraints lie apart, as far as they are believed, than their sigmas say: at
/// least 1, a factor of the joint uncertainty (Birge 1932).
double inconsistency(std::span<const Constraint> constraints, const Matrix6& start);

}  // namespace ostraka::registration
