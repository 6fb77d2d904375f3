#include "ui/look/distance_scale.h"

#include <algorithm>
#include <cmath>

namespace ostraka::ui {
namespace {

// Blue and vermilion of Okabe and Ito: apart for every common kind of colour blindness.
constexpr QRgb kBelow = 0xff0072b2, kZero = 0xfff7f7f5, kAbove = 0xffd55e00;
constexpr QRgb kNotSeen = 0xffd63bb4;

}  // namespace

QColor DistanceScale::of(double distance_mm) const {
  if (std::isnan(distance_mm)) return notSeen();
  const double t = std::clamp(distance_mm / reach_mm_, -1.0, 1.0);
  const QColor zero = QColor::fromRgb(kZero), end = QColor::fromRgb(t < 0 ? kBelow : kAbove);
  const auto mix = [share = std::abs(t)](int from, int to) {
    return static_cast<int>(std::lround(from + share * (to - from)));
  };
  return {mix(zero.red(), end.red()), mix(zero.green(), end.green()), mix(zero.blue(), end.blue())};
}

QColor DistanceScale::notSeen() {
  return QColor::fromRgb(kNotSeen);
}

}  // namespace ostraka::ui
