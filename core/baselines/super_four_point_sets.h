#pragma once
#include <stop_token>

#include "base/result.h"
#include "baselines/pcl_methods.h"
#include "cloud/point_cloud.h"

namespace ostraka::baselines {

struct SuperFourPointOptions {
  double spacing_mm = 0.6;   ///< half of 4PCS's: pairs are found in time with their number
  double accuracy_mm = 0.5;  ///< delta: how far congruent points may lie off
  double overlap = 0.5;      ///< share of the back's points that must meet the front; also the
                             ///< longest side of a base, as a share of the back's diameter
  double max_normal_angle_deg = 45;  ///< by which normals may turn otherwise, and where points meet
  int samples = 300;                 ///< of the back, to test poses on
  int bases = 60;                    ///< quadruples that are tried, unless nearly all points meet
  int max_matches = 500;             ///< congruent quadruples that are tested for a base
};

/// Mellado, Aiger, Mitra: Super4PCS, SGP 2014, from the paper's description. Pairs as long as the
/// two segments of a base are found by spheres in cells that are halved as long as a sphere's shell
/// crosses them; congruent pairs of pairs by the cell in which their intersections fall, and by the
/// angle between them. Oriented points of both fracture strips, mm, each in the frame of its scan.
/// Needs no start; its pose is not refined. The same input gives the same pose. Errors: Cancelled,
/// NotEnough (as in pcl_methods.h), Failed (fewer than `overlap` meet). A second or two, 1 thread.
Result<Eigen::Isometry3d> superFourPointSets(const PointCloud& front, const PointCloud& back,
                                             const SuperFourPointOptions& options,
                                             std::stop_token stop);

}  // namespace ostraka::baselines
