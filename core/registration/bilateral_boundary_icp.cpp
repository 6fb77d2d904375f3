#include "registration/bilateral_boundary_icp.h"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "base/message.h"

namespace ostraka::registration {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using Eigen::Vector3f;

struct Pairs {
  std::vector<Vector3d> front, back;  // each in its own frame
  double squares = 0;
};

// A side as equation 2 needs it: its boundary, and all of its points for the other's boundary. Near
// the crease the closest point lies on the face; asked of the strip alone, it would be the strip's
// upper end, and the height came out wrong by 0.08 mm in the median.
struct Side {
  explicit Side(const Strip& strip)
      : points(strip.all), boundary(strip.boundary), tree(strip.all) {}
  const std::vector<Vector3f>&points, &boundary;
  KdTree tree;
};

// Equation 2, both sums: b_i in the back's boundary with its closest front point, and f_j in the
// front's boundary with its closest back point.
Pairs closestPairs(const Side& front, const Side& back, const Isometry3d& pose, double scale,
                   double radius) {
  Pairs pairs;
  const auto add = [&](const Vector3f& f, const Vector3f& b) {
    pairs.front.push_back(f.cast<double>());
    pairs.back.push_back(b.cast<double>());
    pairs.squares += (pose * (scale * pairs.back.back()) - pairs.front.back()).squaredNorm();
  };
  for (const Vector3f& b : back.boundary) {
    const Vector3d q = pose * (scale * b.cast<double>());
    const int j = front.tree.nearest(q.cast<float>(), static_cast<float>(radius)).index;
    if (j >= 0) add(front.points[static_cast<std::size_t>(j)], b);
  }
  const Isometry3d inverse = pose.inverse();
  for (const Vector3f& f : front.boundary) {
    const Vector3d p = inverse * f.cast<double>() / scale;
    const int i = back.tree.nearest(p.cast<float>(), static_cast<float>(radius / scale)).index;
    if (i >= 0) add(f, back.points[static_cast<std::size_t>(i)]);
  }
  return pairs;
}

struct Bounds {
  double least = 1, most = 1;
};

// Square roots of a boundary's two larger variances, of its outline. The third is its bend, which
// each side shows of another edge.
Eigen::Array2d extents(const std::vector<Vector3f>& boundary) {
  Vector3d mean = Vector3d::Zero();
  for (const Vector3f& p : boundary) mean += p.cast<double>();
  mean /= std::max<double>(1, static_cast<double>(boundary.size()));
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const Vector3f& p : boundary) {
    const Vector3d off = p.cast<double>() - mean;
    scatter += off * off.transpose() / static_cast<double>(boundary.size());
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> own(scatter, Eigen::EigenvaluesOnly);
  return own.eigenvalues().tail<2>().array().max(1e-12).sqrt();
}

// Ying et al. 2009: the ratios of the two covariances' eigenvalues bound the scale.
Bounds scaleBounds(const Side& front, const Side& back, double margin) {
  const Eigen::Array2d ratios = extents(front.boundary) / extents(back.boundary);
  return {ratios.minCoeff() * (1 - margin), ratios.maxCoeff() * (1 + margin)};
}

// Least squares (Umeyama 1991). The rotation does not depend on the scale, and the sum of squares
// is a parabola in it: beyond the bounds, the nearer one is best.
void align(const Pairs& pairs, const std::optional<Bounds>& bounds, BilateralBoundaryFit& fit) {
  const auto n = static_cast<Eigen::Index>(pairs.front.size());
  Eigen::Matrix3Xd from(3, n), to(3, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    from.col(i) = pairs.back[static_cast<std::size_t>(i)];
    to.col(i) = pairs.front[static_cast<std::size_t>(i)];
  }
  const Eigen::Matrix4d solved = Eigen::umeyama(from, to, bounds.has_value());
  const double wanted = bounds ? std::cbrt(solved.topLeftCorner<3, 3>().determinant()) : 1.0;
  fit.scale = bounds ? std::clamp(wanted, bounds->least, bounds->most) : 1.0;
  fit.front_from_back.linear() = solved.topLeftCorner<3, 3>() / wanted;
  fit.front_from_back.translation() = solved.topRightCorner<3, 1>();
  if (fit.scale != wanted)
    fit.front_from_back.translation() +=
        fit.front_from_back.linear() * from.rowwise().mean() * (wanted - fit.scale);
}

}  // namespace

Result<BilateralBoundaryFit> bilateralBoundaryIcp(const Strip& front, const Strip& back,
                                                  const Isometry3d& start,
                                                  const BilateralBoundaryIcpOptions& options,
                                                  std::stop_token stop) {
  const Side front_side(front), back_side(back);
  std::optional<Bounds> bounds;
  if (options.free_scale) bounds = scaleBounds(front_side, back_side, options.scale_margin);
  BilateralBoundaryFit fit;
  fit.front_from_back = start;
  double radius = options.first_radius_mm;
  for (int round = 0; round < options.max_rounds; ++round) {
    if (stop.stop_requested()) return Error::cancelled();
    const Pairs pairs = closestPairs(front_side, back_side, fit.front_from_back, fit.scale, radius);
    fit.pairs = static_cast<int>(pairs.front.size());
    if (fit.pairs < 10)
      return Error::notEnough(
          message("Fewer than 10 fracture points match; start from a better pose."));
    fit.rms_mm = std::sqrt(pairs.squares / fit.pairs);
    const Isometry3d before = fit.front_from_back;
    const double scale_before = fit.scale;
    align(pairs, bounds, fit);
    const Isometry3d change = before.inverse() * fit.front_from_back;
    const double moved = (change * back.centre - back.centre).norm() +
                         Eigen::AngleAxisd(change.linear()).angle() * back.radius_mm +
                         std::abs(fit.scale - scale_before) * back.radius_mm;
    if (radius <= options.last_radius_mm && moved < 1e-4) break;
    radius = std::max(options.last_radius_mm, radius * 0.85);
  }
  return fit;
}

}  // namespace ostraka::registration
