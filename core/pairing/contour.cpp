#include "pairing/contour.h"

#include <algorithm>
#include <cmath>

#include "base/message.h"
#include "cloud/nearest.h"
#include "pairing/alpha_outline.h"

namespace ostraka::pairing {
namespace {

constexpr double kAlpha_mm = 1.0;  // radius of the disc that rolls around the outside
// At least so many point spacings, or the disc falls through the cloud.
constexpr double kAlphaSpacings = 3.0;
constexpr double kSmoothing_mm = 0.4;     // along the line: the points' spacing, below break relief
constexpr double kContourStep_mm = 0.25;  // of the resampled line

double perimeter(std::span<const Eigen::Vector2d> p) {
  double sum = 0;
  for (std::size_t i = 0; i < p.size(); ++i) sum += (p[(i + 1) % p.size()] - p[i]).norm();
  return sum;
}

/// A frame whose z is the axis; x is the coordinate axis least along it, so that it is stable.
Eigen::Isometry3d planeFromScan(const Eigen::Vector3d& axis, const Eigen::Vector3d& centre) {
  Eigen::Index least = 0;
  axis.cwiseAbs().minCoeff(&least);
  const Eigen::Vector3d z = axis.normalized();
  const Eigen::Vector3d x = (Eigen::Vector3d::Unit(least) - z * z(least)).normalized();
  Eigen::Isometry3d plane = Eigen::Isometry3d::Identity();
  plane.linear().row(0) = x.transpose();
  plane.linear().row(1) = z.cross(x).transpose();
  plane.linear().row(2) = z.transpose();
  plane.translation() = -(plane.linear() * centre);
  return plane;
}

/// Points that have company: a flying point has none within three spacings, a corner some.
std::vector<int> withoutFlyers(const PointCloud& cloud, double spacing_mm) {
  constexpr int kCompany = 4;  // itself and three; a corner of a sheet at this radius has about 7
  const KdTree tree(cloud.points);
  const float radius = static_cast<float>(3 * spacing_mm);
  std::vector<int> kept;
  std::vector<Neighbour> near;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    tree.nearest(cloud.points[i], kCompany, near);
    const bool company = near.size() == static_cast<std::size_t>(kCompany) &&
                         near.back().squared_distance <= radius * radius;
    if (company) kept.push_back(static_cast<int>(i));
  }
  return kept;
}

/// Gaussian along a closed line of equal steps.
std::vector<Eigen::Vector2d> smoothed(const std::vector<Eigen::Vector2d>& line,
                                      double sigma_steps) {
  const int reach = std::min<int>(static_cast<int>(std::ceil(3 * sigma_steps)),
                                  static_cast<int>(line.size()) / 2);
  std::vector<double> weights(static_cast<std::size_t>(reach) + 1);
  for (int k = 0; k <= reach; ++k) {
    weights[static_cast<std::size_t>(k)] = std::exp(-0.5 * k * k / (sigma_steps * sigma_steps));
  }
  const int n = static_cast<int>(line.size());
  std::vector<Eigen::Vector2d> out(line.size());
  for (int i = 0; i < n; ++i) {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    double total = 0;
    for (int k = -reach; k <= reach; ++k) {
      const double w = weights[static_cast<std::size_t>(std::abs(k))];
      sum += w * line[static_cast<std::size_t>((i + k + n) % n)];
      total += w;
    }
    out[static_cast<std::size_t>(i)] = sum / total;
  }
  return out;
}

/// Mean height of the surface within half a millimetre of each contour point, seen along the axis.
std::vector<double> heightsAt(const std::vector<Eigen::Vector2d>& line,
                              const std::vector<Eigen::Vector3d>& points, double reach_mm) {
  std::vector<Eigen::Vector3f> flat(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    flat[i] =
        Eigen::Vector3f(static_cast<float>(points[i].x()), static_cast<float>(points[i].y()), 0);
  }
  const KdTree tree(flat);
  std::vector<double> heights(line.size());
  std::vector<Neighbour> near;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const Eigen::Vector3f q(static_cast<float>(line[i].x()), static_cast<float>(line[i].y()), 0);
    tree.within(q, static_cast<float>(reach_mm), near);
    if (near.empty()) near.push_back(tree.nearest(q));
    double low = 1e30, high = -1e30;
    for (const Neighbour& n : near) {
      low = std::min(low, points[static_cast<std::size_t>(n.index)].z());
      high = std::max(high, points[static_cast<std::size_t>(n.index)].z());
    }
    heights[i] = (low + high) / 2;
  }
  return heights;
}

}  // namespace

