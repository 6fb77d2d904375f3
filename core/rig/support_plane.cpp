#include "rig/support_plane.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <random>

#include "base/median.h"

namespace ostraka::rig {
namespace {

constexpr int kDraws = 2000;         // a plane with a tenth of the points is drawn twice
constexpr double kNearRadii = 2;     // of the common sight: what lies farther away is the room
constexpr double kThickness = 0.01;  // of the sight's radius: what sparse points scatter by
constexpr double kLeastPlaneShare = 0.1;
constexpr std::size_t kFewestPoints = 30;
constexpr double kBelowShare = 0.2;   // of the points on the plane: wild ones, and past its edges
constexpr double kSteepest = 0.5;     // cosine to `up`: 60 degrees
constexpr double kLeastExtent = 0.5;  // of the sight's radius, in both directions

Eigen::Isometry3d looking(const Eigen::Vector3d& z, const Eigen::Vector3d& origin) {
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  const Eigen::Matrix3d turn =
      Eigen::Quaterniond::FromTwoVectors(z, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  frame.linear() = turn;
  frame.translation() = -turn * origin;
  return frame;
}

struct Counted {
  std::size_t on = 0, below = 0;
};

Counted count(const std::vector<Eigen::Vector3d>& points, const Eigen::Hyperplane<double, 3>& plane,
              double thickness) {
  Counted counted;
  for (const Eigen::Vector3d& p : points) {
    const double height = plane.signedDistance(p);
    counted.on += std::abs(height) < thickness ? 1 : 0;
    counted.below += height < -3 * thickness ? 1 : 0;
  }
  return counted;
}

// Through the points that lie on it, so that three of them do not decide.
Eigen::Hyperplane<double, 3> refined(const std::vector<Eigen::Vector3d>& points,
                                     Eigen::Hyperplane<double, 3> plane, double thickness) {
  for (int round = 0; round < 3; ++round) {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
    double n = 0;
    for (const Eigen::Vector3d& p : points)
      if (std::abs(plane.signedDistance(p)) < thickness)
        mean += p, squares += p * p.transpose(), ++n;
    if (n < 3) break;
    mean /= n;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(squares / n -
                                                                mean * mean.transpose());
    Eigen::Vector3d normal = solver.eigenvectors().col(0);
    if (normal.dot(plane.normal()) < 0) normal = -normal;
    plane = Eigen::Hyperplane<double, 3>(normal, mean);
  }
  return plane;
}

// From the 2nd to the 98th of a hundred: beyond them few points were seen.
std::pair<double, double> spanOf(const std::vector<double>& values) {
  return {rankedAt(values, 0.02), rankedAt(values, 0.98)};
}

}  // namespace

Sight commonSight(std::span<const PosedImage> images) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (const PosedImage& image : images) {
    const Eigen::Vector3d axis = image.camera_from_plate.linear().row(2);
    const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - axis * axis.transpose();
    normal += across;
    right += across * image.centre();
  }
  Sight sight;
  sight.centre = normal.ldlt().solve(right);
  std::vector<double> radii;
  for (const PosedImage& image : images) {
    const double depth = (image.camera_from_plate * sight.centre).z();
    const int shorter = std::min(image.intrinsics.width, image.intrinsics.height);
    if (depth > 0) radii.push_back(0.25 * shorter / image.intrinsics.fx * depth);
  }
  sight.radius = medianOf(radii);
  return sight;
}

Eigen::Isometry3d uprightFrame(std::span<const PosedImage> images) {
  Eigen::Vector3d up = Eigen::Vector3d::Zero();
  for (const PosedImage& image : images) {
    const Eigen::Matrix3d& turn = image.camera_from_plate.linear();
    up -= turn.row(1).transpose() + turn.row(2).transpose();
  }
  const Eigen::Vector3d z = up.norm() > 1e-9 ? up.normalized() : Eigen::Vector3d::UnitZ();
  return looking(z, commonSight(images).centre);
}

std::optional<SupportPlane> findSupportPlane(std::span<const PosedImage> images,
                                             const std::vector<Eigen::Vector3d>& points,
                                             const Eigen::Vector3d& up) {
  const Sight sight = commonSight(images);
  if (!sight.sound()) return std::nullopt;
  std::vector<Eigen::Vector3d> near;
  for (const Eigen::Vector3d& p : points)
    if ((p - sight.centre).norm() < kNearRadii * sight.radius) near.push_back(p);
  const double thickness = kThickness * sight.radius;
  const auto fewest = std::max(
      kFewestPoints, static_cast<std::size_t>(kLeastPlaneShare * static_cast<double>(near.size())));
  if (near.size() < fewest) return std::nullopt;
  std::mt19937 random(1);
  std::optional<Eigen::Hyperplane<double, 3>> best;
  std::size_t most = 0;
  for (int draw = 0; draw < kDraws; ++draw) {
    const Eigen::Vector3d &a = near[random() % near.size()], &b = near[random() % near.size()],
                          &c = near[random() % near.size()];
    Eigen::Vector3d normal = (b - a).cross(c - a);
    if (normal.norm() < 1e-3 * sight.radius * sight.radius) continue;
    normal.normalize();
    if (normal.dot(up) < 0) normal = -normal;
    if (normal.dot(up) < kSteepest) continue;
    const Eigen::Hyperplane<double, 3> plane(normal, a);
    const Counted counted = count(near, plane, thickness);
    if (counted.on <= most || counted.on < fewest ||
        static_cast<double>(counted.below) > kBelowShare * static_cast<double>(counted.on) ||
        !std::all_of(images.begin(), images.end(), [&](const PosedImage& image) {
          return plane.signedDistance(image.centre()) > 0;
        }))
      continue;
    most = counted.on;
    best = plane;
  }
  if (!best) return std::nullopt;
  const Eigen::Hyperplane<double, 3> plane = refined(near, *best, thickness);
  Eigen::Isometry3d frame = looking(plane.normal(), plane.projection(sight.centre));
  std::vector<double> x, y;
  for (const Eigen::Vector3d& p : near) {
    if (std::abs(plane.signedDistance(p)) > thickness) continue;
    const Eigen::Vector3d q = frame * p;
    x.push_back(q.x()), y.push_back(q.y());
  }
  const auto [left, right] = spanOf(std::move(x));
  const auto [low, high] = spanOf(std::move(y));
  if (std::min(right - left, high - low) < kLeastExtent * sight.radius) return std::nullopt;
  const Eigen::Vector2d half(0.5 * (right - left), 0.5 * (high - low));
  frame.translation() -= Eigen::Vector3d(0.5 * (left + right), 0.5 * (low + high), 0);
  return SupportPlane{frame, Eigen::AlignedBox2d(-half, half)};
}

}  // namespace ostraka::rig
