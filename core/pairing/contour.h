#pragma once
#include <Eigen/Geometry>
#include <span>
#include <vector>

#include "base/result.h"
#include "scan/scan.h"

namespace ostraka::pairing {

/// The outline of a scan seen along an axis: closed, counter-clockwise seen from the tip of the
/// axis.
struct Contour {
  Eigen::Isometry3d plane_from_scan =
      Eigen::Isometry3d::Identity();    ///< z = axis, origin = centroid
  std::vector<Eigen::Vector2d> points;  ///< equal steps of arc length, mm, in the plane
  std::vector<double> heights;  ///< of the outermost surface at each point, along the axis, mm
  double perimeter_mm = 0;
  double area_mm2 = 0;
};

/// The outer alpha-shape contour (disc of radius alpha rolling outside, Edelsbrunner et al. 1983),
/// seen along `axis` (scan frame, unit), smoothed and resampled. Lone flying points are left aside.
/// Errors: NotEnough for fewer than 20 points or a contour that does not close.
Result<Contour> traceContour(const PointCloud& cloud, const Eigen::Vector3d& axis);

/// The area within a closed line; negative when it runs clockwise.
double signedArea(std::span<const Eigen::Vector2d> closed);

/// n points at equal steps of arc length of a closed line. n >= 3.
std::vector<Eigen::Vector2d> resampled(std::span<const Eigen::Vector2d> closed, int n);

/// The contour as seen from the other side: x mirrored, order reversed, so counter-clockwise again.
std::vector<Eigen::Vector2d> mirrored(std::span<const Eigen::Vector2d> closed);

}  // namespace ostraka::pairing
