#include "registration/testimony.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <vector>

namespace ostraka::registration {
namespace {

// A witness's own statement of its error counts like this many observed contradictions: its sigmas
// come from its own scatter, so they are known about as well as from a handful of samples.
constexpr double kBelief = 4;

// Chi-square of what a witness would change alone, and what its redundancy lets expect.
struct Contradiction {
  double found, expected;
};

std::vector<Contradiction> contradictions(std::span<const Testimony> testimonies,
                                          const Matrix6& start) {
  const Matrix6 joint = (together(testimonies).information + start).inverse();
  std::vector<Contradiction> all;
  for (const Testimony& t : testimonies) {
    const Matrix6 own = (t.evidence.information + start).inverse();
    const double freedoms = (own * t.evidence.information).trace();
    const double followed = t.trust * (joint * t.evidence.information).trace();
    all.push_back(
        {t.evidence.gradient.dot(own * t.evidence.gradient), std::max(0.0, freedoms - followed)});
  }
  return all;
}

}  // namespace

Evidence together(std::span<const Testimony> testimonies) {
  Evidence sum;
  for (const Testimony& t : testimonies) {
    sum.information += t.trust * t.evidence.information;
    sum.gradient += t.trust * t.evidence.gradient;
    sum.cost += t.trust * t.evidence.cost;
  }
  return sum;
}

void learnTrust(std::span<Testimony> testimonies, const Matrix6& start) {
  const std::vector<Contradiction> all = contradictions(testimonies, start);
  for (std::size_t k = 0; k < all.size(); ++k)
    testimonies[k].trust = std::min(1.0, (kBelief + all[k].expected) / (kBelief + all[k].found));
}

double strain(std::span<const Testimony> testimonies, const Matrix6& start) {
  const std::vector<Contradiction> all = contradictions(testimonies, start);
  double found = kBelief, expected = kBelief;
  for (std::size_t k = 0; k < all.size(); ++k) {
    found += testimonies[k].trust * all[k].found;
    expected += all[k].expected;
  }
  return std::sqrt(std::max(1.0, found / expected));
}

}  // namespace ostraka::registration
