#include "drawing/revolution.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace ostraka::drawing {
namespace {

using Eigen::Vector2d;
using Eigen::Vector4d;

constexpr double kHuber_mm = 0.3;

double loss(double r) {
  const double a = std::abs(r);
  return a <= kHuber_mm ? r * r : kHuber_mm * (2 * a - kHuber_mm);
}

// Offsets of (along, off) pairs from a piecewise linear function with knots at equal steps:
// weighted least squares, tridiagonal normal equations.
std::vector<double> offsets(const std::vector<Vector2d>& points, const std::vector<double>& weights,
                            double knot) {
  double low = 1e18, high = -1e18;
  for (const Vector2d& p : points) {
    low = std::min(low, p.x());
    high = std::max(high, p.x());
  }
  const int pieces = std::max(1, static_cast<int>(std::ceil((high - low) / knot)));
  const double step = std::max(1e-9, (high - low) / pieces);
  const auto n = static_cast<std::size_t>(pieces) + 1;
  // A stiffness far below the data's weight ties knots without points to their neighbours.
  constexpr double kStiff = 1e-3;
  std::vector<double> diagonal(n, 1e-12), above(n, 0), right(n, 0);
  for (std::size_t k = 0; k + 1 < n; ++k) {
    diagonal[k] += kStiff;
    diagonal[k + 1] += kStiff;
    above[k] -= kStiff;
  }
  const auto place = [&](double x, std::size_t& k, double& t) {
    const double s = std::clamp((x - low) / step, 0.0, pieces - 1e-9);
    k = static_cast<std::size_t>(s);
    t = s - static_cast<double>(k);
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::size_t k = 0;
    double t = 0;
    place(points[i].x(), k, t);
    const double w = weights[i], y = points[i].y();
    diagonal[k] += w * (1 - t) * (1 - t);
    diagonal[k + 1] += w * t * t;
    above[k] += w * t * (1 - t);
    right[k] += w * (1 - t) * y;
    right[k + 1] += w * t * y;
  }
  for (std::size_t k = 1; k < n; ++k) {
    const double f = above[k - 1] / diagonal[k - 1];
    diagonal[k] -= f * above[k - 1];
    right[k] -= f * right[k - 1];
  }
  for (std::size_t k = n; k-- > 0;)
    right[k] = (right[k] - (k + 1 < n ? above[k] * right[k + 1] : 0)) / diagonal[k];
  std::vector<double> off(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::size_t k = 0;
    double t = 0;
    place(points[i].x(), k, t);
    off[i] = points[i].y() - (1 - t) * right[k] - t * right[k + 1];
  }
  return off;
}

// Two residuals per point.
double costOf(const std::vector<ProfilePoint>& points, const Eigen::VectorXd& residuals) {
  double sum = 0, weight = 0;
  for (Eigen::Index i = 0; i < residuals.size(); ++i) {
    const double w = points[static_cast<std::size_t>(i) / 2].weight;
    sum += w * loss(residuals[i]);
    weight += w;
  }
  return sum / weight;
}

struct NormalEquations {
  Eigen::Matrix4d h = Eigen::Matrix4d::Zero();
  Vector4d g = Vector4d::Zero();
};

NormalEquations normalEquations(const std::vector<ProfilePoint>& points,
                                const Eigen::VectorXd& residuals, const Eigen::MatrixXd& jacobian) {
  NormalEquations equations;
  for (Eigen::Index i = 0; i < residuals.size(); ++i) {
    const double a = std::abs(residuals[i]);
    const double w =
        points[static_cast<std::size_t>(i) / 2].weight * (a <= kHuber_mm ? 1 : kHuber_mm / a);
    const Vector4d j = jacobian.row(i).transpose();
    equations.h += w * j * j.transpose();
    equations.g += w * residuals[i] * j;
  }
  return equations;
}

}  // namespace

Revolution::Revolution(std::vector<ProfilePoint> points, const Eigen::Isometry3d& axis_from_model)
    : points_(std::move(points)), start_(axis_from_model) {
  for (const ProfilePoint& point : points_) profiles_ = std::max(profiles_, point.profile + 1);
}

Eigen::Isometry3d Revolution::moved(const Eigen::Isometry3d& start, const Vector4d& q) {
  Eigen::Isometry3d change = Eigen::Isometry3d::Identity();
  const Eigen::Vector3d w(q[0], q[1], 0);
  if (w.norm() > 0) change.linear() = Eigen::AngleAxisd(w.norm(), w.normalized()).matrix();
  change.translation() = Eigen::Vector3d(q[2], q[3], 0);
  return change * start;
}

