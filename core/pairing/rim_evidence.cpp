#include "pairing/rim_evidence.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace ostraka::pairing {
namespace {

/// Median RMS over pairs certain by their outlines: the best of its front and of its back by far.
std::optional<double> usualRms(std::span<const RimFigures> candidates) {
  constexpr double kCertain = 10;  // logarithm; above any stranger's
  constexpr std::size_t kFewest = 3;
  std::vector<double> figures;
  for (const RimFigures& own : candidates) {
    const bool rivalled =
        std::any_of(candidates.begin(), candidates.end(), [&](const RimFigures& c) {
          const bool other = (c.front == own.front) != (c.back == own.back);
          return other && c.outline_log_likelihood > own.outline_log_likelihood - kCertain;
        });
    if (own.outline_log_likelihood > kCertain && !rivalled) figures.push_back(own.rim_rms_mm);
  }
  if (figures.size() < kFewest) return std::nullopt;
  const auto middle = figures.begin() + static_cast<std::ptrdiff_t>(figures.size() / 2);
  std::nth_element(figures.begin(), middle, figures.end());
  return std::max(0.02, *middle);
}

}  // namespace

std::vector<double> rimLogLikelihoods(std::span<const RimFigures> candidates) {
  constexpr double kRelief = 0.25;       // mm: two breaks of like outlines differ by their relief
  constexpr double kSameSpread = 0.30;   // of the RMS' logarithm, from true pair to true pair
  constexpr double kOtherSpread = 0.45;  // reliefs differ more
  constexpr double kFailed = 0.05;       // share of true pairs whose registration says nothing
  const std::optional<double> usual = usualRms(candidates);
  std::vector<double> found;
  for (const RimFigures& c : candidates) {
    double ratio = c.rim_log_likelihood;
    if (usual) {
      const double rms = std::log(std::max(1e-3, c.rim_rms_mm));
      // A rim that fits better than usual is no evidence against the pair.
      const double same = std::max(0.0, rms - std::log(*usual)) / kSameSpread;
      const double other =
          std::min(0.0, rms - std::log(std::hypot(kRelief, *usual))) / kOtherSpread;
      ratio = 0.5 * (other * other - same * same) + std::log(kOtherSpread / kSameSpread);
    }
    found.push_back(std::log((1 - kFailed) * std::exp(ratio) + kFailed));
  }
  return found;
}

}  // namespace ostraka::pairing
