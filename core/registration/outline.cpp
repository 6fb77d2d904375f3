#include "registration/outline.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "base/median.h"
#include "cloud/bounds.h"
#include "cloud/nearest.h"

namespace ostraka::registration {
namespace {

using Eigen::Vector2d;
using Eigen::Vector2f;
using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr double kLargestPicture = 4096;  // cells a side: a metre, far beyond any plate
// Cells in scan spacings: at 1.3 a face fills nine cells of ten and the sparse skirts that stereo
// hangs on hidden walls fill few, so half coverage cuts them off.
constexpr double kCellSpacings = 1.3, kMinCell_mm = 0.25;
constexpr double kBlur_mm = 0.6;          // one to two scan spacings: single points do not shape it
constexpr double kOutlineReach_mm = 2.0;  // outlines farther apart show different things
constexpr double kBump_mm = 4.0;          // bumps of a break are this long; neighbours err together
// Where a break leans, one side sees its outermost part and the other ends before it.
constexpr double kMinSigma_mm = 0.15;

std::vector<Vector2f> planOf(std::span<const Vector3f> points,
                             const Eigen::Matrix<float, 2, 3>& flat, const Vector2f& shift) {
  std::vector<Vector2f> plan;
  plan.reserve(points.size());
  for (const Vector3f& p : points) plan.push_back(flat * p + shift);
  return plan;
}

}  // namespace

double Coverage::at(const Vector2d& p) const {
  const Vector2d c = (p - origin) / cell;
  const int x = static_cast<int>(std::floor(c.x())), y = static_cast<int>(std::floor(c.y()));
  if (x < 0 || y < 0 || x + 1 >= picture.cols || y + 1 >= picture.rows) return 0;
  const double u = c.x() - x, v = c.y() - y;
  return (1 - v) * ((1 - u) * picture(y, x) + u * picture(y, x + 1)) +
         v * ((1 - u) * picture(y + 1, x) + u * picture(y + 1, x + 1));
}

Coverage coverageOf(std::span<const Vector2f> points, double cell, double blur) {
  Coverage coverage;
  coverage.cell = cell;
  if (points.size() < 10) return coverage;
  const auto [low, high] = boundsOf(points);
  const double margin = 4 * blur + 2 * cell;
  coverage.origin = low.cast<double>().array() - margin;
  const Vector2d size = ((high.cast<double>() - coverage.origin).array() + margin) / cell;
  if (!(size.maxCoeff() < kLargestPicture)) return coverage;
  coverage.picture =
      cv::Mat1f(static_cast<int>(size.y()) + 2, static_cast<int>(size.x()) + 2, 0.0f);
  for (const Vector2f& p : points) {
    const Vector2d c = (p.cast<double>() - coverage.origin) / cell;
    coverage.picture(static_cast<int>(std::lround(c.y())), static_cast<int>(std::lround(c.x()))) =
        1.0f;
  }
  cv::GaussianBlur(coverage.picture, coverage.picture, cv::Size(0, 0), blur / cell);
  return coverage;
}

Outline outlineOf(const Coverage& coverage) {
  Outline outline;
  const cv::Mat1f& picture = coverage.picture;
  const auto slope = [&](int x, int y) {
    return Vector2d(picture(y, x + 1) - picture(y, x - 1), picture(y + 1, x) - picture(y - 1, x));
  };
  for (int y = 1; y + 2 < picture.rows; ++y)
    for (int x = 1; x + 2 < picture.cols; ++x)
      for (int axis = 0; axis < 2; ++axis) {
        const int nx = x + (axis == 0), ny = y + (axis == 1);
        const float here = picture(y, x), there = picture(ny, nx);
        if ((here >= 0.5f) == (there >= 0.5f)) continue;
        const double t = (0.5 - here) / (there - here);
        const Vector2d g = (1 - t) * slope(x, y) + t * slope(nx, ny);
        if (std::abs(g[axis]) < std::abs(g[1 - axis])) continue;  // the other axis cuts it better
        outline.points.push_back(
            coverage.origin + coverage.cell * Vector2d(x + (axis == 0) * t, y + (axis == 1) * t));
        outline.normals.push_back(-g.normalized());
      }
  return outline;
}

OutlineFit weigh(std::span<const OutlineMatch> matches, double min_sigma, double independent) {
  OutlineFit fit;
  fit.pairs = static_cast<int>(matches.size());
  if (fit.pairs < 20) return fit;
  std::vector<double> sizes;
  for (const OutlineMatch& m : matches) sizes.push_back(m.residual);
  const double median = medianOf(sizes);
  for (double& s : sizes) s = std::abs(s - median);
  fit.sigma_mm = std::max(min_sigma, 1.4826 * medianOf(sizes));
  for (const OutlineMatch& m : matches) {
    const double u = (m.residual - median) / (4 * fit.sigma_mm), free = 1 - u * u;
    if (free <= 0) continue;
    fit.evidence.add((m.residual - median) / fit.sigma_mm, m.row / fit.sigma_mm,
                     free * free * independent);
  }
  return fit;
}

OutlineFit fitOutlines(std::span<const Vector3f> front, std::span<const Vector3f> back,
                       double spacing_mm, const Eigen::Isometry3d& front_from_back,
                       const Vector3d& up, const Vector3d& pivot) {
  const Vector3d side = up.unitOrthogonal(), across = up.cross(side);
  Eigen::Matrix<float, 2, 3> flat;
  flat << side.transpose().cast<float>(), across.transpose().cast<float>();
  const Eigen::Matrix<float, 2, 3> flat_back = flat * front_from_back.linear().cast<float>();
  const Vector2f shift = flat * front_from_back.translation().cast<float>();
  const double cell = std::max(kMinCell_mm, kCellSpacings * spacing_mm);
  const Outline f = outlineOf(coverageOf(planOf(front, flat, Vector2f::Zero()), cell, kBlur_mm));
  const Outline b = outlineOf(coverageOf(planOf(back, flat_back, shift), cell, kBlur_mm));
  std::vector<Vector3f> targets;
  for (const Vector2d& p : f.points)
    targets.emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()), 0.0f);
  const KdTree tree(targets);
  std::vector<OutlineMatch> matches;
  for (std::size_t i = 0; i < b.points.size(); ++i) {
    const Vector2d& q = b.points[i];
    const Neighbour near =
        tree.nearest(Vector3f(static_cast<float>(q.x()), static_cast<float>(q.y()), 0.0f),
                     static_cast<float>(kOutlineReach_mm));
    if (near.index < 0) continue;
    const auto k = static_cast<std::size_t>(near.index);
    if (f.normals[k].dot(b.normals[i]) < 0.7071) continue;
    const Vector2d n2 = (f.normals[k] + b.normals[i]).normalized();
    const Vector3d n = n2.x() * side + n2.y() * across;
    const Vector3d at = q.x() * side + q.y() * across + up.dot(pivot) * up;
    matches.push_back({n2.dot(q - f.points[k]), rowOf(at, n, pivot)});
  }
  return weigh(matches, kMinSigma_mm, std::min(1.0, cell / kBump_mm));
}

}  // namespace ostraka::registration
