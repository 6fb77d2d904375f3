#pragma once
#include <Eigen/Geometry>
#include <vector>

namespace ostraka::drawing {

/// A point that lies on one of several surfaces of revolution about a common axis, or on a circle
/// about it.
struct ProfilePoint {
  Eigen::Vector3d p;
  int profile = 0;     ///< which surface; kCircle: the one circle
  double knot_mm = 3;  ///< spacing of this profile's knots, the same for all its points
  double weight = 1;
};

/// Finding an axis with free profiles: parameters are small turns about x and y and shifts along x
/// and y of a start frame whose z is the axis.
class Revolution {
 public:
  static constexpr int kCircle = -1;
  Revolution(std::vector<ProfilePoint> points, const Eigen::Isometry3d& axis_from_model);

  struct Fit {
    Eigen::Isometry3d axis_from_model = Eigen::Isometry3d::Identity();
    double cost = 0;  ///< mean robust loss per point, mm^2
    /// mm, off the profile; two per point, the second 0 but on the circle: off its mean radius and
    /// its mean height.
    Eigen::VectorXd residuals;
    Eigen::MatrixXd jacobian;  ///< per parameter: rad, rad, mm, mm
    bool converged = false;
  };
  /// Levenberg-Marquardt with a Huber loss at 0.3 mm; the profiles (piecewise linear in the
  /// direction in which each runs) are solved anew in every step.
  Fit solve(int rounds) const;

  /// The start frame moved by parameters.
  Eigen::Isometry3d moved(const Eigen::Vector4d& parameters) const;
  static Eigen::Isometry3d moved(const Eigen::Isometry3d& start, const Eigen::Vector4d& parameters);

 private:
  Eigen::VectorXd residuals(const Eigen::Isometry3d& axis_from_model) const;
  Eigen::MatrixXd jacobian(const Eigen::Isometry3d& axis_from_model) const;

  std::vector<ProfilePoint> points_;
  Eigen::Isometry3d start_;
  int profiles_ = 0;
};

}  // namespace ostraka::drawing
