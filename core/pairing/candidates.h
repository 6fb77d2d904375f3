#pragma once
#include <Eigen/Geometry>
#include <span>
#include <stop_token>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "pairing/contour.h"
#include "scan/scan.h"

namespace ostraka::pairing {

/// A pose to start the registration from. The tilt and the height come from the outlines' own
/// heights; they hold to a few degrees and to about a third of a wall.
struct StartPose {
  Eigen::Isometry3d front_from_back = Eigen::Isometry3d::Identity();
  double contour_rms_mm = 0;  ///< trimmed, both directions, after the planar alignment
  double log_likelihood = 0;  ///< ratio: these two outlines are one, against two sherds at random;
                              ///< 0 with Method::Paper, which knows none
  int shift = 0;              ///< start point on the back's contour, in 1/200 of its length
  double scale = 1;           ///< front size / back size; 1 unless CandidateOptions::scale is Free
};

struct PairCandidate {
  int front = 0, back = 0;        ///< indices of the scans handed in
  std::vector<StartPose> starts;  ///< best first, distinct; several for symmetric contours
  double log_likelihood = 0;      ///< of the best start
  double distance_rad = 0;        ///< of the turning angles; Method::Paper only
};

/// Paper: Wang et al., ICCV 2023, and nothing else: the turning angles of 200 samples of each
/// outline, summed up; the root mean square difference of a front's sums and a mirrored back's, the
/// least over all start points; each front has the back of the least such distance.
enum class Method { Default, Paper };
enum class Scale {
  Fixed,
  Free
};  ///< Free: sizes of the two sides do not compare (no known length)

struct CandidateOptions {
  Method method = Method::Default;
  Scale scale = Scale::Fixed;
  int max_starts = 8;   ///< per pair; the registration pays for each
  double reach = 25.0;  ///< pairs are left out when the best assignment that has them is
                        ///< this much less likely (logarithm) by the outlines alone
  int threads = 0;      ///< 0 = all
};

/// All pairs within reach (Method::Paper: for each front the nearest back, with the start point of
/// that distance), sorted by front, then back. Scans without a usable contour take no part
/// (a note says so). Errors: Cancelled, UnusableInput for options. About 2 ms a pair.
Result<std::vector<PairCandidate>> findCandidates(std::span<const scan::Scan> fronts,
                                                  std::span<const scan::Scan> backs,
                                                  const CandidateOptions& options,
                                                  Progress& progress, std::stop_token stop);

/// The start pose that lays one start point of the back's contour (`shift`, in 1/200 of its length,
/// any integer) on the front's: for stepping along the outline by hand, not aligned any further.
/// Traces both contours, about 50 ms. Errors: NotEnough without a usable contour.
Result<StartPose> startPoseAt(const scan::Scan& front, const scan::Scan& back, int shift);

}  // namespace ostraka::pairing
