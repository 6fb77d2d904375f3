#pragma once
#include <Eigen/Geometry>
#include <stop_token>
#include <vector>

#include "base/result.h"
#include "cloud/point_cloud.h"

namespace ostraka::model {

/// Points of both sides after smoothing, frame of the front scan, mm.
struct Surfels {
  std::vector<Eigen::Vector3f> points, normals;
  std::vector<float> noise;       ///< scatter of the scan's points about the surface here, mm
  std::vector<float> confidence;  ///< weight against the neighbours, in (0, 1]
  std::vector<float> area;        ///< share of the surface, mm^2
  double spacing_mm = 0;          ///< median distance between neighbours of one side
  double noise_mm = 0;            ///< median of noise
  double side_gap_mm = 0;  ///< median distance between the sides where both are; 0 when nowhere
  int dropped = 0;         ///< flying points left out

  std::size_t size() const { return points.size(); }
  /// Leaves only these, in this order; the others are counted as dropped.
  void keep(const std::vector<int>& indices);
};

/// Both scans in one frame, thinned to spacing_mm (0: ModelOptions says how), each
/// point moved onto a robust local fit of all points around it that face the same way, weighted by
/// each scan's own scatter there: a fat, noisy strip gives way to the other side's clean face, and
/// a broken edge is not smoothed over. Points that nothing around them supports are dropped.
/// Errors: Cancelled, NotEnough.
Result<Surfels> mergedSurfels(const PointCloud& front, const PointCloud& back,
                              const Eigen::Isometry3d& front_from_back, double spacing_mm,
                              int threads, std::stop_token stop);

}  // namespace ostraka::model
