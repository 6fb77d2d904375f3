#include "drawing/rim_arc.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/median.h"
#include "cloud/nearest.h"

namespace ostraka::drawing {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// Lips of even vessels keep to a circle far better than breaks do; those of uneven ones need more
// room, in which a stretch of break may hide: all are tried.
constexpr double kSmooth_mm[] = {0.12, 0.2, 0.3};
constexpr double kStep_mm = 1.2;
constexpr double kShortest_mm = 12;
constexpr std::size_t kFewestPoints = 12;
constexpr double kSmallest_mm = 10;  // radius of a mouth
constexpr std::size_t kMostArcs = 3;
constexpr float kFaceReach_mm = 1.2f;  // wall points lie a millimetre apart
constexpr float kFaceCosine = 0.85f;
constexpr double kMostAlong = 0.75;  // of the circle's normal along the wall's: a lip flares less

// The strip between the faces of the wall: lip and breaks.
std::vector<std::size_t> stripOf(const Walls& walls) {
  std::vector<Eigen::Vector3f> faces;
  for (const WallPoint& point : walls.points) faces.push_back(point.p.cast<float>());
  const KdTree tree(faces);
  std::vector<std::size_t> strip;
  for (std::size_t i = 0; i < walls.smooth.vertices.size(); ++i) {
    const Neighbour n = tree.nearest(walls.smooth.vertices[i], kFaceReach_mm);
    const bool on_face = n.index >= 0 && walls.points[n.index].normal.cast<float>().dot(
                                             walls.smooth.normals[i]) > kFaceCosine;
    if (!on_face) strip.push_back(i);
  }
  return strip;
}

// The strip's middle in all directions of the sherd's own plane, kStep_mm apart at the mean
// distance: wider than the mesh's edges, so that each direction meets the strip.
std::vector<Vector3d> edgeOf(const Walls& walls) {
  const std::vector<std::size_t> strip = stripOf(walls);
  std::vector<Vector2d> places;
  double mean = 0;
  for (const std::size_t i : strip) {
    const Vector3d d = walls.smooth.vertices[i].cast<double>() - walls.centre;
    places.emplace_back(d.dot(walls.axes.col(0)), d.dot(walls.axes.col(1)));
    mean += places.back().norm() / static_cast<double>(strip.size());
  }
  const int directions = std::max(24, static_cast<int>(2 * std::numbers::pi * mean / kStep_mm));
  std::vector<Vector3d> sums(static_cast<std::size_t>(directions), Vector3d::Zero());
  std::vector<int> counts(sums.size(), 0);
  std::vector<double> farthest(sums.size(), 0);
  const auto bin = [&](const Vector2d& p) {
    const double turn = std::atan2(p.y(), p.x()) / (2 * std::numbers::pi) + 0.5;
    return std::min(directions - 1, static_cast<int>(turn * directions));
  };
  for (const Vector2d& p : places) farthest[bin(p)] = std::max(farthest[bin(p)], p.norm());
  for (std::size_t k = 0; k < strip.size(); ++k) {
    const int b = bin(places[k]);
    // A hole or a knob within the sherd is no edge.
    if (places[k].norm() < farthest[b] - 2 * walls.thickness_mm) continue;
    sums[b] += walls.smooth.vertices[strip[k]].cast<double>();
    ++counts[b];
  }
  std::vector<Vector3d> edge;
  for (std::size_t b = 0; b < sums.size(); ++b)
    if (counts[b] > 0) edge.push_back(sums[b] / counts[b]);
  return edge;
}

struct Circle {
  Vector3d centre, normal;
  double radius = 0, rms = 1e9;
};

// Plane by least squares, circle in it by the algebraic fit.
Circle fitCircle(const std::vector<Vector3d>& edge, std::size_t start, std::size_t count) {
  const auto point = [&](std::size_t k) -> const Vector3d& {
    return edge[(start + k) % edge.size()];
  };
  Vector3d mean = Vector3d::Zero();
  for (std::size_t k = 0; k < count; ++k) mean += point(k);
  mean /= static_cast<double>(count);
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (std::size_t k = 0; k < count; ++k) {
    const Vector3d d = point(k) - mean;
    spread += d * d.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread);
  const Vector3d u = solver.eigenvectors().col(2), v = solver.eigenvectors().col(1);
  Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
  Vector3d b = Vector3d::Zero();
  for (std::size_t k = 0; k < count; ++k) {
    const Vector3d d = point(k) - mean;
    const Vector3d row(d.dot(u), d.dot(v), 1);
    a += row * row.transpose();
    b -= row * d.squaredNorm();
  }
  const Vector3d s = a.ldlt().solve(b);
  const Vector2d centre(-s.x() / 2, -s.y() / 2);
  Circle circle;
  circle.radius = std::sqrt(std::max(0.0, centre.squaredNorm() - s.z()));
  circle.centre = mean + centre.x() * u + centre.y() * v;
  circle.normal = solver.eigenvectors().col(0);
  double sum = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const Vector3d d = point(k) - circle.centre;
    const double across = d.dot(circle.normal);
    const double off = (d - across * circle.normal).norm() - circle.radius;
    sum += across * across + off * off;
  }
  circle.rms = std::sqrt(sum / static_cast<double>(count));
  return circle;
}

