#pragma once
#include <opencv2/core.hpp>
#include <vector>

#include "cloud/point_cloud.h"

namespace ostraka::scan {

constexpr double kPlanCell_mm = 0.5;  ///< two points of a scan, so that a plan has no holes

/// A piece seen from above in cells of kPlanCell_mm: 255 where it is, with a free border.
struct Plan {
  cv::Mat1b filled;
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();  ///< plate, mm, of the cell (0, 0)'s corner
  cv::Point cellOf(const Eigen::Vector3f& p) const;
};

/// The surface seen from above, in the cells of a plan: height in mm, NaN where no point lies, and
/// mean normal of what lies within 0.5 mm below the highest point.
struct SeenSurface {
  cv::Mat1f height_mm;
  cv::Mat3f normal;
};
SeenSurface surfaceFromAbove(const PointCloud& piece, const Plan& plan);

/// Each cell of the plan goes to the core (1 ..., 0 elsewhere) from which it is reached first; ways
/// over a step or a kink of the surface are long, so that parts meet where the surface breaks off.
/// surface: none (empty) makes all ways alike.
cv::Mat1i partsReached(const Plan& plan, const cv::Mat1i& cores, const SeenSurface* surface);

/// Cells of part a that meet part b.
std::vector<cv::Point> seamBetween(const cv::Mat1i& parts, int a, int b);

/// Share of the line between parts a and b along which the surface breaks off: planes fitted to
/// both sides within 4 mm differ in height by 0.6 mm or in direction by 20 degrees, or a groove of
/// 0.6 mm lies between them. 1 where they do not meet, 0 where nothing can be said.
double brokenShare(const cv::Mat1i& parts, int a, int b, const SeenSurface& surface);

}  // namespace ostraka::scan
