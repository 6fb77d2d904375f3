#pragma once
#include <cmath>
#include <numbers>
#include <vector>

#include "cloud/points_and_meshes.h"

namespace ostraka::drawing {

/// A piece of a cylinder's wall, closed, outward, in steps of a millimetre: radius 60 mm outside
/// and 54 mm inside about z, 40 mm tall, a radian wide about x. Its upper end is an even lip;
/// breaks, the others, swing by 1.5 mm. broken_lip: the upper end is a break as well.
inline TriangleMesh wallPiece(bool broken_lip) {
  constexpr int kAround = 60, kUp = 40, kAcross = 6;
  constexpr double kOuter_mm = 60, kThickness_mm = 6;
  const auto swing = [](double t) { return 1.5 * std::sin(t / 1.4) + 0.7 * std::sin(t / 0.9); };
  std::vector<int> ids((kAround + 1) * (kUp + 1) * (kAcross + 1), -1);
  TriangleMesh mesh;
  const auto vertex = [&](int i, int j, int k) {
    int& id = ids[static_cast<std::size_t>((i * (kUp + 1) + j) * (kAcross + 1) + k)];
    if (id >= 0) return id;
    id = static_cast<int>(mesh.vertices.size());
    const double u = i / double{kAround}, v = j / double{kUp},
                 r = kOuter_mm - kThickness_mm * k / kAcross;
    const double turn = -0.5 + u + ((1 - u) * swing(j) + u * swing(j + 5)) / kOuter_mm;
    const double z = kUp * v + (1 - v) * swing(i + 3) + (broken_lip ? v * swing(i) : 0);
    mesh.vertices.push_back(
        Eigen::Vector3d(r * std::cos(turn), r * std::sin(turn), z).cast<float>());
    return id;
  };
  const auto quad = [&](int a, int b, int c, int d) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
  };
  for (int i = 0; i < kAround; ++i)
    for (int j = 0; j < kUp; ++j) {
      quad(vertex(i, j, 0), vertex(i + 1, j, 0), vertex(i + 1, j + 1, 0), vertex(i, j + 1, 0));
      quad(vertex(i, j, kAcross), vertex(i, j + 1, kAcross), vertex(i + 1, j + 1, kAcross),
           vertex(i + 1, j, kAcross));
    }
  for (int i = 0; i < kAround; ++i)
    for (int k = 0; k < kAcross; ++k) {
      quad(vertex(i, kUp, k), vertex(i + 1, kUp, k), vertex(i + 1, kUp, k + 1),
           vertex(i, kUp, k + 1));
      quad(vertex(i, 0, k), vertex(i, 0, k + 1), vertex(i + 1, 0, k + 1), vertex(i + 1, 0, k));
    }
  for (int j = 0; j < kUp; ++j)
    for (int k = 0; k < kAcross; ++k) {
      quad(vertex(kAround, j, k), vertex(kAround, j, k + 1), vertex(kAround, j + 1, k + 1),
           vertex(kAround, j + 1, k));
      quad(vertex(0, j, k), vertex(0, j + 1, k), vertex(0, j + 1, k + 1), vertex(0, j, k + 1));
    }
  return mesh;
}

}  // namespace ostraka::drawing
