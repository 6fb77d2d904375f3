#pragma once
#include <Eigen/Geometry>
#include <vector>

#include "vessels/sherd.h"
#include "virtualrig/simulate.h"

namespace ostraka::virtualrig {

/// Where each sherd lies: plate_from_model on either side.
struct Layout {
  std::vector<Eigen::Isometry3d> front, back;
};

/// Where sherds may lie: what is in the disc as well as in the rectangle.
struct FreeArea {
  double radius = 124;  ///< mm from the middle: the markers' paper begins at 129
  Eigen::Vector2d half = Eigen::Vector2d::Constant(124);
  bool holds(const Eigen::Vector2d& p) const {
    return p.norm() <= radius && (p.cwiseAbs().array() <= half.array()).all();
  }
  double area() const;  ///< mm^2
};
FreeArea freeArea(const SimulateOptions& options);

/// Lays all sherds at rest inside of the markers, at least 4 mm apart, and turns them over as a
/// hand would: about the plate's x axis, 3-11 mm and up to 30 degrees off. With scramble, and by
/// hand over a sheet, they change places and turns at will; options.touching pairs lie against each
/// other on both sides. Errors: UnusableInput when they do not fit.
Result<Layout> layOut(const std::vector<vessels::VirtualSherd>& sherds,
                      const SimulateOptions& options, vessels::Random& random);

}  // namespace ostraka::virtualrig
