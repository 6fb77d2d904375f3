#include "registration/pose_figures.h"

#include <limits>

#include "registration/fracture_icp.h"
#include "registration/self_check.h"

namespace ostraka::registration {
namespace {

using Eigen::Vector3f;

// Within 1 mm, as a finished registration is checked.
FracturePairing contact() {
  FracturePairing pairing;
  pairing.robust_mm = 0.5;
  return pairing;
}

// sign: 1 where the distance is positive when the point lies outside the other side.
std::vector<float> gapsOf(const StripLevel& asked, const StripLevel& other,
                          const Eigen::Isometry3d& other_from_asked, float sign) {
  const std::vector<int> partners = partnersOf(asked, other, other_from_asked, contact());
  const Eigen::Isometry3f to_other = other_from_asked.cast<float>();
  std::vector<float> gaps(partners.size(), std::numeric_limits<float>::quiet_NaN());
  for (std::size_t i = 0; i < partners.size(); ++i) {
    if (partners[i] < 0) continue;
    const std::size_t j = static_cast<std::size_t>(partners[i]);
    const Vector3f between = (to_other.linear() * asked.normals[i] + other.normals[j]).normalized();
    gaps[i] = sign * between.dot(to_other * asked.points[i] - other.points[j]);
  }
  return gaps;
}

}  // namespace

PoseFigures figuresAt(const Strip& front, const Strip& back,
                      const Eigen::Isometry3d& front_from_back) {
  const Eigen::Vector3d pivot = 0.5 * (front.centre + front_from_back * back.centre);
  const FractureFit fracture = fitFracture(front.fine, back.fine, front.up, front_from_back, pivot,
                                           0.5 * (front.radius_mm + back.radius_mm), contact());
  const Thickness wall = thicknessOf(front, back, front_from_back);
  return {fracture.rms_mm, fracture.overlap, wall.crossing_share, wall.median_mm};
}

FractureGaps fractureGaps(const Strip& front, const Strip& back,
                          const Eigen::Isometry3d& front_from_back) {
  return {gapsOf(front.fine, back.fine, front_from_back.inverse(), -1),
          gapsOf(back.fine, front.fine, front_from_back, 1)};
}

}  // namespace ostraka::registration
