#pragma once
#include <Eigen/Core>
#include <vector>

#include "drawing/walls.h"

namespace ostraka::drawing {

/// The smoothest stretch of a sherd's edge: a lip is an arc of a circle, a break is not.
struct RimArc {
  std::vector<Eigen::Vector3d> points;  ///< middle of the lip, about 1 mm apart
  std::vector<Eigen::Vector3d> edge;    ///< of the whole sherd, closed; points begin at `start`
  std::size_t start = 0;
  double length_mm = 0;
  double rms_mm = 0;     ///< from the circle, in its plane and across
  double radius_mm = 0;  ///< of that circle; rough for short arcs
  /// What stretches of this length elsewhere on the edge scatter about their own circles, mm;
  /// median. Breaks: some tenths of a millimetre and more.
  double elsewhere_mm = 0;
};

/// Stretches that lie within 0.12, 0.2 and 0.3 mm of a circle whose plane stands across the sherd,
/// up to three of each, the longest first; they may overlap.
std::vector<RimArc> findRimArcs(const Walls& walls);

}  // namespace ostraka::drawing
