#include "registration/self_check.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/median.h"
#include "base/text.h"

namespace ostraka::registration {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr double kLargestRmsMm = 0.60;     // twice the worst true pair of fat stereo strips
constexpr double kSmallestOverlap = 0.02;  // below it the fractures were not seen from both sides
constexpr double kLittleOverlap = 0.20;    // of whole scans 0.6 and more meets
constexpr double kLargestCrossing = 0.10;  // faces may touch at feathered edges only
constexpr float kFace = 0.8f;              // within 37 degrees of the viewer: face, no broken edge

}  // namespace

Thickness thicknessOf(const Strip& front, const Strip& back,
                      const Eigen::Isometry3d& front_from_back) {
  const Vector3d up = (front.up - front_from_back.linear() * back.up).normalized();
  const Vector3d side = up.unitOrthogonal(), across = up.cross(side);
  const auto flat = [&](const Vector3d& p) {
    return Vector3f(static_cast<float>(side.dot(p)), static_cast<float>(across.dot(p)), 0.0f);
  };
  std::vector<Vector3f> plan;
  std::vector<double> heights;
  const Vector3f front_up = up.cast<float>();
  const Vector3f back_up = (front_from_back.linear().transpose() * -up).cast<float>();
  for (std::size_t i = 0; i < back.shell.size(); ++i) {
    if (back.shell_normals[i].dot(back_up) < kFace) continue;
    const Vector3d p = front_from_back * back.shell[i].cast<double>();
    plan.push_back(flat(p));
    heights.push_back(up.dot(p));
  }
  const KdTree tree(plan);
  std::vector<double> walls;
  int crossing = 0;
  for (std::size_t i = 0; i < front.shell.size(); ++i) {
    if (front.shell_normals[i].dot(front_up) < kFace) continue;
    const Vector3d p = front.shell[i].cast<double>();
    const Neighbour below = tree.nearest(flat(p), 1.0f);  // the shell's own spacing
    if (below.index < 0) continue;
    walls.push_back(up.dot(p) - heights[static_cast<std::size_t>(below.index)]);
    crossing += walls.back() < 0 ? 1 : 0;
  }
  Thickness thickness;
  thickness.compared = static_cast<int>(walls.size());
  if (walls.empty()) return thickness;
  thickness.crossing_share = crossing / static_cast<double>(walls.size());
  thickness.median_mm = medianOf(walls);
  return thickness;
}

double fractureLogLikelihood(double fracture_rms_mm, double noise_mm, int pairs) {
  // Of one break: up to 0.17 mm on clean scans (0.13 here). Of two: 0.31-0.42, 0.36 in the middle.
  // Fat strips of photographs reach 0.25-0.32 though they are of one break, and nothing in a single
  // scan tells them (their noise is smooth): in between the fractures must stay silent.
  const double same = std::max(0.17, 1.1 * noise_mm);
  const double other = std::hypot(0.36, same - 0.17);
  constexpr double kSpread = 0.30;  // of the RMS' logarithm from sherd to sherd
  const double above = std::max(0.0, std::log(std::max(fracture_rms_mm, 1e-3) / same) / kSpread);
  const double below = std::min(0.0, std::log(std::max(fracture_rms_mm, 1e-3) / other) / kSpread);
  // Few pairs say little; 200 stand for a fracture of some 30 independent places.
  return std::clamp(0.5 * (below * below - above * above) * std::min(1.0, pairs / 200.0), -12.0,
                    8.0);
}

void checkRegistration(const Strip& front, const Strip& back, Registration& found) {
  const Thickness wall = thicknessOf(front, back, found.front_from_back);
  found.crossing_share = wall.crossing_share;
  found.thickness_mm = wall.median_mm;
  const double facing = front.up.dot(found.front_from_back.linear() * back.up);
  const auto failed_check = [&found](FailedCheck why, std::string reason) {
    found.check_failed = true;
    found.failed_check = why;
    found.reason = std::move(reason);
  };
  if (facing > 0)
    failed_check(FailedCheck::UpsideDown,
                 "The back lies upside down: both sides face the same way.");
  else if (wall.compared > 20 && wall.crossing_share > kLargestCrossing)
    failed_check(FailedCheck::FacesCross,
                 formatted("The faces cross: %.0f %% of the front lies behind the back.",
                           100 * wall.crossing_share));
  else if (found.fracture_overlap < kSmallestOverlap)
    failed_check(FailedCheck::NoSharedFracture,
                 "The two scans share almost no fracture; only their outlines match.");
  else if (found.fracture_overlap < kLittleOverlap)
    failed_check(FailedCheck::NoSharedFracture,
                 formatted("The two scans share only %.0f %% of the fracture.",
                           100 * found.fracture_overlap));
  else if (found.fracture_rms_mm > kLargestRmsMm)
    failed_check(FailedCheck::FractureMisfits,
                 formatted("The fractures do not fit: %.2f mm RMS.", found.fracture_rms_mm));
  else if (found.uncertainty_mm > kLargestUncertaintyMm)
    failed_check(FailedCheck::FractureLoose,
                 formatted("The fracture barely fixes the pose: uncertain by %.2f mm.",
                           found.uncertainty_mm));
  else if (found.runner_up_gap < kRivalGap && found.runner_up_mm > kRivalMm)
    failed_check(FailedCheck::RivalPlace,
                 formatted("A position %.1f mm along the fracture fits almost as well.",
                           found.runner_up_mm));
}

}  // namespace ostraka::registration
