#pragma once
#include <Eigen/Geometry>
#include <array>

#include "registration/evidence.h"
#include "registration/strip.h"

namespace ostraka::registration {

struct ContactOptions {
  /// A scanned face stands on the plate to its noise (0.05 mm), the height offsets of both scans
  /// and what the search for the lowest points adds.
  double face_sigma_mm = 0.10, face_gap_mm = 0.04;
  /// A sherd that stands on its broken edge: the scan ends up to half a millimetre before it.
  double edge_sigma_mm = 0.20, edge_gap_mm = 0.20;
};

/// The three points of `side` on which it would rest on the plate z = 0: the facet of its lower
/// hull under the centre of mass, all in the plate's frame. found is false when the centre lies
/// outside the hull.
struct Contact {
  std::array<int, 3> points{};  ///< indices of Strip::shell
  bool found = false;
};

/// plate_from_side takes `side` into the other side's plate frame. centre: of mass, that frame.
Contact restingFacet(const Strip& side, const Eigen::Isometry3d& plate_from_side,
                     const Eigen::Vector3d& centre_plate);

/// Evidence of both rests about front_from_back: the back stands on the front's plate where
/// on_front, and the front on the back's plate where on_back.
Evidence contactEvidence(const Strip& front, const Strip& back,
                         const Eigen::Isometry3d& front_from_back, const Eigen::Vector3d& pivot,
                         bool on_front, bool on_back, double widened,
                         const ContactOptions& options);

}  // namespace ostraka::registration
