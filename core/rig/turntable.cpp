#include "rig/turntable.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace ostraka::rig {
namespace {

// A kitchen turntable wobbles by half a degree; a person's aim and roll scatter by ten times that.
constexpr double kTilt_rad = 0.02;
constexpr double kReach = 0.015;  // of the camera's distance: height, and place on the circle
constexpr double kLeastShare = 0.8;

bool standsAlike(const PosedImage& a, const PosedImage& b) {
  const Eigen::Vector3d up_a = a.camera_from_plate.linear().col(2),
                        up_b = b.camera_from_plate.linear().col(2);
  const Eigen::Vector3d at_a = a.centre(), at_b = b.centre();
  return std::acos(std::clamp(up_a.dot(up_b), -1.0, 1.0)) < kTilt_rad &&
         std::abs(at_a.z() - at_b.z()) < kReach * at_a.norm();
}

// By how much a camera at rest sees the plate turned between two photographs.
double turnBetween(const PosedImage& from, const PosedImage& to) {
  const Eigen::Matrix3d turn =
      to.camera_from_plate.linear().transpose() * from.camera_from_plate.linear();
  return std::atan2(turn(1, 0) - turn(0, 1), turn(0, 0) + turn(1, 1));
}

// Whether the members' centres are the first one's, turned about one upright axis: with the axis
// through p, c_k = p + Z_k (c_0 - p) is linear in p.
bool turnAboutOneAxis(std::span<const PosedImage> images, const std::vector<std::size_t>& members) {
  const PosedImage& first = images[members.front()];
  const Eigen::Vector2d c0 = first.centre().head<2>();
  Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  const auto equation = [&](std::size_t k) {
    const Eigen::Matrix2d turned =
        Eigen::Rotation2Dd(turnBetween(first, images[k])).toRotationMatrix();
    return std::pair<Eigen::Matrix2d, Eigen::Vector2d>(Eigen::Matrix2d::Identity() - turned,
                                                       images[k].centre().head<2>() - turned * c0);
  };
  for (const std::size_t k : members) {
    const auto [a, b] = equation(k);
    normal += a.transpose() * a;
    right += a.transpose() * b;
  }
  const Eigen::LDLT<Eigen::Matrix2d> solver(normal);
  // A quarter of a turn in all at least; less and the axis could be anywhere.
  if (normal.diagonal().minCoeff() < 1) return false;
  const Eigen::Vector2d axis = solver.solve(right);
  const double limit = kReach * first.centre().norm();
  return std::all_of(members.begin(), members.end(), [&](std::size_t k) {
    const auto [a, b] = equation(k);
    return (a * axis - b).norm() < limit;
  });
}

}  // namespace

std::optional<std::vector<TurntablePlace>> turntablePlaces(std::span<const PosedImage> images) {
  std::vector<TurntablePlace> places(images.size());
  std::size_t placed = 0;
  for (int ring = 0;; ++ring) {
    std::vector<std::size_t> largest;
    for (std::size_t i = 0; i < images.size(); ++i) {
      if (places[i].ring >= 0) continue;
      std::vector<std::size_t> alike;
      for (std::size_t k = 0; k < images.size(); ++k)
        if (places[k].ring < 0 && standsAlike(images[i], images[k])) alike.push_back(k);
      if (alike.size() > largest.size() && alike.size() >= kLeastStops &&
          turnAboutOneAxis(images, alike))
        largest = std::move(alike);
    }
    if (largest.empty()) break;
    for (std::size_t k = 0; k < largest.size(); ++k)
      places[largest[k]] = {ring, static_cast<int>(k)};
    placed += largest.size();
  }
  if (static_cast<double>(placed) < kLeastShare * static_cast<double>(images.size()) || placed == 0)
    return std::nullopt;
  return places;
}

}  // namespace ostraka::rig
