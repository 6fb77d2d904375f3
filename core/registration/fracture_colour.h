#pragma once
#include <Eigen/Geometry>
#include <array>
#include <span>
#include <vector>

#include "cloud/point_cloud.h"
#include "registration/evidence.h"
#include "registration/strip.h"

namespace ostraka::registration {

/// Detail of the colours at the points of a strip: the local mean is removed, and each channel
/// (lightness, red against green and blue, green against blue) has SD 1. The two colour differences
/// are free of shading, the lightness is not. radius_mm: of the smoothing; detail up to six times
/// as long is kept. Empty without a colour per point. About 20 us a point at a spacing of 0.2 mm.
std::vector<ColourDetail> colourDetail(std::span<const Eigen::Vector3f> points,
                                       std::span<const Eigen::Vector3f> normals,
                                       std::span<const Color> colours, const KdTree& tree,
                                       double radius_mm);

struct ColourOptions {
  double reach_mm = 0.5;  ///< of closest pairs; the smoothed detail is linear about this far
  double min_cos = 0.7071;
  /// SD of a displacement common to all detail. Light from above brightens the upper slope of each
  /// grain in both shots, which moves its picture up in the front and down in the back: more
  /// where raised grains are lighter, too. At the true poses of 57 pairs 0.06 mm RMS in height,
  /// 0.02 in the plane. Tilt and turn are free of it.
  double displacement_mm = 0.08;
  double patch_mm = 3.0;  ///< detail is shorter than this; patches are independent
};

struct ColourFit {
  Evidence evidence;
  std::array<double, 3> correlation{};  ///< of the two sides' detail, per channel
  int pairs = 0;
  /// Of both sides showing the same detail, against two of which nothing is common; independent
  /// from patch to patch. 0 where too few pairs meet.
  double log_likelihood = 0;
};

/// Both sides photograph the same fracture: grains and stains of the clay must lie on each other.
/// This holds the pose along the surface, where point-to-plane distances do not: in height and tilt
/// where walls are steep, along the contour where it is smooth. Colored ICP (Park et al., ICCV
/// 2017) with the regression dilution of a noisy gradient taken into account. Without colours, or
/// where the two sides' detail does not correlate, the information is zero.
/// Without its evidence: how well the detail agrees.
ColourFit correlateColours(const StripLevel& front, const StripLevel& back,
                           const Eigen::Isometry3d& front_from_back, const ColourOptions& options);
ColourFit fitColours(const StripLevel& front, const StripLevel& back,
                     const Eigen::Isometry3d& front_from_back, const Eigen::Vector3d& pivot,
                     const ColourOptions& options);

}  // namespace ostraka::registration
