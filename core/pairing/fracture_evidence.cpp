#include "pairing/fracture_evidence.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ostraka::pairing {
namespace {

constexpr double kRelief_mm = 0.22;   // two breaks of like outlines differ by this
constexpr double kOtherSpread = 0.4;  // of its logarithm, from pair to pair
constexpr double kSameSpread = 0.2;   // of the logarithm of true pairs' misfits within a batch
constexpr double kFailed = 0.01;  // share of true pairs whose registration says nothing: 1 of 370

// Usual misfits of true pairs, all as likely at first: a good scanner's to the worst stereo's.
constexpr double kLeastUsual_mm = 0.01, kMostUsual_mm = 0.30, kUsualStep = 0.1;

// Share of non-matches among pairs that outlines make certain: next to none, but in one batch of a
// hundred.
struct NonMatches {
  double share, prior;
};
constexpr std::array<NonMatches, 2> kNonMatches = {{{0.002, 0.99}, {0.3, 0.01}}};

double normal(double x, double sigma) {
  return std::exp(-0.5 * x * x / (sigma * sigma)) / sigma;
}

// Densities of a misfit's logarithm; a floor keeps an outlier from deciding alone.
struct Densities {
  double same, other;
};
Densities densities(const FractureFigures& c, double usual_mm) {
  const double at = std::log(std::max(1e-3, c.misfit_mm));
  const double counted = 0.5 / std::max(1.0, c.places);  // variance of an RMS' logarithm
  constexpr double kFloor = 1e-30;
  return {normal(at - std::log(usual_mm), std::sqrt(kSameSpread * kSameSpread + counted)) + kFloor,
          normal(at - std::log(std::hypot(kRelief_mm, usual_mm)),
                 std::sqrt(kOtherSpread * kOtherSpread + counted)) +
              kFloor};
}

/// Certain by its outlines: they are alike, and no other pair of its front or back comes near.
std::vector<bool> certainOnes(std::span<const FractureFigures> candidates) {
  constexpr double kCertain = 10;  // logarithm; above any non-match's
  std::vector<bool> certain;
  for (const FractureFigures& own : candidates) {
    const bool rivalled = std::ranges::any_of(candidates, [&](const FractureFigures& c) {
      const bool other = (c.front == own.front) != (c.back == own.back);
      return other && c.outline_log_likelihood > own.outline_log_likelihood - kCertain;
    });
    certain.push_back(own.outline_log_likelihood > kCertain && !rivalled);
  }
  return certain;
}

/// What the scans of this batch may be like, with its probability.
struct Case {
  double usual_mm, non_matches, probability;
};
std::vector<Case> casesOf(std::span<const FractureFigures> candidates,
                          const std::vector<bool>& certain) {
  std::vector<Case> cases;
  double most = -1e300;
  for (double usual = kLeastUsual_mm; usual <= kMostUsual_mm; usual *= std::exp(kUsualStep))
    for (const NonMatches& non_matches : kNonMatches) {
      double log = std::log(non_matches.prior);
      for (std::size_t i = 0; i < candidates.size(); ++i) {
        if (!certain[i]) continue;
        const Densities d = densities(candidates[i], usual);
        log += std::log((1 - non_matches.share) * d.same + non_matches.share * d.other);
      }
      cases.push_back({usual, non_matches.share, log});
      most = std::max(most, log);
    }
  for (Case& c : cases) c.probability = std::exp(c.probability - most);
  return cases;
}

}  // namespace

std::vector<double> fractureLogLikelihoods(std::span<const FractureFigures> candidates) {
  const std::vector<bool> certain = certainOnes(candidates);
  const std::vector<Case> cases = casesOf(candidates, certain);
  const double few = kNonMatches[0].share;
  std::vector<double> found;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    double same = 0, other = 0;
    for (const Case& c : cases) {
      const Densities d = densities(candidates[i], c.usual_mm);
      // A certain pair has shaped the cases' probabilities itself; against the usual share of
      // non-matches its odds become a ratio of likelihoods again.
      const double both = certain[i] ? (1 - c.non_matches) * d.same + c.non_matches * d.other : 1.0;
      same += c.probability / both * d.same * (certain[i] ? (1 - c.non_matches) / (1 - few) : 1);
      other += c.probability / both * d.other * (certain[i] ? c.non_matches / few : 1);
    }
    found.push_back(std::log((1 - kFailed) * same / other + kFailed));
  }
  return found;
}

}  // namespace ostraka::pairing