double medianElsewhere(const std::vector<Vector3d>& edge, std::size_t start, std::size_t count) {
  std::vector<double> found;
  const std::size_t n = edge.size(), rest = n - count;
  const std::size_t length = std::min(count, rest);
  if (length < 6) return 0;
  for (std::size_t k = 0; k + length <= rest; k += 3)
    found.push_back(fitCircle(edge, start + count + k, length).rms);
  return medianOf(found);
}

struct Stretch {
  std::size_t start = 0, count = 0;
  Circle circle;
};

// The longest stretch of points not taken that keeps to a circle standing across the sherd.
Stretch longestStretch(const std::vector<Vector3d>& edge, const std::vector<char>& taken,
                       const Vector3d& across_wall, double smooth_mm) {
  Stretch best;
  const std::size_t n = edge.size();
  for (std::size_t start = 0; start < n; start += 2) {
    std::size_t open = 0;
    while (open < n && !taken[(start + open) % n]) ++open;
    for (std::size_t count = std::max(kFewestPoints, best.count + 2);
         count <= std::min(open, 3 * n / 4); count += 2) {
      const Circle circle = fitCircle(edge, start, count);
      // A longer stretch from here only scatters more.
      if (circle.rms > 2 * smooth_mm) break;
      if (circle.rms > smooth_mm || circle.radius < kSmallest_mm) continue;
      if (std::abs(circle.normal.dot(across_wall)) > kMostAlong) continue;
      best = {start, count, circle};
    }
  }
  return best;
}

}  // namespace

std::vector<RimArc> findRimArcs(const Walls& walls) {
  const std::vector<Vector3d> edge = edgeOf(walls);
  std::vector<RimArc> arcs;
  if (edge.size() < 2 * static_cast<std::size_t>(kShortest_mm)) return arcs;
  for (const double smooth_mm : kSmooth_mm) {
    std::vector<char> taken(edge.size(), 0);
    for (std::size_t number = 0; number < kMostArcs; ++number) {
      const Stretch best = longestStretch(edge, taken, walls.axes.col(2), smooth_mm);
      if (best.count == 0) break;
      RimArc arc;
      for (std::size_t k = 0; k < best.count; ++k) {
        const std::size_t at = (best.start + k) % edge.size();
        arc.points.push_back(edge[at]);
        taken[at] = 1;
        if (k > 0) arc.length_mm += (arc.points[k] - arc.points[k - 1]).norm();
      }
      if (arc.length_mm < kShortest_mm) break;
      arc.edge = edge;
      arc.start = best.start;
      arc.rms_mm = best.circle.rms;
      arc.radius_mm = best.circle.radius;
      arc.elsewhere_mm = medianElsewhere(edge, best.start, best.count);
      arcs.push_back(std::move(arc));
    }
  }
  return arcs;
}

}  // namespace ostraka::drawing
