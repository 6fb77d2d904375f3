#pragma once
#include <cmath>
#include <numbers>

#include "cloud/point_cloud.h"

namespace ostraka::exchange {

/// A closed piece of a bowl's wall with a wavy outline: about 56 by 44 mm, 7 mm thick, outward.
inline TriangleMesh closedShell(int rings = 40, int steps = 96) {
  TriangleMesh mesh;
  const auto power = [](double v, double e) { return std::copysign(std::pow(std::abs(v), e), v); };
  const auto add = [&](double across, double up, double angle) {
    const double wave = 1 + 0.06 * std::sin(3 * angle) + 0.03 * std::sin(7 * angle);
    const double x = 28 * wave * across * std::cos(angle), y = 22 * wave * across * std::sin(angle);
    mesh.vertices.emplace_back(static_cast<float>(x), static_cast<float>(y),
                               static_cast<float>(up - (x * x + y * y) / 160));
    const auto clay = static_cast<std::uint8_t>(150 + 30 * std::sin(5 * angle));
    mesh.colors.push_back({clay, 110, 80});
  };
  add(0, -3.5, 0);
  for (int r = 1; r < rings; ++r)
    for (int s = 0; s < steps; ++s) {
      const double phi = std::numbers::pi * (static_cast<double>(r) / rings - 0.5);
      add(power(std::cos(phi), 0.4), 3.5 * power(std::sin(phi), 0.4),
          2 * std::numbers::pi * s / steps);
    }
  add(0, 3.5, 0);
  const auto at = [steps](int r, int s) { return 1 + (r - 1) * steps + s % steps; };
  const int last = 1 + (rings - 1) * steps;
  for (int s = 0; s < steps; ++s) {
    mesh.triangles.push_back({0, at(1, s + 1), at(1, s)});
    for (int r = 1; r + 1 < rings; ++r) {
      mesh.triangles.push_back({at(r, s), at(r, s + 1), at(r + 1, s + 1)});
      mesh.triangles.push_back({at(r, s), at(r + 1, s + 1), at(r + 1, s)});
    }
    mesh.triangles.push_back({at(rings - 1, s), at(rings - 1, s + 1), last});
  }
  return mesh;
}

}  // namespace ostraka::exchange
