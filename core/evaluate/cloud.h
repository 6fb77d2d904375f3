#pragma once
#include <optional>
#include <span>

#include "base/result.h"
#include "cloud/point_cloud.h"

namespace ostraka::evaluate {

/// Points on one part of the surface against the truth; figures are absent where there is nothing.
struct PartFigures {
  std::size_t points = 0;
  std::optional<double> bias_mm;          ///< median signed distance, outside positive
  std::optional<double> sd_mm;            ///< 1.4826 x median deviation from the bias
  std::optional<double> within_90_mm;     ///< 90th percentile of the unsigned distance
  std::optional<double> normal_deg;       ///< median angle between the normals
  std::optional<double> covered_percent;  ///< share of the truth within 0.25 mm of the cloud
};

struct CloudFigures {
  std::size_t points = 0;      ///< evaluated: at most 200 000
  double outlier_percent = 0;  ///< farther than 2 mm from every sherd
  PartFigures flat;            ///< true normal's z > 0.8
  PartFigures strip;           ///< |z| < 0.5, the broken edge; covered_percent only above z = 1 mm
  bool goals_met = false;
};

struct CloudOptions {
  int threads = 0;  ///< <= 0: all available
};

/// One side's oriented points against all true sherds, both in that side's plate frame. Each point
/// goes to its nearest truth sample (0.15 mm apart); its distance is measured along that sample's
/// normal. Errors: no normals, no point within 2 mm of the truth, a truth without faces.
Result<CloudFigures> evaluateCloud(const PointCloud& cloud, std::span<const TriangleMesh> truth,
                                   const CloudOptions& options);

}  // namespace ostraka::evaluate
