#pragma once
#include <Eigen/Core>
#include <vector>

#include "vessels/noise.h"

namespace ostraka::vessels {

enum class VesselForm { Bowl, Jar, Jug };
const char* name(VesselForm form);

/// A thrown vessel: a surface of revolution about z with base and rim, and a wall of 3-10 mm.
/// Places on it are (s, theta): arc length of the outer profile from the base's centre, mm, and the
/// turn about the axis. s runs from 0 to length(), the rim.
class Vessel {
 public:
  /// wall_mm: typical thickness; the base is thicker, rims thicken or thin out.
  static Vessel make(VesselForm form, double wall_mm, Random& random);

  VesselForm form() const { return form_; }
  double length() const { return step_ * static_cast<double>(radius_.size() - 1); }
  double heel() const { return heel_; }  ///< s where the base turns into the wall
  double radius(double s) const { return at(radius_, s); }
  double thickness(double s) const { return at(thickness_, s); }
  /// Points of the outer and inner surface, mm, with what hands and wheel left of unevenness.
  Eigen::Vector3d outer(double s, double theta) const;
  Eigen::Vector3d inner(double s, double theta) const;

 private:
  double at(const std::vector<double>& values, double s) const;
  Eigen::Vector3d place(double s, double theta, double depth) const;
  /// Pits of old faces, mm into the wall: SD 0.06, self-affine from 4 to 0.5 mm.
  double weathering(const Eigen::Vector3d& p, std::uint32_t face) const;

  static constexpr double step_ = 0.25;  // mm; half a mesh edge
  VesselForm form_ = VesselForm::Bowl;
  double heel_ = 0, ridge_mm_ = 0, ridge_period_ = 5;
  std::uint32_t seed_ = 0;
  std::vector<double> radius_, height_, normal_r_, normal_z_, thickness_;
};

}  // namespace ostraka::vessels
