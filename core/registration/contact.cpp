#include "registration/contact.h"

#include <Eigen/LU>
#include <cmath>
#include <vector>

namespace ostraka::registration {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

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
                     const Vector3d& centre_plate) {
  std::vector<Vector3d> points;
  points.reserve(side.shell.size());
  for (const Eigen::Vector3f& p : side.shell) points.push_back(plate_from_side * p.cast<double>());
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
      contact.points[k] = deepest;
      replaced = true;
    }
    if (!replaced) break;
  }
  contact.found = contact.points[0] >= 0 && contact.points[1] >= 0 && contact.points[2] >= 0;
  return contact;
}

namespace {

void addRest(const Strip& side, const Eigen::Isometry3d& plate_from_side, const Vector3d& centre,
             const Eigen::Isometry3d& front_from_back, const Vector3d& pivot, bool side_is_back,
             double widened, const ContactOptions& options, Evidence& evidence) {
  const Contact contact = restingFacet(side, plate_from_side, centre);
  if (!contact.found) return;
  for (int i : contact.points) {
    const Vector3d p_side = side.shell[i].cast<double>();
    const bool face = side.shell_inside[i] != 0;
    const double sigma = std::max(widened, face ? options.face_sigma_mm : options.edge_sigma_mm);
    const double gap = face ? options.face_gap_mm : options.edge_gap_mm;
    const double height = (plate_from_side * p_side).z() - gap;
    // Where the front stands on the back's plate, z_back = e_z . inv(T) p: moving the back by x
    // moves the front's point against it, so the derivative is that of -n . p, n = R e_z.
    const Vector3d n =
        side_is_back ? Vector3d::UnitZ() : Vector3d(-front_from_back.linear() * Vector3d::UnitZ());
    const Vector3d at = side_is_back ? plate_from_side * p_side : p_side;
    evidence.add(height / sigma, rowOf(at, n, pivot) / sigma);
  }
}

}  // namespace

Evidence contactEvidence(const Strip& front, const Strip& back,
                         const Eigen::Isometry3d& front_from_back, const Vector3d& pivot,
                         bool on_front, bool on_back, double widened,
                         const ContactOptions& options) {
  const Eigen::Isometry3d back_from_front = front_from_back.inverse();
  // The centre of mass of a sherd of even thickness: half way between its two faces.
  const Vector3d centre = 0.5 * (front.centre + front_from_back * back.centre);
  Evidence evidence;
  if (on_front)
    addRest(back, front_from_back, centre, front_from_back, pivot, true, widened, options,
            evidence);
  if (on_back)
    addRest(front, back_from_front, back_from_front * centre, front_from_back, pivot, false,
            widened, options, evidence);
  return evidence;
}

}  // namespace ostraka::registration
