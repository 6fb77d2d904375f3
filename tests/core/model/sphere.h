#pragma once
#include <cmath>
#include <numbers>

#include "model/surfels.h"

namespace ostraka::model {

// Surfels of a sphere around the origin without noise, evenly spread (a spiral of the golden
// angle).
inline Surfels sphereSurfels(float radius_mm, int count) {
  Surfels s;
  for (int i = 0; i < count; ++i) {
    const double z = 1 - (2.0 * i + 1) / count, r = std::sqrt(1 - z * z);
    const double turn = i * std::numbers::pi * (3 - std::sqrt(5.0));
    const Eigen::Vector3f n =
        Eigen::Vector3d(r * std::cos(turn), r * std::sin(turn), z).cast<float>();
    s.points.push_back(radius_mm * n);
    s.normals.push_back(n);
  }
  const double area = 4 * std::numbers::pi * radius_mm * radius_mm / count;
  s.noise.assign(s.points.size(), 0.01F);
  s.confidence.assign(s.points.size(), 1);
  s.area.assign(s.points.size(), static_cast<float>(area));
  s.spacing_mm = std::sqrt(area);
  return s;
}

}  // namespace ostraka::model
