#pragma once
#include <Eigen/Geometry>
#include <array>

#include "registration/evidence.h"
#include "registration/strip.h"
#include "rig/sheet_bend.h"

namespace ostraka::registration {

/// What is known of a point of rest. Height errors come from three things: what a scan resolves
/// (near an edge it ends up to a grain before the corner that stands on the plate), noise, and what
/// all three points share (the plates' and the scans' own height). A bent sheet gives way under the
/// sherd besides, by a share of its rise that nobody has seen: it is taken for unbent by weight,
/// and that share, as likely any from 0 to 1, for its error.
struct ContactOptions {
  /// The scans' spacing or a pixel on the sherd, whichever is larger. 0: not known, as of scans
  /// without photographs, whose points may have been thinned; then what scanners show counts.
  double grain_mm = 0;
  /// A smooth face that lies on the plate; both in grains: noise averaged over a millimetre.
  double face_sigma = 0.15;
  /// A corner or an edge: a third of a grain above the plate, more where the face is steep there.
  double edge_sigma = 0.6, edge_gap = 0.3;
  /// Common to a side's three points: measured -0.03, +0.03 and +0.09 mm on three kinds of scans.
  double plate_sigma_mm = 0.06, plate_gap_mm = 0.03;
  /// Of scans whose grain is not known, all in one.
  double scanned_face_sigma_mm = 0.10, scanned_face_gap_mm = 0.04;
  double scanned_edge_sigma_mm = 0.20, scanned_edge_gap_mm = 0.20;
};

/// The three points of `side` on which it would rest on the ground: the facet of its lower hull,
/// as seen from the ground, under the centre of mass, all in the plate's frame. What leans by more
/// than 60 degrees from the plate stands on nothing: it is a skirt that stereo hangs on walls.
/// found is false when the centre lies outside the hull.
struct Contact {
  std::array<int, 3> points{};  ///< indices of Strip::shell
  bool found = false;
};

/// plate_from_side takes `side` into the other side's plate frame. centre: of mass, that frame.
Contact restingFacet(const Strip& side, const Eigen::Isometry3d& plate_from_side,
                     const Eigen::Vector3d& centre_plate, const rig::SheetBend& ground);

/// Evidence of both rests about front_from_back: the back stands on the fronts' ground, and the
/// front on the backs', where they are known.
Evidence contactEvidence(const Strip& front, const Strip& back,
                         const Eigen::Isometry3d& front_from_back, const Eigen::Vector3d& pivot,
                         const rig::Support& front_support, const rig::Support& back_support,
                         double widened, const ContactOptions& options);

}  // namespace ostraka::registration
