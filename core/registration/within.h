#pragma once

namespace ostraka::registration {

/// How far the back may lie off, RMS over its points: people are told this, not one sigma. Of
/// simulated pairs at least 95 % lie nearer to the truth (docs/joining.md).
constexpr double within95_mm(double uncertainty_mm) {
  return 2 * uncertainty_mm;
}

}  // namespace ostraka::registration
