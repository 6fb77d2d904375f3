#include "registration/outline.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "cloud/nearest.h"

namespace ostraka::registration {
namespace {

using Eigen::Vector2d;
using Eigen::Vector2f;
using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr double kLargestPicture = 4096;  // cells a side: a metre, far beyond any plate

// Where the picture falls through a half between two neighbouring cells, with its slope there.
void addCrossings(const cv::Mat1f& picture, const Vector2d& origin, double cell, Outline& outline) {
  const auto slope = [&](int x, int y) {
    return Vector2d(picture(y, x + 1) - picture(y, x - 1), picture(y + 1, x) - picture(y - 1, x));
  };
  for (int y = 1; y + 2 < picture.rows; ++y)
    for (int x = 1; x + 2 < picture.cols; ++x) {
      const float here = picture(y, x);
      for (int axis = 0; axis < 2; ++axis) {
        const int nx = x + (axis == 0), ny = y + (axis == 1);
        const float there = picture(ny, nx);
        if ((here >= 0.5f) == (there >= 0.5f)) continue;
        const double t = (0.5 - here) / (there - here);
        const Vector2d g = (1 - t) * slope(x, y) + t * slope(nx, ny);
        if (std::abs(g[axis]) < std::abs(g[1 - axis])) continue;  // the other axis cuts it better
        outline.points.push_back(origin + cell * Vector2d(x + (axis == 0) * t, y + (axis == 1) * t));
        outline.normals.push_back(-g.normalized());
      }
    }
}

}  // namespace

Outline outlineOf(std::span<const Vector2f> plan, double spacing_mm,
                  const OutlineOptions& options) {
  Outline outline;
  if (plan.size() < 10) return outline;
  Vector2f low = plan[0], high = plan[0];
  for (const Vector2f& p : plan) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double margin = 4 * options.blur_mm + 2 * spacing_mm;
  const Vector2d origin = low.cast<double>().array() - margin;
  const Vector2d size = ((high.cast<double>() - origin).array() + margin) / options.cell_mm;
  if (!(size.maxCoeff() < kLargestPicture)) return outline;
  cv::Mat1b covered(static_cast<int>(size.y()) + 2, static_cast<int>(size.x()) + 2, uchar{0});
  for (const Vector2f& p : plan) {
    const Vector2d c = (p.cast<double>() - origin) / options.cell_mm;
    covered(static_cast<int>(std::lround(c.y())), static_cast<int>(std::lround(c.x()))) = 255;
  }
  const int reach = std::max(1, static_cast<int>(std::ceil(1.2 * spacing_mm / options.cell_mm)));
  const cv::Mat disc =
      cv::getStructuringElement(cv::MORPH_ELLIPSE, cv::Size(2 * reach + 1, 2 * reach + 1));
  cv::morphologyEx(covered, covered, cv::MORPH_CLOSE, disc);
  cv::morphologyEx(covered, covered, cv::MORPH_OPEN, disc);
  cv::Mat1f picture;
  covered.convertTo(picture, CV_32F, 1.0 / 255);
  const double blur = options.blur_mm / options.cell_mm;
  cv::GaussianBlur(picture, picture, cv::Size(0, 0), blur);
  addCrossings(picture, origin, options.cell_mm, outline);
  return outline;
}

OutlineFit fitOutlines(std::span<const Vector3f> front, std::span<const Vector3f> back,
                       double spacing_mm, const Eigen::Isometry3d& front_from_back,
                       const Vector3d& up, const Vector3d& pivot, const OutlineOptions& options) {
  const Vector3d side = up.unitOrthogonal(), across = up.cross(side);
  Eigen::Matrix<float, 2, 3> flat;
  flat << side.transpose().cast<float>(), across.transpose().cast<float>();
  std::vector<Vector2f> front_plan, back_plan;
  for (const Vector3f& p : front) front_plan.push_back(flat * p);
  const Eigen::Matrix<float, 2, 3> turn = flat * front_from_back.linear().cast<float>();
  const Vector2f shift = flat * front_from_back.translation().cast<float>();
  for (const Vector3f& p : back) back_plan.push_back(turn * p + shift);
  const Outline f = outlineOf(front_plan, spacing_mm, options);
  const Outline b = outlineOf(back_plan, spacing_mm, options);
  std::vector<Vector3f> targets;
  for (const Vector2d& p : f.points)
    targets.emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()), 0.0f);
  const KdTree tree(targets);
  struct Match {
    double residual;
    Vector6 row;
  };
  std::vector<Match> matches;
  std::vector<double> sizes;
  for (std::size_t i = 0; i < b.points.size(); ++i) {
    const Vector2d& q = b.points[i];
    const Neighbour near = tree.nearest(
        Vector3f(static_cast<float>(q.x()), static_cast<float>(q.y()), 0.0f),
        static_cast<float>(options.reach_mm));
    if (near.index < 0 || f.normals[near.index].dot(b.normals[i]) < 0.7071) continue;
    const Vector2d n2 = (f.normals[near.index] + b.normals[i]).normalized();
    const Vector3d n = n2.x() * side + n2.y() * across;
    const Vector3d at = q.x() * side + q.y() * across + up.dot(pivot) * up;
    matches.push_back({n2.dot(q - f.points[near.index]), rowOf(at, n, pivot)});
    sizes.push_back(matches.back().residual);
  }
  OutlineFit fit;
  fit.pairs = static_cast<int>(matches.size());
  if (fit.pairs < 20) return fit;
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  const double median = *middle;  // uneven fatness or slanted walls: alike all around
  for (double& s : sizes) s = std::abs(s - median);
  std::nth_element(sizes.begin(), middle, sizes.end());
  fit.sigma_mm = std::max(0.05, 1.4826 * *middle);
  // An outline has about one crossing per cell.
  const double independent = std::min(1.0, options.cell_mm / options.correlation_mm);
  for (const Match& m : matches) {
    const double u = (m.residual - median) / (4 * fit.sigma_mm);
    if (u * u >= 1) continue;
    const double w = (1 - u * u) * (1 - u * u) * independent;
    fit.evidence.add((m.residual - median) / fit.sigma_mm, m.row / fit.sigma_mm, w);
  }
  return fit;
}

}  // namespace ostraka::registration
