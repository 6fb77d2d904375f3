#include "stereo/surface.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "base/median.h"
#include "base/parallel.h"
#include "cloud/nearest.h"
#include "stereo/hull.h"

namespace ostraka::stereo {
namespace {

constexpr std::size_t kBlock = 2000;  // points per task
constexpr std::size_t kSlantTask = 1000;
constexpr std::size_t kTellers = 5;  // one point of so many tells its neighbourhood
constexpr float kLargest_px = 0.5F;  // factor, in pixels' widths: more is no relief
constexpr float kDoubt = 0.05F;      // share by which the factor is drawn towards 0

/// Whether the four pixels around the point's place hold nothing of the object: half a pixel and
/// more outside the mask's edge.
bool outsideMask(const Frame& frame, const Eigen::Vector3f& p_plate) {
  const Eigen::Vector3f p = frame.toCamera(p_plate);
  if (p.z() <= 0) return false;
  const Eigen::Vector2f pixel = frame.project(p);
  if (!frame.shows(pixel)) return false;
  const int x = static_cast<int>(pixel.x()), y = static_cast<int>(pixel.y());
  const cv::Mat1f& c = frame.coverage;
  return c(y, x) + c(y, x + 1) + c(y + 1, x) + c(y + 1, x + 1) < 0.02F;
}

/// Indices of the most trusted point of each cube, in the order of the points.
std::vector<int> onePerCube(const std::vector<SurfacePoint>& points, float spacing_px) {
  std::vector<float> footprints;
  for (const SurfacePoint& p : points) footprints.push_back(p.footprint_mm);
  const float edge_mm = spacing_px * medianOf(footprints);
  std::unordered_map<std::uint64_t, int> best;
  best.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Array3i cube = (points[i].position / edge_mm).array().floor().cast<int>();
    std::uint64_t key = 0;
    for (int axis = 0; axis < 3; ++axis)
      key = key << 21U | (static_cast<std::uint64_t>(cube[axis] + (1 << 20)) & 0x1fffffU);
    const auto [place, is_new] = best.emplace(key, static_cast<int>(i));
    if (!is_new &&
        points[static_cast<std::size_t>(place->second)].confidence < points[i].confidence)
      place->second = static_cast<int>(i);
  }
  std::vector<int> kept;
  for (const auto& [key, index] : best) kept.push_back(index);
  std::sort(kept.begin(), kept.end());
  return kept;
}

using Row6 = Eigen::Matrix<float, 6, 1>;

/// Fits height = a + b u + c v + d u^2 + e u v + f v^2 over the tangent plane at p.
SurfacePoint fitted(const SurfacePoint& p, const std::vector<SurfacePoint>& points,
                    const std::vector<Neighbour>& near, float radius_mm) {
  const Eigen::Vector3f n = p.normal;
  const Eigen::Vector3f u = n.unitOrthogonal(), v = n.cross(u);
  Eigen::Matrix<float, 6, 6> a = Eigen::Matrix<float, 6, 6>::Zero();
  Row6 b = Row6::Zero();
  Eigen::Vector3f mean_normal = Eigen::Vector3f::Zero();
  float weights = 0;
  const float inverse = 1.0F / radius_mm;
  for (const Neighbour& near_point : near) {
    const SurfacePoint& q = points[static_cast<std::size_t>(near_point.index)];
    const float like = q.normal.dot(n);
    if (like < 0.3F) continue;  // another face: the far side of a crease
    const Eigen::Vector3f d = (q.position - p.position) * inverse;
    const float w = q.confidence * like * like * std::exp(-3.0F * d.squaredNorm());
    const float x = d.dot(u), y = d.dot(v);
    const Row6 row = (Row6() << 1, x, y, x * x, x * y, y * y).finished();
    a.noalias() += w * row * row.transpose();
    b += w * d.dot(n) * row;
    mean_normal += w * q.normal;
    weights += w;
  }
  SurfacePoint result = p;
  if (weights <= 0) return result;
  mean_normal.normalize();
  // The normals found by comparing windows stand in as slopes with the weight of a few points, and
  // a light curb on the curvature keeps half-empty neighbourhoods tame.
  const float slope = 0.15F * weights;
  const Eigen::Vector2f wanted(-mean_normal.dot(u), -mean_normal.dot(v));
  const float steep = std::max(0.3F, mean_normal.dot(n));
  a(1, 1) += slope;
  a(2, 2) += slope;
  b(1) += slope * wanted.x() / steep;
  b(2) += slope * wanted.y() / steep;
  for (int k = 3; k < 6; ++k) a(k, k) += 0.05F * weights;
  a(0, 0) += 1e-4F * weights;
  const Row6 f = a.ldlt().solve(b);
  if (!f.allFinite()) return result;
  const float limit = 0.4F;  // of the radius; more is not smoothing but another surface
  result.position = p.position + n * (radius_mm * std::clamp(f(0), -limit, limit));
  result.normal = (n - f(1) * u - f(2) * v).normalized();
  return result;
}

}  // namespace

