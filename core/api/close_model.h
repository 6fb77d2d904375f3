#pragma once
#include <Eigen/Geometry>
#include <stop_token>

#include "base/progress.h"
#include "base/result.h"
#include "cloud/points_and_meshes.h"
#include "version.h"

namespace ostraka::api {

/// One whole sherd. Lengths in mm, frame of the front scan.
struct ClosedModel {
  TriangleMesh mesh;        ///< closed, manifold, faces outward; `seen` 0 where a gap was filled
  double filled_share = 0;  ///< of the surface that no scan saw, 0..1
  double noise_mm = 0;      ///< median scatter of the scans' points about the surface
  double length_mm = 0, width_mm = 0;  ///< of the smallest rectangle around the sherd
  double thickness_min_mm = 0, thickness_mean_mm = 0, thickness_max_mm = 0;  ///< 0: not measurable
  double area_mm2 = 0, volume_mm3 = 0;
};

/// Both sides of a sherd as one closed surface, with its measurements. front, back: at least some
/// thousand points with outward unit normals, mm; p_front = front_from_back * p_back.
/// threads: 0 for all processors; the result does not depend on it.
/// Errors: UnusableInput (no normals, a value that is not finite, scans that cannot be in mm, a
/// transform that is not rigid or leaves the scans apart), NotEnough (too few points, no
/// closed surface), Cancelled. About 1.5 s per 2000 mm^2 on one core for points 0.15 mm apart, 5 s
/// for points 0.08 mm apart.
OSTRAKA_API Result<ClosedModel> closeModel(const PointCloud& front, const PointCloud& back,
                                           const Eigen::Isometry3d& front_from_back, int threads,
                                           Progress& progress, std::stop_token stop);

}  // namespace ostraka::api
