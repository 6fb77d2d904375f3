#include "registration/fracture_icp.h"

#include <algorithm>
#include <cmath>

#include "base/median.h"

namespace ostraka::registration {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;
using Vector9 = Eigen::Matrix<double, 9, 1>;
using Matrix9 = Eigen::Matrix<double, 9, 9>;

struct Sums {
  Matrix9 information = Matrix9::Zero();
  Vector9 gradient = Vector9::Zero();
  std::vector<double> residuals;
  double spread = 0, cost = 0;
};

class Frame {
 public:
  Frame(const Vector3d& up, const Vector3d& pivot, double radius)
      : up_(up), pivot_(pivot), radius_(std::max(1.0, radius)) {
    side_ = up.unitOrthogonal();
    across_ = up.cross(side_);
  }
  void add(const Vector3d& p, const Vector3d& q, const Vector3d& n, double weight,
           const FracturePairing& pairing, Sums& sums) const {
    const double r = n.dot(q - p);
    sums.residuals.push_back(r);
    const double u = r / pairing.robust_mm, free = 1 - u * u;
    sums.spread += std::min(1.0, u * u);
    if (free <= 0) return;
    const double w = weight * free * free;
    const double tilt = n.dot(up_);
    const Vector3d from = q - pivot_;
    Vector9 row;
    row << from.cross(n), n, tilt, tilt * from.dot(side_) / radius_,
        tilt * from.dot(across_) / radius_;
    sums.information.noalias() += w * row * row.transpose();
    sums.gradient += (w * r) * row;
    sums.cost += 0.5 * w * r * r;
  }

 private:
  Vector3d up_, side_, across_, pivot_;
  double radius_;
};

void asked(const StripLevel& from, const StripLevel& to, const Eigen::Isometry3d& to_from_from,
           const Eigen::Isometry3d& front_from_from, const Eigen::Isometry3d& front_from_to,
           bool from_is_front, const FracturePairing& pairing, const Frame& frame, Sums& sums) {
  const std::vector<int> partners = partnersOf(from, to, to_from_from, pairing);
  for (std::size_t i = 0; i < from.points.size(); ++i) {
    if (partners[i] < 0) {
      sums.spread += 1;
      continue;
    }
    const std::size_t j = static_cast<std::size_t>(partners[i]);
    const Vector3d a = front_from_from * from.points[i].cast<double>();
    const Vector3d b = front_from_to * to.points[j].cast<double>();
    const Vector3d n = (front_from_from.linear() * from.normals[i].cast<double>() +
                        front_from_to.linear() * to.normals[j].cast<double>())
                           .normalized();
    const double weight = std::min(from.weights[i], to.weights[j]);
    frame.add(from_is_front ? a : b, from_is_front ? b : a, n, weight, pairing, sums);
  }
}

double robustSigma(std::vector<double> values) {
  if (values.empty()) return 0;
  for (double& v : values) v = std::abs(v);
  return 1.4826 * medianOf(values);
}

}  // namespace

std::vector<int> partnersOf(const StripLevel& from, const StripLevel& to,
                            const Eigen::Isometry3d& to_from_from, const FracturePairing& pairing) {
  const Eigen::Matrix3f turn = to_from_from.linear().cast<float>();
  const Vector3f shift = to_from_from.translation().cast<float>();
  const float radius = static_cast<float>(pairing.radius_mm);
  std::vector<int> partners(from.points.size(), -1);
  for (std::size_t i = 0; i < from.points.size(); ++i) {
    const Neighbour found = to.tree.nearest(turn * from.points[i] + shift, radius);
    if (found.index >= 0 &&
        (turn * from.normals[i]).dot(to.normals[found.index]) > static_cast<float>(pairing.min_cos))
      partners[i] = found.index;
  }
  return partners;
}

FractureFit fitFracture(const StripLevel& front, const StripLevel& back, const Vector3d& front_up,
                        const Eigen::Isometry3d& front_from_back, const Vector3d& pivot,
                        double radius_of_sherd_mm, const FracturePairing& pairing) {
  const Frame frame(front_up, pivot, radius_of_sherd_mm);
  const Eigen::Isometry3d same = Eigen::Isometry3d::Identity();
  Sums sums;
  asked(back, front, front_from_back, front_from_back, same, false, pairing, frame, sums);
  asked(front, back, front_from_back.inverse(), same, front_from_back, true, pairing, frame, sums);
  FractureFit fit;
  const double count = static_cast<double>(front.points.size() + back.points.size());
  fit.pairs = static_cast<int>(sums.residuals.size());
  fit.overlap = fit.pairs / std::max(1.0, count);
  fit.spread = sums.spread / std::max(1.0, count);
  double squares = 0;
  for (double r : sums.residuals) squares += r * r;
  fit.rms_mm = fit.pairs > 0 ? std::sqrt(squares / fit.pairs) : 0;
  fit.sigma_mm = robustSigma(std::move(sums.residuals));
  const double scale = 1.0 / (pairing.sigma_mm * pairing.sigma_mm * pairing.correlated);
  const Matrix9 all = scale * sums.information;
  const Vector9 slope = scale * sums.gradient;
  // Marginalise the three unknowns of the fatness (Schur complement with their prior).
  const Eigen::Matrix3d bias = all.bottomRightCorner<3, 3>() +
                               Eigen::Matrix3d::Identity() / (pairing.bias_mm * pairing.bias_mm);
  const Eigen::Matrix<double, 6, 3> gain = all.topRightCorner<6, 3>() * bias.inverse();
  fit.evidence.information = all.topLeftCorner<6, 6>() - gain * all.bottomLeftCorner<3, 6>();
  fit.evidence.gradient = slope.head<6>() - gain * slope.tail<3>();
  fit.evidence.cost = scale * sums.cost;
  return fit;
}

}  // namespace ostraka::registration
