#pragma once
#include <iterator>
#include <utility>

namespace ostraka {

/// The lowest and the highest coordinates of these points; there must be one.
template <class Points>
auto boundsOf(const Points& points) {
  auto low = *std::begin(points), high = low;
  for (const auto& p : points) low = low.cwiseMin(p), high = high.cwiseMax(p);
  return std::pair(low, high);
}

}  // namespace ostraka
