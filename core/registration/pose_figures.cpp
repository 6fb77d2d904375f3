#include "registration/pose_figures.h"

#include "registration/fracture_icp.h"
#include "registration/self_check.h"

namespace ostraka::registration {
namespace {

using Eigen::Vector3f;

constexpr float kSameFaceCos = 0.7071f;  // beyond 45 degrees it is another face

// From `asked` (brought to the other's frame) to the other strip; points are given in the front's
// frame. sign: 1 when the distance is positive where what is asked lies outside.
void addDistances(const StripLevel& asked, const StripLevel& other,
                  const Eigen::Isometry3f& other_from_asked,
                  const Eigen::Isometry3f& front_from_asked, float reach_mm, float sign,
                  std::vector<FractureDistance>& found) {
  for (std::size_t i = 0; i < asked.points.size(); ++i) {
    const Vector3f p = other_from_asked * asked.points[i];
    const Neighbour near = other.tree.nearest(p, reach_mm);
    if (near.index < 0) continue;
    const std::size_t j = static_cast<std::size_t>(near.index);
    const Vector3f normal = other_from_asked.linear() * asked.normals[i];
    if (normal.dot(other.normals[j]) < kSameFaceCos) continue;
    const Vector3f between = (normal + other.normals[j]).normalized();
    found.push_back({front_from_asked * asked.points[i], sign * between.dot(p - other.points[j])});
  }
}

}  // namespace

PoseFigures figuresAt(const Strip& front, const Strip& back,
                      const Eigen::Isometry3d& front_from_back) {
  FracturePairing pairing;  // within 1 mm, as a finished registration is checked
  pairing.robust_mm = 0.5;
  const Eigen::Vector3d pivot = 0.5 * (front.centre + front_from_back * back.centre);
  const FractureFit fracture = fitFracture(front.fine, back.fine, front.up, front_from_back, pivot,
                                           0.5 * (front.radius_mm + back.radius_mm), pairing);
  const Thickness wall = thicknessOf(front, back, front_from_back);
  return {fracture.rms_mm, fracture.overlap, wall.crossing_share, wall.median_mm};
}

std::vector<FractureDistance> fractureDistances(const Strip& front, const Strip& back,
                                                const Eigen::Isometry3d& front_from_back,
                                                double reach_mm) {
  std::vector<FractureDistance> found;
  const Eigen::Isometry3f to_front = front_from_back.cast<float>();
  const float reach = static_cast<float>(reach_mm);
  addDistances(front.fine, back.fine, to_front.inverse(), Eigen::Isometry3f::Identity(), reach, -1,
               found);
  addDistances(back.fine, front.fine, to_front, to_front, reach, 1, found);
  return found;
}

}  // namespace ostraka::registration
