#include "registration/constraint.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <vector>

namespace ostraka::registration {
namespace {

// A constraint's own statement of its error counts like this many observed contradictions: its
// sigmas come from its own scatter, so they are known about as well as from a handful of samples.
constexpr double kBelief = 4;

// Chi-square of what a constraint would change alone, and what its redundancy lets expect.
struct Contradiction {
  double found, expected;
};

std::vector<Contradiction> contradictions(std::span<const Constraint> constraints,
                                          const Matrix6& start) {
  const Matrix6 joint = (together(constraints).information + start).inverse();
  std::vector<Contradiction> all;
  for (const Constraint& t : constraints) {
    const Matrix6 own = (t.evidence.information + start).inverse();
    const double freedoms = (own * t.evidence.information).trace();
    const double followed = t.weight * (joint * t.evidence.information).trace();
    all.push_back(
        {t.evidence.gradient.dot(own * t.evidence.gradient), std::max(0.0, freedoms - followed)});
  }
  return all;
}

}  // namespace

Evidence together(std::span<const Constraint> constraints) {
  Evidence sum;
  for (const Constraint& t : constraints) {
    sum.information += t.weight * t.evidence.information;
    sum.gradient += t.weight * t.evidence.gradient;
    sum.cost += t.weight * t.evidence.cost;
  }
  return sum;
}

void learnWeights(std::span<Constraint> constraints, const Matrix6& start) {
  const std::vector<Contradiction> all = contradictions(constraints, start);
  for (std::size_t k = 0; k < all.size(); ++k)
    constraints[k].weight = std::min(1.0, (kBelief + all[k].expected) / (kBelief + all[k].found));
}

double inconsistency(std::span<const Constraint> constraints, const Matrix6& start) {
  const std::vector<Contradiction> all = contradictions(constraints, start);
  double found = kBelief, expected = kBelief;
  for (std::size_t k = 0; k < all.size(); ++k) {
    found += constraints[k].weight * all[k].found;
    expected += all[k].expected;
  }
  return std::sqrt(std::max(1.0, found / expected));
}

}  // namespace ostraka::registration
