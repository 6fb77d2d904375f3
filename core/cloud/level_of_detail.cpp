#include "cloud/level_of_detail.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>

#include "cloud/bounds.h"

namespace ostraka {
namespace {

using Eigen::Vector3f;
using Eigen::Vector3i;

constexpr double kPointsPerCell = 9;  // fewer scatter, more blur the edge of a dense part
constexpr int kGridRounds = 4;        // each brings the cell's edge nearer to that many points

using Counts = std::unordered_map<Vector3i, int, CellHash>;

Vector3i cellOf(const Vector3f& point, float edge) {
  return (point / edge).array().floor().cast<int>();
}

Counts countPerCell(const std::vector<Vector3f>& points, float edge) {
  Counts counts;
  for (const Vector3f& p : points) ++counts[cellOf(p, edge)];
  return counts;
}

// Of cells that hold kPointsPerCell points of a surface on average.
float gridEdge(const std::vector<Vector3f>& points) {
  const auto [low, high] = boundsOf(points);
  const float diagonal = std::max((high - low).norm(), 1e-3f);
  float edge = diagonal / 32;
  for (int round = 0; round < kGridRounds; ++round) {
    const double cells = static_cast<double>(countPerCell(points, edge).size());
    const double filled = static_cast<double>(points.size()) / cells;
    edge *= static_cast<float>(std::clamp(std::sqrt(kPointsPerCell / filled), 0.1, 10.0));
    edge = std::clamp(edge, diagonal * 1e-4f, diagonal);
  }
  return edge;
}

}  // namespace

std::vector<float> localSpacing(const std::vector<Vector3f>& points) {
  if (points.empty()) return {};
  const float edge = gridEdge(points);
  const Counts counts = countPerCell(points, edge);
  std::unordered_map<Vector3i, float, CellHash> spacing;
  for (const auto& [cell, count] : counts) {
    int cells = 0, inside = 0;
    for (int x = -1; x <= 1; ++x)
      for (int y = -1; y <= 1; ++y)
        for (int z = -1; z <= 1; ++z) {
          const auto at = counts.find(cell + Vector3i(x, y, z));
          if (at == counts.end()) continue;
          ++cells;
          inside += at->second;
        }
    spacing[cell] = edge * std::sqrt(static_cast<float>(cells) / static_cast<float>(inside));
  }
  std::vector<float> found;
  found.reserve(points.size());
  for (const Vector3f& p : points) found.push_back(spacing[cellOf(p, edge)]);
  return found;
}

std::vector<int> sampledIndices(std::size_t count, std::size_t most) {
  std::vector<int> indices;
  most = std::min(count, most);
  indices.reserve(most);
  for (std::size_t i = 0; i < most; ++i) {
    const std::size_t from = i * count / most, to = (i + 1) * count / most;
    const std::uint32_t scattered = static_cast<std::uint32_t>(i) * 2654435761u >> 8;
    indices.push_back(static_cast<int>(from + scattered % (to - from)));
  }
  return indices;
}

std::vector<std::array<int, 3>> coarseTriangles(const TriangleMesh& mesh, std::size_t most) {
  if (mesh.triangles.size() <= most) return mesh.triangles;
  const auto at = [&](int i) -> const Vector3f& {
    return mesh.vertices[static_cast<std::size_t>(i)];
  };
  double area = 0;
  for (const auto& t : mesh.triangles)
    area += 0.5 * (at(t[1]) - at(t[0])).cross(at(t[2]) - at(t[0])).cast<double>().norm();
  // A cube that a surface crosses keeps one vertex, and of those a mesh has half as many as
  // triangles; a slanted surface crosses half as many cubes again.
  const float edge =
      static_cast<float>(std::sqrt(3 * std::max(area, 1e-12) / static_cast<double>(most)));
  std::unordered_map<Vector3i, int, CellHash> chosen;
  const auto fromMiddle = [&](const Vector3i& cell, int i) {
    return (at(i) / edge - cell.cast<float>() - Vector3f::Constant(0.5f)).squaredNorm();
  };
  const int count = static_cast<int>(mesh.vertices.size());
  for (int i = 0; i < count; ++i) {
    const Vector3i cell = cellOf(at(i), edge);
    const auto [found, is_new] = chosen.try_emplace(cell, i);
    if (!is_new && fromMiddle(cell, i) < fromMiddle(cell, found->second)) found->second = i;
  }
  std::vector<int> stands(mesh.vertices.size());
  for (int i = 0; i < count; ++i) stands[static_cast<std::size_t>(i)] = chosen[cellOf(at(i), edge)];
  std::vector<std::array<int, 3>> kept;
  for (const auto& t : mesh.triangles) {
    const std::array<int, 3> c = {stands[static_cast<std::size_t>(t[0])],
                                  stands[static_cast<std::size_t>(t[1])],
                                  stands[static_cast<std::size_t>(t[2])]};
    if (c[0] != c[1] && c[1] != c[2] && c[2] != c[0]) kept.push_back(c);
  }
  return kept;
}

}  // namespace ostraka
