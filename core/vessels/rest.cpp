#include "vessels/rest.h"

#include <array>
#include <cmath>
#include <vector>

namespace ostraka::vessels {
namespace {

using Points = std::vector<Eigen::Vector3d>;

// Turns all points about a horizontal axis through `pivot` until the next one touches the plane of
// the pivot, and returns that one; the axis has the falling side on its right-hand turn.
int tiltUntilContact(Points& points, const Eigen::Vector3d& pivot, const Eigen::Vector3d& axis,
                     const std::vector<int>& standing, Eigen::Matrix3d& turned) {
  const Eigen::Vector3d falling = axis.cross(Eigen::Vector3d::UnitZ());
  double smallest = 1e9;
  int contact = -1;
  for (std::size_t i = 0; i < points.size(); ++i) {
    bool stands = false;
    for (const int s : standing) stands = stands || s == static_cast<int>(i);
    if (stands) continue;
    const Eigen::Vector3d p = points[i] - pivot;
    const double reach = falling.dot(p), height = std::max(0.0, p.z());
    if (reach <= 1e-9) continue;
    const double angle = std::atan2(height, reach);
    if (angle < smallest) {
      smallest = angle;
      contact = static_cast<int>(i);
    }
  }
  if (contact < 0) return -1;
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(smallest, axis).toRotationMatrix();
  for (Eigen::Vector3d& p : points) p = turn * (p - pivot) + pivot;
  turned = turn * turned;
  return contact;
}

// The side of a triangle over which the centre leans out most, or -1 when it stands.
int openSide(const Points& points, const std::array<int, 3>& feet, const Eigen::Vector3d& centre) {
  int open = -1;
  double farthest = 1e-9;
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d& a = points[feet[k]];
    const Eigen::Vector3d& b = points[feet[(k + 1) % 3]];
    const Eigen::Vector3d& c = points[feet[(k + 2) % 3]];
    Eigen::Vector2d n(-(b - a).y(), (b - a).x());
    n.normalize();
    if (n.dot((c - a).head<2>()) < 0) n = -n;
    const double out = -n.dot((centre - a).head<2>());
    if (out > farthest) {
      farthest = out;
      open = k;
    }
  }
  return open;
}

// The horizontal axis along a-b about which the centre falls outward.
Eigen::Vector3d fallingAxis(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                            const Eigen::Vector3d& centre) {
  Eigen::Vector3d axis = b - a;
  axis.z() = 0;
  axis.normalize();
  const Eigen::Vector3d falling = axis.cross(Eigen::Vector3d::UnitZ());
  return falling.dot(centre - a) >= 0 ? axis : Eigen::Vector3d(-axis);
}

}  // namespace

Eigen::Isometry3d restPose(const TriangleMesh& mesh, const Eigen::Vector3d& up_model) {
  Eigen::Matrix3d turned =
      Eigen::Quaterniond::FromTwoVectors(up_model.normalized(), Eigen::Vector3d::UnitZ())
          .toRotationMatrix();
  Points points;
  points.reserve(mesh.vertices.size() + 1);
  for (const Eigen::Vector3f& v : mesh.vertices) points.push_back(turned * v.cast<double>());
  int lowest = 0;
  for (std::size_t i = 1; i < points.size(); ++i)
    if (points[i].z() < points[lowest].z()) lowest = static_cast<int>(i);
  points.push_back(Eigen::Vector3d::Zero());  // the centre of mass turns along; never a foot
  const int c = static_cast<int>(points.size()) - 1;

  const Eigen::Vector3d lean = points[c] - points[lowest];
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ().cross(Eigen::Vector3d(lean.x(), lean.y(), 0));
  axis = axis.norm() > 1e-9 ? axis.normalized() : Eigen::Vector3d::UnitX();
  const int second = tiltUntilContact(points, points[lowest], axis, {lowest, c}, turned);
  axis = fallingAxis(points[lowest], points[second], points[c]);
  const int third = tiltUntilContact(points, points[lowest], axis, {lowest, second, c}, turned);
  std::array<int, 3> feet{lowest, second, third};
  for (int round = 0; round < 2000; ++round) {
    const int side = openSide(points, feet, points[c]);
    if (side < 0) break;
    const int a = feet[side], b = feet[(side + 1) % 3];
    axis = fallingAxis(points[a], points[b], points[c]);
    const int next = tiltUntilContact(points, points[a], axis, {a, b, c}, turned);
    if (next < 0) break;
    feet = {a, b, next};
  }
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = Eigen::Quaterniond(turned).normalized().toRotationMatrix();
  double floor = 1e9;
  for (const Eigen::Vector3f& v : mesh.vertices)
    floor = std::min(floor, (pose.linear() * v.cast<double>()).z());
  pose.translation().z() = -floor;
  return pose;
}

}  // namespace ostraka::vessels
