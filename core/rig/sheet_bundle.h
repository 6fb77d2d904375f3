#pragma once
#include <Eigen/Geometry>
#include <array>
#include <map>
#include <vector>

#include "rig/plate_markers.h"

namespace ostraka::rig {

/// Where a marker lies on a flat sheet: its middle, mm, and the turn of its top from +y.
using FlatMarker = std::array<double, 3>;  // x, y, radians counter-clockwise

/// Corners in OpenCV's order, mm.
std::array<Eigen::Vector2d, 4> cornersOf(const FlatMarker& marker, double side_mm);

/// A photograph of the sheet.
struct SheetView {
  int width = 0, height = 0;  ///< pixels; views of one size have one lens
  std::vector<SeenMarker> markers;
  Eigen::Isometry3d camera_from_sheet = Eigen::Isometry3d::Identity();
};

/// A sheet with its views: where to start, and what comes out.
struct SheetBundle {
  double side_mm = 0;
  double focal_px_per_width = 1;      ///< of the longer side, to start with
  std::map<int, FlatMarker> markers;  ///< by id
  std::vector<SheetView> views;       ///< with poses
};

struct SheetFit {
  bool converged = false;
  double rms_px = 0;
  std::map<int, double> marker_rms_px;
};

/// Moves markers and poses to where the corners are met best. For each size of photographs one lens
/// (focal length, principal point, k1, k2), whose focal length may differ from view to view by a
/// percent, as autofocus has it; one inset of all edges in pixels, since light spreads over black.
/// The first marker stays in its place.
SheetFit fitSheet(SheetBundle& sheet);

}  // namespace ostraka::rig
