#include "model/ray_grid.h"

#include <algorithm>
#include <cmath>

#include "cloud/bounds.h"

namespace ostraka::model {
namespace {

using Eigen::Array3i;
using Eigen::Vector3f;

template <class Visit>
void cubesOf(const TriangleMesh& mesh, const std::array<int, 3>& t, const Vector3f& low, float edge,
             const Array3i& size, Visit&& visit) {
  const Vector3f &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
  const Array3i first =
      ((a.cwiseMin(b).cwiseMin(c) - low) / edge).array().floor().cast<int>().max(0);
  const Array3i last =
      ((a.cwiseMax(b).cwiseMax(c) - low) / edge).array().floor().cast<int>().min(size - 1);
  for (int z = first[2]; z <= last[2]; ++z)
    for (int y = first[1]; y <= last[1]; ++y)
      for (int x = first[0]; x <= last[0]; ++x) visit((z * size[1] + y) * size[0] + x);
}

}  // namespace

RayGrid::RayGrid(const TriangleMesh& mesh) : mesh_(mesh), edge_(1) {
  const auto [low, high] = boundsOf(mesh.vertices);
  low_ = low;
  // About 2^21 cubes at most, and none finer than the triangles make sense of.
  const Eigen::Array3f box = (high - low_).array() + 1e-3f;
  edge_ = std::max({1.0f, std::cbrt(box.prod() / 2e6f), box.maxCoeff() / 1e5f});
  // A flat or thin box of another unit has far more of them than its volume says.
  while (((box / edge_).cast<double>().floor() + 1).prod() > 1e7) edge_ *= 1.25f;
  size_ = (box / edge_).floor().cast<int>() + 1;
  start_.assign(static_cast<std::size_t>(size_.prod()) + 1, 0);
  for (const auto& t : mesh.triangles)
    cubesOf(mesh, t, low_, edge_, size_, [&](int c) { ++start_[static_cast<std::size_t>(c) + 1]; });
  for (std::size_t c = 1; c < start_.size(); ++c) start_[c] += start_[c - 1];
  std::vector<int> next(start_.begin(), start_.end() - 1);
  triangles_.resize(static_cast<std::size_t>(start_.back()));
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    cubesOf(mesh, mesh.triangles[i], low_, edge_, size_, [&](int c) {
      triangles_[static_cast<std::size_t>(next[static_cast<std::size_t>(c)]++)] =
          static_cast<int>(i);
    });
}

std::optional<float> RayGrid::meets(int triangle, const Vector3f& start,
                                    const Vector3f& direction) const {
  // Moeller, Trumbore, 1997.
  const auto& t = mesh_.triangles[static_cast<std::size_t>(triangle)];
  const Vector3f a = mesh_.vertices[t[0]], e1 = mesh_.vertices[t[1]] - a,
                 e2 = mesh_.vertices[t[2]] - a;
  const Vector3f p = direction.cross(e2);
  const float det = e1.dot(p);
  if (std::abs(det) < 1e-12f) return std::nullopt;
  const Vector3f s = start - a;
  const float u = s.dot(p) / det;
  const Vector3f q = s.cross(e1);
  const float v = direction.dot(q) / det;
  if (u < -1e-5f || v < -1e-5f || u + v > 1 + 1e-5f) return std::nullopt;
  return e2.dot(q) / det;
}

std::optional<RayHit> RayGrid::leaving(const Vector3f& start, const Vector3f& direction,
                                       int from) const {
  Array3i cube = ((start - low_) / edge_).array().floor().cast<int>().max(0).min(size_ - 1);
  Array3i step;
  Eigen::Array3f next, span;
  for (int k = 0; k < 3; ++k) {
    step[k] = direction[k] > 0 ? 1 : -1;
    const float wall = low_[k] + edge_ * static_cast<float>(cube[k] + (step[k] > 0));
    const bool runs = std::abs(direction[k]) > 1e-12f;
    next[k] = runs ? (wall - start[k]) / direction[k] : INFINITY;
    span[k] = runs ? edge_ / std::abs(direction[k]) : INFINITY;
  }
  while ((cube >= 0).all() && (cube < size_).all()) {
    int axis = 0;
    const float leave = next.minCoeff(&axis);
    const std::size_t c =
        static_cast<std::size_t>((cube[2] * size_[1] + cube[1]) * size_[0] + cube[0]);
    RayHit best{INFINITY, Vector3f::Zero()};
    for (int i = start_[c]; i < start_[c + 1]; ++i) {
      const int triangle = triangles_[static_cast<std::size_t>(i)];
      if (triangle == from) continue;
      const std::optional<float> at = meets(triangle, start, direction);
      // 0.01 mm: the start's own neighbours on a rough surface are no far side.
      if (!at || *at < 0.01f || *at >= best.distance_mm || *at > leave + 1e-4f) continue;
      const auto& t = mesh_.triangles[static_cast<std::size_t>(triangle)];
      const Vector3f across = (mesh_.vertices[t[1]] - mesh_.vertices[t[0]])
                                  .cross(mesh_.vertices[t[2]] - mesh_.vertices[t[0]]);
      if (across.dot(direction) > 0) best = {*at, across.normalized()};
    }
    if (std::isfinite(best.distance_mm)) return best;
    cube[axis] += step[axis];
    next[axis] += span[axis];
  }
  return std::nullopt;
}

}  // namespace ostraka::model
