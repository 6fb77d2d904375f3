#pragma once
#include <cmath>

namespace ostraka {

/// OpenCV leaves its algebra to LAPACK, and some LAPACKs round by where the memory happens to lie.
/// What comes from there and goes into results is kept to `step` (far below what it is known to,
/// far above that noise), so that the same photographs give the same bytes.
inline double rounded(double value, double step) {
  return step * std::round(value / step);
}

}  // namespace ostraka
