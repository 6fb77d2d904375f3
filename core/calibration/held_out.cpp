#include "calibration/held_out.h"

#include <algorithm>
#include <cmath>

#include "base/message.h"

namespace ostraka::calibration {
namespace {

std::size_t markerOf(const PlateCorner& corner) {
  return static_cast<std::size_t>(corner.plate_point) / 4;
}

Eigen::Vector3d middle(const std::array<Eigen::Vector3d, 4>& corners) {
  return (corners[0] + corners[1] + corners[2] + corners[3]) / 4;
}

Message withSign(double value, int digits) {
  return Message(std::signbit(value) ? "%1" : "+%1", {decimal(value, digits)});
}

}  // namespace

std::vector<PlateCorner> ofMarker(const std::vector<PlateCorner>& corners, std::size_t marker) {
  std::vector<PlateCorner> own;
  for (const PlateCorner& corner : corners)
    if (markerOf(corner) == marker) own.push_back(corner);
  return own;
}

std::optional<std::array<Eigen::Vector3d, 4>> cornersInSpace(
    const RigState& state, const std::vector<PlateCorner>& corners) {
  // Sum over rays of |(I - d d') (p - o)|^2: normal equations per corner.
  std::array<Eigen::Matrix3d, 4> a;
  std::array<Eigen::Vector3d, 4> b;
  std::array<int, 4> views{};
  for (int k = 0; k < 4; ++k) {
    a[k].setZero();
    b[k].setZero();
  }
  for (const PlateCorner& corner : corners) {
    const RigState::Camera& camera = state.cameras[corner.camera];
    const Eigen::Isometry3d plate_from_camera =
        state.cameraFromPlate(corner.camera, corner.side, corner.stop).inverse();
    const Eigen::Vector2d n =
        camera.intrinsics.unproject(corner.pixel + camera.inset_px * corner.outward);
    const Eigen::Vector3d d =
        (plate_from_camera.linear() * Eigen::Vector3d(n.x(), n.y(), 1)).normalized();
    const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - d * d.transpose();
    const int k = corner.plate_point % 4;
    a[k] += across;
    b[k] += across * plate_from_camera.translation();
    ++views[k];
  }
  std::array<Eigen::Vector3d, 4> found;
  for (int k = 0; k < 4; ++k) {
    if (views[k] < 2) return std::nullopt;
    found[k] = a[k].ldlt().solve(b[k]);
    if (!found[k].allFinite()) return std::nullopt;
  }
  return found;
}

std::vector<std::size_t> markersToHoldOut(const batch::Plate& plate,
                                          const std::vector<PlateCorner>& corners) {
  std::vector<int> seen(plate.markers.size(), 0);
  for (const PlateCorner& corner : corners) ++seen[markerOf(corner)];
  std::vector<std::pair<double, std::size_t>> around;  // direction, index
  for (std::size_t m = 0; m < plate.markers.size(); ++m) {
    const Eigen::Vector3d p = middle(plate.markers[m].corners);
    if (seen[m] >= 8) around.emplace_back(std::atan2(p.y(), p.x()), m);
  }
  if (around.size() < 8) return {};
  std::sort(around.begin(), around.end());
  std::vector<std::size_t> chosen;
  for (std::size_t k = 0; k < 4; ++k) chosen.push_back(around[k * around.size() / 4].second);
  return chosen;
}

std::vector<HeldOutDistance> heldOutDistances(const batch::Plate& plate,
                                              const std::vector<std::size_t>& held_out,
                                              const RigState& state,
                                              const std::vector<PlateCorner>& corners) {
  std::vector<HeldOutDistance> distances;
  for (std::size_t k = 0; k + 2 < held_out.size(); ++k) {
    const std::size_t first = held_out[k], second = held_out[k + 2];
    const auto a = cornersInSpace(state, ofMarker(corners, first));
    const auto b = cornersInSpace(state, ofMarker(corners, second));
    if (!a || !b) continue;
    const batch::Marker &m = plate.markers[first], &n = plate.markers[second];
    distances.push_back({m.id, n.id, (middle(m.corners) - middle(n.corners)).norm(),
                         (middle(*a) - middle(*b)).norm()});
  }
  return distances;
}

Message said(Template<6> words, const HeldOutDistance& d) {
  return message(words, d.first, d.second, decimal(d.measured_mm, 2), decimal(d.expected_mm, 2),
                 withSign(d.measured_mm - d.expected_mm, 2), withSign(100 * d.error(), 3));
}

std::optional<Message> scaleDoubt(const HeldOutDistance& d) {
  if (std::abs(d.error()) <= kMostScaleError) return std::nullopt;
  return said(
      translatable<6>(
          "The scale is wrong: markers %1 and %2, held out of the fit, are %3 mm apart instead of "
          "%4 (%5 mm, %6 %); check that plate.json belongs to this plate, that the plate is "
          "printed and glued without distortion, and that a known rig was calibrated with it."),
      d);
}

Move moveAgainst(const RigState& known, const RigState& now, std::size_t index,
                 std::size_t reference) {
  const auto pose = [](const RigState& state, std::size_t camera) {
    return state.cameras[camera].camera_from_turntable;
  };
  // The turntable of `known` as `now` has it, told by the reference camera.
  const Eigen::Isometry3d now_from_known = pose(now, reference).inverse() * pose(known, reference);
  const Eigen::Isometry3d camera_from_known = pose(now, index) * now_from_known;
  const Eigen::Isometry3d change = pose(known, index) * camera_from_known.inverse();
  return {(camera_from_known.inverse().translation() - pose(known, index).inverse().translation())
              .norm(),
          Eigen::AngleAxisd(change.linear()).angle()};
}

Message sentence(const Move& move, int camera, int reference) {
  return message(
      "Relative to camera %1, camera %2 has moved by %3 mm and turned by %4 degrees since the rig "
      "was calibrated.",
      batch::cameraLetter(reference), batch::cameraLetter(camera), decimal(move.moved_mm, 1),
      decimal(move.turned_rad * 180 / M_PI, 2));
}

}  // namespace ostraka::calibration
