#pragma once
#include <Eigen/Geometry>
#include <optional>
#include <string>

#include "cloud/point_cloud.h"

namespace ostraka::bench {

/// Registrations of the Point Cloud Library on whole scans, for comparison: "trimmed" (ICP that
/// keeps the best half of the pairs), "gicp", both from `start`; "fpfh" (FPFH with RANSAC) and
/// "4pcs", which need no start. Nothing when the method is unknown or does not converge.
std::optional<Eigen::Isometry3d> registerByRival(const std::string& method, const PointCloud& front,
                                                 const PointCloud& back,
                                                 const Eigen::Isometry3d& start);

}  // namespace ostraka::bench
