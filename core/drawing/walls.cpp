#include "drawing/walls.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/median.h"
#include "cloud/nearest.h"
#include "model/model.h"
#include "model/ray_grid.h"

namespace ostraka::drawing {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr int kSmoothings = 4;             // means over neighbours: about 1 mm at edges of 0.5 mm
constexpr double kOppositeCosine = -0.87;  // both faces within 30 degrees of parallel
constexpr float kReach_mm = 4;             // between neighbours on one face
constexpr double kSameFaceCosine = 0.5;

TriangleMesh smoothed(const TriangleMesh& mesh) {
  TriangleMesh out = mesh;
  std::vector<Vector3f> sums(mesh.vertices.size());
  std::vector<int> counts(mesh.vertices.size());
  for (int round = 0; round < kSmoothings; ++round) {
    std::fill(sums.begin(), sums.end(), Vector3f::Zero());
    std::fill(counts.begin(), counts.end(), 0);
    for (const auto& t : out.triangles)
      for (int k = 0; k < 3; ++k) {
        sums[t[k]] += out.vertices[t[(k + 1) % 3]] + out.vertices[t[(k + 2) % 3]];
        counts[t[k]] += 2;
      }
    for (std::size_t i = 0; i < sums.size(); ++i)
      if (counts[i] > 0)
        out.vertices[i] = 0.5f * out.vertices[i] + 0.5f / static_cast<float>(counts[i]) * sums[i];
  }
  out.normals = model::vertexNormals(out);
  return out;
}

void findAxes(Walls& walls) {
  for (const Vector3f& v : walls.smooth.vertices) walls.centre += v.cast<double>();
  walls.centre /= static_cast<double>(walls.smooth.vertices.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Vector3f& v : walls.smooth.vertices) {
    const Vector3d d = v.cast<double>() - walls.centre;
    spread += d * d.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread);
  walls.axes.col(0) = solver.eigenvectors().col(2);
  walls.axes.col(1) = solver.eigenvectors().col(1);
  walls.axes.col(2) = walls.axes.col(0).cross(walls.axes.col(1));
}

// Faces as connected parts of points whose normals agree; the two largest are kept.
void tellFacesApart(std::vector<WallPoint>& points) {
  std::vector<Vector3f> places;
  for (const WallPoint& point : points) places.push_back(point.p.cast<float>());
  const KdTree tree(places);
  std::vector<int> part(points.size(), -1), sizes;
  std::vector<Neighbour> near;
  for (std::size_t seed = 0; seed < points.size(); ++seed) {
    if (part[seed] >= 0) continue;
    const int number = static_cast<int>(sizes.size());
    sizes.push_back(0);
    std::vector<std::size_t> open{seed};
    part[seed] = number;
    while (!open.empty()) {
      const std::size_t at = open.back();
      open.pop_back();
      ++sizes[number];
      tree.within(places[at], kReach_mm, near);
      for (const Neighbour& n : near) {
        const auto other = static_cast<std::size_t>(n.index);
        if (part[other] >= 0 || points[at].normal.dot(points[other].normal) < kSameFaceCosine)
          continue;
        part[other] = number;
        open.push_back(other);
      }
    }
  }
  std::vector<int> order(sizes.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return sizes[a] > sizes[b]; });
  std::vector<WallPoint> kept;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (int face = 0; face < std::min<int>(2, static_cast<int>(order.size())); ++face)
      if (part[i] == order[face]) {
        points[i].face = face;
        kept.push_back(points[i]);
      }
  points = std::move(kept);
}

}  // namespace

Walls findWalls(const TriangleMesh& mesh) {
  Walls walls;
  walls.smooth = smoothed(mesh);
  findAxes(walls);
  const model::RayGrid rays(walls.smooth);
  double due = 0;
  for (std::size_t i = 0; i < walls.smooth.triangles.size(); ++i) {
    const auto& t = walls.smooth.triangles[i];
    const Vector3d a = walls.smooth.vertices[t[0]].cast<double>(),
                   b = walls.smooth.vertices[t[1]].cast<double>(),
                   c = walls.smooth.vertices[t[2]].cast<double>();
    const Vector3d across = (b - a).cross(c - a);
    due += 0.5 * across.norm();
    if (due < 1) continue;
    due = std::fmod(due, 1.0);
    const Vector3d normal = across.normalized(), middle = (a + b + c) / 3;
    const auto hit =
        rays.leaving(middle.cast<float>(), (-normal).cast<float>(), static_cast<int>(i));
    if (hit && hit->normal.cast<double>().dot(normal) < kOppositeCosine)
      walls.points.push_back({middle, normal, hit->distance_mm, 0});
  }
  if (walls.points.empty()) return walls;
  std::vector<double> all;
  for (const WallPoint& point : walls.points) all.push_back(point.thickness_mm);
  walls.thickness_mm = medianOf(all);
  std::erase_if(walls.points, [&](const WallPoint& point) {
    return point.thickness_mm < 0.5 * walls.thickness_mm ||
           point.thickness_mm > 2 * walls.thickness_mm;
  });
  tellFacesApart(walls.points);
  return walls;
}

}  // namespace ostraka::drawing
