#pragma once
#include <algorithm>
#include <cstddef>
#include <vector>

namespace ostraka {

/// The value in the middle, the upper of two, which is one of the values whatever their order; 0
/// where there is none. The values are left in another order. O(n).
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

}  // namespace ostraka
