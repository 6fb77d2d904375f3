#pragma once
#include <Eigen/Geometry>
#include <vector>

#include "virtualrig/sherd.h"
#include "virtualrig/simulate.h"

namespace ostraka::virtualrig {

/// Where each sherd lies: plate_from_model on either side.
struct Layout {
  std::vector<Eigen::Isometry3d> front, back;
};

/// Lays all sherds at rest inside the marker ring, at least 4 mm apart, and turns them over as a
/// hand would: about the plate's x axis, 3-11 mm and up to 30 degrees off. With scramble they
/// change places and turns at will; options.touching pairs lie against each other on both sides.
/// Errors: UnusableInput when they do not fit.
Result<Layout> layOut(const std::vector<VirtualSherd>& sherds, const SimulateOptions& options,
                      Random& random);

}  // namespace ostraka::virtualrig
