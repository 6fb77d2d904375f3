#include "drawing/section.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace ostraka::drawing {

using Eigen::Vector2d;

std::vector<Loop> cut(const TriangleMesh& mesh, const Eigen::Isometry3d& view_from_model) {
  std::vector<Eigen::Vector3d> places;
  for (const Eigen::Vector3f& v : mesh.vertices) {
    places.push_back(view_from_model * v.cast<double>());
    // No vertex lies on the plane itself: then every cut triangle is entered and left once.
    if (std::abs(places.back().x()) < 1e-7) places.back().x() = 1e-7;
  }
  // Each cut triangle leads from the mesh edge where the plane enters it to that where it leaves;
  // neighbours share the edge, so the pieces close into loops by their edges' names.
  using Edge = std::pair<int, int>;
  std::map<Edge, Edge> next;
  const auto named = [](int a, int b) { return Edge(std::min(a, b), std::max(a, b)); };
  for (const auto& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) {
      const int a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3];
      const bool side_a = places[a].x() > 0, side_b = places[b].x() > 0, side_c = places[c].x() > 0;
      if (side_a == side_b || side_a == side_c) continue;
      if (side_a)
        next.emplace(named(a, b), named(c, a));
      else
        next.emplace(named(c, a), named(a, b));
    }
  const auto point = [&](const Edge& edge) {
    const Eigen::Vector3d &p = places[edge.first], &q = places[edge.second];
    const double t = p.x() / (p.x() - q.x());
    return Vector2d(p.y() + t * (q.y() - p.y()), p.z() + t * (q.z() - p.z()));
  };
  std::vector<Loop> loops;
  while (!next.empty()) {
    Loop loop;
    auto at = next.begin();
    const Edge start = at->first;
    while (at != next.end()) {
      loop.push_back(point(at->first));
      const Edge to = at->second;
      next.erase(at);
      at = to == start ? next.end() : next.find(to);
    }
    if (loop.size() >= 3) loops.push_back(std::move(loop));
  }
  return loops;
}

Shape hatched(const std::vector<Loop>& loops, double direction_rad, double spacing_mm,
              double stroke_mm) {
  Shape shape;
  shape.stroke = 0.0;
  shape.stroke_mm = stroke_mm;
  const Vector2d along(std::cos(direction_rad), std::sin(direction_rad));
  const Vector2d across(-along.y(), along.x());
  double low = 1e18, high = -1e18;
  for (const Loop& loop : loops)
    for (const Vector2d& p : loop) {
      low = std::min(low, across.dot(p));
      high = std::max(high, across.dot(p));
    }
  for (double off = std::ceil(low / spacing_mm) * spacing_mm; off < high; off += spacing_mm) {
    std::vector<double> crossings;
    for (const Loop& loop : loops)
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vector2d &p = loop[i], &q = loop[(i + 1) % loop.size()];
        const double a = across.dot(p) - off, b = across.dot(q) - off;
        if ((a > 0) == (b > 0)) continue;
        crossings.push_back(along.dot(p) + a / (a - b) * along.dot(q - p));
      }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t k = 0; k + 1 < crossings.size(); k += 2)
      shape.lines.push_back(
          {off * across + crossings[k] * along, off * across + crossings[k + 1] * along});
  }
  return shape;
}

}  // namespace ostraka::drawing
