#include "evaluate/samples.h"

#include <algorithm>
#include <array>
#include <random>

namespace ostraka::evaluate {
namespace {

// Uniform in [0, 1): std::uniform_real_distribution differs between libraries.
double uniform(std::mt19937_64& random) {
  return static_cast<double>(random() >> 11) * 0x1.0p-53;
}

}  // namespace

SurfaceSamples areaSamples(const TriangleMesh& mesh, double spacing_mm, std::uint64_t seed,
                           std::size_t most_samples) {
  std::vector<double> area_up_to;
  std::vector<Eigen::Vector3d> normals;
  double area = 0;
  const auto corner = [&](int v) { return Eigen::Vector3d(mesh.vertices[v].cast<double>()); };
  for (const std::array<int, 3>& t : mesh.triangles) {
    const Eigen::Vector3d a = corner(t[0]);
    const Eigen::Vector3d cross = (corner(t[1]) - a).cross(corner(t[2]) - a);
    const double length = cross.norm();
    normals.push_back(cross / std::max(length, 1e-12));
    area += 0.5 * length;
    area_up_to.push_back(area);
  }
  const double wanted = area / (spacing_mm * spacing_mm);
  const auto n = static_cast<std::size_t>(
      std::clamp(wanted, 2000.0, static_cast<double>(std::max<std::size_t>(most_samples, 2000))));
  std::mt19937_64 random(seed);
  SurfaceSamples samples;
  samples.points.reserve(n);
  samples.normals.reserve(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double at = (static_cast<double>(i) + uniform(random)) / static_cast<double>(n) * area;
    const auto found = std::lower_bound(area_up_to.begin(), area_up_to.end(), at);
    const auto f = std::min<std::size_t>(found - area_up_to.begin(), mesh.triangles.size() - 1);
    const double r = std::sqrt(uniform(random)), s = uniform(random);
    const std::array<int, 3>& t = mesh.triangles[f];
    samples.points.push_back((1 - r) * corner(t[0]) + r * (1 - s) * corner(t[1]) +
                             r * s * corner(t[2]));
    samples.normals.push_back(normals[f]);
  }
  return samples;
}

}  // namespace ostraka::evaluate
