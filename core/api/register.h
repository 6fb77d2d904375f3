#pragma once
#include <Eigen/Geometry>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "cloud/points_and_meshes.h"
#include "version.h"

namespace ostraka::api {

/// A front and its back, registered along the fracture.
struct RegisteredPair {
  int front = 0, back = 0;  ///< indices of the scans handed in
  Eigen::Isometry3d front_from_back = Eigen::Isometry3d::Identity();  ///< p_front = T * p_back, mm
  double score = 0;  ///< probability that the pair and its pose are right, 0..1
  double fracture_rms_mm =
      0;  ///< of the two fractures on each other; 0: they could not be compared
  double fracture_overlap = 0;  ///< share of the fracture that met the other side, 0..1
  double uncertainty_mm = 0;    ///< of the pose, RMS over the back's points, one sigma
  bool ambiguous = false;       ///< a person must decide; do not use it unseen
  std::string reason;           ///< why, one sentence; empty where it is not ambiguous
};

struct RegisteredScans {
  std::vector<RegisteredPair> pairs;               ///< by front; each scan at most once
  std::vector<int> unpaired_front, unpaired_back;  ///< rising
};

/// Which back belongs to which front, and where: as `ostraka register`, which also leaves out
/// points at the origin and far from all others; here they count. A scan is one
/// sherd seen from one side: at least 100 points with outward normals, mm, any frame (points whose
/// normal has length 0 are left out); scans
/// that stand on z = 0 with their faces up help each other. One front and one back may be handed
/// in. threads: 0 for all processors; the result does not depend on it.
/// Errors: UnusableInput (a scan without normals or with a value that is not finite, scans not in
/// mm), NotEnough (no scan, or one with too few points), Cancelled. About 0.3 s for each pair that
/// could belong together, on one core.
OSTRAKA_API Result<RegisteredScans> registerScans(std::span<const PointCloud> fronts,
                                                  std::span<const PointCloud> backs, int threads,
                                                  Progress& progress, std::stop_token stop);

}  // namespace ostraka::api
