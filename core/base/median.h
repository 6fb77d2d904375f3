#pragma once
#include <algorithm>
#include <cstddef>
#include <vector>

namespace ostraka {

/// The median, the upper of the two middle values; independent of the order of the values. 0 for
/// none. Reorders the values. O(n).
template <class T>
T medianOf(std::vector<T>& values) {
  if (values.empty()) return T{};
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

template <class T>
T medianOf(std::vector<T>&& values) {
  return medianOf(values);
}

/// The value at this share of the sorted ones, the lower of two; as medianOf otherwise.
template <class T>
T rankedAt(std::vector<T> values, double share) {
  if (values.empty()) return T{};
  const auto at =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// Linear between the two values around the rank, as numpy's quantile. At least one value.
inline double quantileOf(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  const double rank = share * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(rank);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (rank - static_cast<double>(below)) * (values[above] - values[below]);
}

}  // namespace ostraka