Eigen::Isometry3d Revolution::moved(const Vector4d& parameters) const {
  return moved(start_, parameters);
}

Eigen::VectorXd Revolution::residuals(const Eigen::Isometry3d& axis_from_model) const {
  Eigen::VectorXd out = Eigen::VectorXd::Zero(2 * static_cast<Eigen::Index>(points_.size()));
  Vector2d circle = Vector2d::Zero();
  double circle_weight = 0;
  for (const ProfilePoint& point : points_) {
    if (point.profile != kCircle) continue;
    const Eigen::Vector3d q = axis_from_model * point.p;
    circle += point.weight * Vector2d(q.head<2>().norm(), q.z());
    circle_weight += point.weight;
  }
  circle /= std::max(1e-12, circle_weight);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (points_[i].profile != kCircle) continue;
    const Eigen::Vector3d q = axis_from_model * points_[i].p;
    out.segment<2>(2 * static_cast<Eigen::Index>(i)) = Vector2d(q.head<2>().norm(), q.z()) - circle;
  }
  for (int profile = 0; profile < profiles_; ++profile) {
    std::vector<Vector2d> places;  // radius, height
    std::vector<double> weights;
    std::vector<std::size_t> from;
    double knot = 3;
    Vector2d mean = Vector2d::Zero();
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (points_[i].profile != profile) continue;
      const Eigen::Vector3d q = axis_from_model * points_[i].p;
      places.emplace_back(q.head<2>().norm(), q.z());
      weights.push_back(points_[i].weight);
      from.push_back(i);
      knot = points_[i].knot_mm;
      mean += places.back();
    }
    if (places.empty()) continue;
    mean /= static_cast<double>(places.size());
    // The profile runs along the direction of largest spread, and is off across it.
    Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
    for (const Vector2d& p : places) spread += (p - mean) * (p - mean).transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(spread);
    Vector2d along = solver.eigenvectors().col(1);
    if (along.y() + 0.5 * along.x() < 0) along = -along;
    const Vector2d across(-along.y(), along.x());
    for (Vector2d& p : places) p = Vector2d((p - mean).dot(along), (p - mean).dot(across));
    const std::vector<double> off = offsets(places, weights, knot);
    for (std::size_t k = 0; k < from.size(); ++k)
      out[2 * static_cast<Eigen::Index>(from[k])] = off[k];
  }
  return out;
}

Eigen::MatrixXd Revolution::jacobian(const Eigen::Isometry3d& axis_from_model) const {
  const Vector4d steps(1e-4, 1e-4, 1e-2, 1e-2);  // rad, rad, mm, mm
  Eigen::MatrixXd columns(2 * static_cast<Eigen::Index>(points_.size()), 4);
  for (int k = 0; k < 4; ++k) {
    const Vector4d step = steps[k] * Vector4d::Unit(k);
    columns.col(k) =
        (residuals(moved(axis_from_model, step)) - residuals(moved(axis_from_model, -step))) /
        (2 * steps[k]);
  }
  return columns;
}

Revolution::Fit Revolution::solve(int rounds) const {
  Fit fit;
  fit.axis_from_model = start_;
  fit.residuals = residuals(fit.axis_from_model);
  fit.cost = costOf(points_, fit.residuals);
  double damping = 1e-3;
  for (int round = 0; round < rounds; ++round) {
    fit.jacobian = jacobian(fit.axis_from_model);
    const NormalEquations equations = normalEquations(points_, fit.residuals, fit.jacobian);
    bool better = false;
    for (int attempt = 0; attempt < 8 && !better; ++attempt, damping *= 4) {
      Eigen::Matrix4d damped = equations.h;
      damped.diagonal() *= 1 + damping;
      const Vector4d q = -damped.ldlt().solve(equations.g);
      if (!q.allFinite()) continue;
      const Eigen::Isometry3d axis = moved(fit.axis_from_model, q);
      const Eigen::VectorXd r = residuals(axis);
      const double cost = costOf(points_, r);
      if (!(cost < fit.cost)) continue;
      better = true;
      const double gain = (fit.cost - cost) / fit.cost;
      fit.axis_from_model = axis;
      fit.residuals = r;
      fit.cost = cost;
      damping = std::max(1e-9, damping / 16);
      if (gain < 1e-6) {
        fit.converged = true;
        return fit;
      }
    }
    if (!better) {
      fit.converged = true;  // no step lowers the cost: a minimum to rounding
      return fit;
    }
  }
  return fit;
}

}  // namespace ostraka::drawing
