#include "ui/look/distance_scale.h"

#include <algorithm>
#include <cmath>

#include "ui/look/look.h"

namespace ostraka::ui {
namespace {

// Blue and vermilion of Okabe and Ito: apart for every common kind of colour blindness.
constexpr QRgb kBelow = 0xff0072b2, kZero = 0xfff7f7f5, kAbove = 0xffd55e00;
constexpr QRgb kNotSeen = 0xffd63bb4;

}  // namespace

QColor DistanceScale::of(double distance_mm) const {
  if (std::isnan(distance_mm)) return notSeen();
  const double t = std::clamp(distance_mm / reach_mm_, -1.0, 1.0);
  return mixed(kZero, t < 0 ? kBelow : kAbove, std::abs(t));
}

QColor DistanceScale::notSeen() {
  return QColor::fromRgb(kNotSeen);
}

}  // namespace ostraka::ui
