#pragma once
#include <stop_token>

#include "base/result.h"
#include "baselines/pcl_methods.h"
#include "cloud/point_cloud.h"

namespace ostraka::baselines {

struct FastGlobalOptions {
  double spacing_mm = 0.6;         ///< points are thinned to this
  double feature_radius_mm = 6.0;  ///< as FeatureRansacOptions
  double edge_similarity = 0.9;    ///< tau: of the edges of three pairs that are drawn together
  int max_tuples = 1000;           ///< of three pairs, as in the authors' program
  int draws_per_pair = 100;        ///< tries for these, likewise
  double division = 1.4;           ///< of mu, every four rounds, likewise
  double inlier_mm = 0.8;          ///< delta: where mu ends; about the spacing
  int fewest_pairs = 30;           ///< ten triangles that agree by chance are none
};

/// Zhou, Park, Koltun: Fast Global Registration, ECCV 2016, on the FPFH of PCL: mutually nearest
/// features whose triangles are alike, then one robust estimate (Geman-McClure, its scale mu
/// lowered from the squared diameter to delta^2). Oriented points of both fracture strips, mm, each
/// in the frame of its scan. Needs no start. The same input gives the same pose. Errors: Cancelled,
/// NotEnough (as in pcl_methods.h), Failed (fewer than fewest_pairs after the test of triangles, or
/// within inlier_mm at the end).
Result<Eigen::Isometry3d> fastGlobalRegistration(const PointCloud& front, const PointCloud& back,
                                                 const FastGlobalOptions& options,
                                                 std::stop_token stop);

}  // namespace ostraka::baselines
