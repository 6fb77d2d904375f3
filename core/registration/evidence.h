#pragma once
#include <Eigen/Geometry>

namespace ostraka::registration {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// What a constraint says about a small change of the pose: minus log-likelihood is about
/// cost + gradient.x + x'.information.x / 2, x = (turn in rad, shift in mm) about a pivot.
struct Evidence {
  Matrix6 information = Matrix6::Zero();
  Vector6 gradient = Vector6::Zero();
  double cost = 0;

  /// A residual in units of its sigma with its row of derivatives.
  void add(double residual, const Vector6& row, double weight = 1) {
    information.noalias() += weight * row * row.transpose();
    gradient += weight * residual * row;
    cost += 0.5 * weight * residual * residual;
  }
  Evidence& operator+=(const Evidence& other) {
    information += other.information;
    gradient += other.gradient;
    cost += other.cost;
    return *this;
  }
};

/// d(n . (T q)) / dx for q already in the front's frame.
inline Vector6 rowOf(const Eigen::Vector3d& q, const Eigen::Vector3d& n,
                     const Eigen::Vector3d& pivot) {
  Vector6 row;
  row << (q - pivot).cross(n), n;
  return row;
}

/// The pose after the small change x about the pivot, both in the target's frame.
inline Eigen::Isometry3d changed(const Eigen::Isometry3d& pose, const Vector6& x,
                                 const Eigen::Vector3d& pivot) {
  const Eigen::Vector3d turn = x.head<3>();
  const double angle = turn.norm();
  const Eigen::Matrix3d rotation = angle > 1e-15
                                       ? Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix()
                                       : Eigen::Matrix3d::Identity();
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  // Through a quaternion, so that hundreds of steps leave it a rotation.
  result.linear() =
      Eigen::Quaterniond(Eigen::Matrix3d(rotation * pose.linear())).normalized().toRotationMatrix();
  result.translation() = rotation * (pose.translation() - pivot) + pivot + x.tail<3>();
  return result;
}

}  // namespace ostraka::registration
