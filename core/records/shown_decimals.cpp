#include "records/shown_decimals.h"

#include <algorithm>
#include <cmath>

#include "records/sherd.h"

namespace ostraka::records {
namespace {

constexpr int kMostTyped = 3;  // a micrometre: no calliper and no pair of scales says more

double rounded(double value, int decimals) {
  const double unit = std::pow(10.0, decimals);
  return std::round(value * unit) / unit + 0.0;  // -0 + 0 is 0
}

}  // namespace

std::string unitOfMeasure(const std::string& kind_or_field) {
  const std::string unit = unitOf(kind_or_field);
  return unit.empty() ? unitOf(kind_or_field.substr(0, kind_or_field.rfind('_'))) : unit;
}

int decimalsShown(const std::string& unit) {
  return unit == "mm" || unit == "g" ? 1 : 0;
}

double shownValue(double value, const std::string& unit) {
  return rounded(value, decimalsShown(unit));
}

double shownUncertainty(double uncertainty, const std::string& unit) {
  return std::max(shownValue(uncertainty, unit), std::pow(10.0, -decimalsShown(unit)));
}

int decimalsEdited(double value, const std::string& unit) {
  const int shown = decimalsShown(unit);
  for (int decimals = shown; decimals <= kMostTyped; ++decimals)
    if (rounded(value, decimals) == value) return decimals;
  return shown;
}

}  // namespace ostraka::records