std::vector<SurfacePoint> insideMasks(std::span<const Frame* const> frames,
                                      const std::vector<SurfacePoint>& points,
                                      const SurfaceOptions& options) {
  std::vector<std::uint8_t> keep(points.size(), 0);
  const int most_outside = masksThatMayErr(frames.size());
  parallelForRanges(points.size(), kBlock, options.threads,
                    [&](std::size_t begin, std::size_t end) {
                      for (std::size_t i = begin; i < end; ++i) {
                        int outside = 0;
                        for (const Frame* frame : frames)
                          outside += outsideMask(*frame, points[i].position) ? 1 : 0;
                        keep[i] = outside <= most_outside ? 1 : 0;
                      }
                    });
  std::vector<SurfacePoint> kept;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (keep[i] != 0) kept.push_back(points[i]);
  return kept;
}

std::vector<SurfacePoint> smoothed(const std::vector<SurfacePoint>& points,
                                   const SurfaceOptions& options) {
  if (points.empty()) return {};
  std::vector<Eigen::Vector3f> positions;
  positions.reserve(points.size());
  for (const SurfacePoint& p : points) positions.push_back(p.position);
  const KdTree tree(positions);
  const std::vector<int> kept = onePerCube(points, options.spacing_px);
  std::vector<SurfacePoint> result(kept.size());
  parallelForRanges(kept.size(), kBlock, options.threads, [&](std::size_t begin, std::size_t end) {
    std::vector<Neighbour> near;
    for (std::size_t i = begin; i < end; ++i) {
      const SurfacePoint& p = points[static_cast<std::size_t>(kept[i])];
      const float radius_mm = options.radius_px * p.footprint_mm;
      tree.within(p.position, radius_mm, near);
      result[i] = fitted(p, points, near, radius_mm);
    }
  });
  return result;
}

std::vector<SurfacePoint> withoutSlant(std::vector<SurfacePoint> points,
                                       const SlantOptions& options) {
  std::vector<Eigen::Vector3f> places;
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < points.size(); i += kTellers)
    if (points[i].slant.variance > 0) {
      places.push_back(points[i].position);
      chosen.push_back(i);
    }
  if (places.empty()) return points;
  const KdTree tree(places);
  const float reach_mm = neighbourhood_mm(points, options.reach_mm);
  std::vector<float> moves(points.size(), 0.0F);  // the points stay until all are known
  parallelForRanges(
      points.size(), kSlantTask, options.threads, [&](std::size_t begin, std::size_t end) {
        std::vector<Neighbour> near;
        for (std::size_t i = begin; i < end; ++i) {
          const SurfacePoint& point = points[i];
          tree.within(point.position, reach_mm, near);
          float covariance = 0, variance = 0;
          for (const Neighbour& n : near) {
            const SurfacePoint& other = points[chosen[static_cast<std::size_t>(n.index)]];
            const float like = other.normal.dot(point.normal);
            if (like < 0.5F) continue;  // another face
            const float weight = like * like * like * like;
            covariance += weight * other.slant.covariance;
            variance += weight * other.slant.variance;
          }
          if (variance <= 0) continue;
          const float largest = kLargest_px * point.footprint_mm;
          const float factor = covariance / (variance * (1 + kDoubt));
          moves[i] = -std::clamp(factor, -largest, largest) * point.slant.mean;
        }
      });
  for (std::size_t i = 0; i < points.size(); ++i) points[i].position += moves[i] * points[i].normal;
  return points;
}

}  // namespace ostraka::stereo
