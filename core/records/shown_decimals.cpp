#include "records/shown_decimals.h"

#include <algorithm>
#include <cmath>

namespace ostraka::records {
namespace {

constexpr int kMostTyped = 3;  // a micrometre: no calliper and no pair of scales says more

}  // namespace

int decimalsShown(double value, const std::optional<double>& uncertainty, int usual) {
  for (int decimals = 0; decimals <= kMostTyped; ++decimals) {
    const double unit = std::pow(10.0, decimals);
    if (std::round(value * unit) / unit == value) return decimals;
  }
  if (!(uncertainty && *uncertainty > 0)) return std::abs(value) >= 1000 ? 0 : usual;
  const double place = std::floor(std::log10(*uncertainty));
  const double first = *uncertainty / std::pow(10.0, place);
  return std::max(0, static_cast<int>(first < 2 ? 1 - place : -place));
}

}  // namespace ostraka::records