double signedArea(std::span<const Eigen::Vector2d> closed) {
  double twice = 0;
  for (std::size_t i = 0; i < closed.size(); ++i) {
    const Eigen::Vector2d &p = closed[i], &q = closed[(i + 1) % closed.size()];
    twice += p.x() * q.y() - p.y() * q.x();
  }
  return twice / 2;
}

std::vector<Eigen::Vector2d> resampled(std::span<const Eigen::Vector2d> closed, int n) {
  const std::size_t count = closed.size();
  const double step = perimeter(closed) / n;
  std::vector<Eigen::Vector2d> out;
  out.reserve(static_cast<std::size_t>(n));
  std::size_t segment = 0;
  double begin = 0, length = (closed[1 % count] - closed[0]).norm();
  for (int i = 0; i < n; ++i) {
    const double at = step * i;
    while (begin + length < at && segment + 1 < count) {
      begin += length;
      ++segment;
      length = (closed[(segment + 1) % count] - closed[segment]).norm();
    }
    const double share = length > 0 ? std::clamp((at - begin) / length, 0.0, 1.0) : 0.0;
    out.push_back(closed[segment] + share * (closed[(segment + 1) % count] - closed[segment]));
  }
  return out;
}

std::vector<Eigen::Vector2d> mirrored(std::span<const Eigen::Vector2d> closed) {
  std::vector<Eigen::Vector2d> out;
  out.reserve(closed.size());
  for (auto p = closed.rbegin(); p != closed.rend(); ++p) out.emplace_back(-p->x(), p->y());
  return out;
}

Result<Contour> traceContour(const PointCloud& cloud, const Eigen::Vector3d& axis) {
  if (cloud.size() < 20) {
    return Error::notEnough(message("A scan of fewer than 20 points has no outline."));
  }
  const double spacing = std::max(1e-3, medianSpacing(cloud));
  const std::vector<int> kept = withoutFlyers(cloud, spacing);
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  for (const int i : kept) centre += cloud.points[static_cast<std::size_t>(i)].cast<double>();
  centre /= static_cast<double>(std::max<std::size_t>(1, kept.size()));
  Contour contour;
  contour.plane_from_scan = planeFromScan(axis, centre);
  std::vector<Eigen::Vector3d> points;
  std::vector<Eigen::Vector2d> flat;
  for (const int i : kept) {
    points.push_back(contour.plane_from_scan *
                     cloud.points[static_cast<std::size_t>(i)].cast<double>());
    flat.push_back(points.back().head<2>());
  }
  const double alpha = std::max(kAlpha_mm, kAlphaSpacings * spacing);
  const Result<std::vector<int>> outline = alphaOutline(flat, alpha);
  if (!outline) return outline.error();
  std::vector<Eigen::Vector2d> line;
  for (const int i : *outline) line.push_back(flat[static_cast<std::size_t>(i)]);
  const int n = std::max(16, static_cast<int>(perimeter(line) / kContourStep_mm));
  line = resampled(line, n);
  line = smoothed(line, kSmoothing_mm * n / perimeter(line));
  line = resampled(line, n);
  contour.points = std::move(line);
  contour.perimeter_mm = perimeter(contour.points);
  contour.area_mm2 = signedArea(contour.points);
  if (contour.area_mm2 <= 0) {
    return Error::notEnough(message("The scan's outline is not closed."));
  }
  contour.heights = heightsAt(contour.points, points, std::max(0.5, 1.5 * spacing));
  return contour;
}

}  // namespace ostraka::pairing
