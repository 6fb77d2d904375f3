#include "registration/contact.h"

#include <Eigen/LU>
#include <cmath>
#include <vector>

namespace ostraka::registration {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kFacesPlate = 0.5;  // cosine: 60 degrees
// A smooth surface touches where it is parallel to the plate; the shell's normals hold to some 5
// degrees on scans of stereo. A face that leans by more than 14 ends nearby.
constexpr double kLiesOnPlate = 0.97;

double crossOf(const Vector2d& a, const Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

bool holds(const std::array<Vector3d, 3>& t, const Vector2d& c) {
  int signs = 0;
  for (int k = 0; k < 3; ++k) {
    const Vector2d a = t[k].head<2>(), b = t[(k + 1) % 3].head<2>();
    signs += crossOf(b - a, c - a) >= 0 ? 1 : -1;
  }
  return std::abs(signs) == 3;
}

}  // namespace

// The dual simplex on 'the highest plane at the centre that stays below all points': a triangle
// around the centre goes down to the point farthest below its plane until there is none.
Contact restingFacet(const Strip& side, const Eigen::Isometry3d& plate_from_side,
                     const Vector3d& centre_plate, const rig::SheetBend& ground) {
  std::vector<Vector3d> points;
  points.reserve(side.shell.size());
  std::vector<int> indices;
  const Vector3d down = -(plate_from_side.linear().transpose() * Vector3d::UnitZ());
  for (std::size_t i = 0; i < side.shell.size(); ++i) {
    if (side.shell_normals[i].cast<double>().dot(down) < kFacesPlate) continue;
    points.push_back(plate_from_side * side.shell[i].cast<double>());
    points.back().z() -= ground.at(points.back().x(), points.back().y());
    indices.push_back(static_cast<int>(i));
  }
  const Vector2d c = centre_plate.head<2>();
  const double far = 1e4, high = 1e6;  // mm: a start far outside any sherd
  std::array<Vector3d, 3> t = {Vector3d(c.x() - far, c.y() - far, high),
                               Vector3d(c.x() + far, c.y() - far, high),
                               Vector3d(c.x(), c.y() + far, high)};
  Contact contact;
  contact.points = {-1, -1, -1};
  for (int round = 0; round < 100; ++round) {
    const Vector3d normal = (t[1] - t[0]).cross(t[2] - t[0]);
    if (std::abs(normal.z()) < 1e-9) break;
    const Vector3d n = normal / normal.z();  // height above the plane, measured along z
    const double offset = n.dot(t[0]);
    int deepest = -1;
    double depth = -1e-6;
    for (int i = 0; i < static_cast<int>(points.size()); ++i) {
      const double d = n.dot(points[i]) - offset;
      if (d < depth) {
        depth = d;
        deepest = i;
      }
    }
    if (deepest < 0) break;
    bool replaced = false;
    for (int k = 0; k < 3 && !replaced; ++k) {
      std::array<Vector3d, 3> next = t;
      next[k] = points[deepest];
      if (!holds(next, c)) continue;
      t = next;
      contact.points[k] = indices[static_cast<std::size_t>(deepest)];
      replaced = true;
    }
    if (!replaced) break;
  }
  contact.found = contact.points[0] >= 0 && contact.points[1] >= 0 && contact.points[2] >= 0;
  return contact;
}

namespace {

struct HeightError {
  double sigma_mm, gap_mm;
};

HeightError errorOf(bool inside, bool leans, const ContactOptions& options) {
  if (options.grain_mm <= 0)
    return inside ? HeightError{options.scanned_face_sigma_mm, options.scanned_face_gap_mm}
                  : HeightError{options.scanned_edge_sigma_mm, options.scanned_edge_gap_mm};
  if (inside && !leans) return {options.grain_mm * options.face_sigma, options.plate_gap_mm};
  return {options.grain_mm * options.edge_sigma,
          options.plate_gap_mm + options.grain_mm * options.edge_gap};
}

// Upward normal of the ground, its z being 1.
Vector3d upOf(const rig::SheetBend& ground, const Vector3d& p) {
  return {ground.at(p.x() - 0.5, p.y()) - ground.at(p.x() + 0.5, p.y()),
          ground.at(p.x(), p.y() - 0.5) - ground.at(p.x(), p.y() + 0.5), 1};
}

void addRest(const Strip& side, const Eigen::Isometry3d& plate_from_side, const Vector3d& centre,
             const Eigen::Isometry3d& front_from_back, const Vector3d& pivot, bool side_is_back,
             const rig::SheetBend& ground, double widened, const ContactOptions& options,
             Evidence& evidence) {
  const Contact contact = restingFacet(side, plate_from_side, centre, ground);
  if (!contact.found) return;
  const Vector3d down = -(plate_from_side.linear().transpose() * Vector3d::UnitZ());
  Eigen::Matrix<double, 3, 6> rows;
  Vector3d heights, rises, own_squares;
  for (int k = 0; k < 3; ++k) {
    const auto i = static_cast<std::size_t>(contact.points[static_cast<std::size_t>(k)]);
    const Vector3d p_side = side.shell[i].cast<double>();
    const Vector3d p = plate_from_side * p_side;
    const bool leans = side.shell_normals[i].cast<double>().dot(down) < kLiesOnPlate;
    const auto [own, gap] = errorOf(side.shell_inside[i] != 0, leans, options);
    own_squares[k] = std::pow(std::max(widened, own), 2);
    heights[k] = p.z() - ground.at(p.x(), p.y()) - gap;
    rises[k] = ground.rise(p.x(), p.y());
    // Where the front stands on the back's plate, z_back = e_z . inv(T) p: moving the back by x
    // moves the front's point against it, so the derivative is that of -n . p, n = R e_z.
    const Vector3d n =
        side_is_back ? upOf(ground, p) : Vector3d(-front_from_back.linear() * upOf(ground, p));
    rows.row(k) = rowOf(side_is_back ? p : p_side, n, pivot).transpose();
  }
  // Of heights that err each by its own, all by the plate's, and in proportion by the share of its
  // rise by which a sheet gives way: its second moment is 1/3.
  const double common = options.grain_mm > 0 ? options.plate_sigma_mm : 0.001;
  const Eigen::Matrix3d weight =
      (Eigen::Matrix3d(own_squares.asDiagonal()) + Eigen::Matrix3d::Constant(common * common) +
       rises * rises.transpose() / 3)
          .inverse();
  evidence.information += rows.transpose() * weight * rows;
  evidence.gradient += rows.transpose() * weight * heights;
  evidence.cost += 0.5 * heights.dot(weight * heights);
}

}  // namespace

Evidence contactEvidence(const Strip& front, const Strip& back,
                         const Eigen::Isometry3d& front_from_back, const Vector3d& pivot,
                         const rig::Support& front_support, const rig::Support& back_support,
                         double widened, const ContactOptions& options) {
  const Eigen::Isometry3d back_from_front = front_from_back.inverse();
  // The centre of mass of a sherd of even thickness: half way between its two faces.
  const Vector3d centre = 0.5 * (front.centre + front_from_back * back.centre);
  Evidence evidence;
  if (front_support)
    addRest(back, front_from_back, centre, front_from_back, pivot, true, *front_support, widened,
            options, evidence);
  if (back_support)
    addRest(front, back_from_front, back_from_front * centre, front_from_back, pivot, false,
            *back_support, widened, options, evidence);
  return evidence;
}

}  // namespace ostraka::registration
