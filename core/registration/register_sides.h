#pragma once
#include <Eigen/Geometry>
#include <map>
#include <span>
#include <stop_token>
#include <string>

#include "base/progress.h"
#include "base/result.h"
#include "registration/strip.h"
#include "rig/sheet_bend.h"

namespace ostraka::registration {

/// What is known beside the two scans.
struct Constraints {
  /// In the scans' own frames; may be empty. The registered sherd must fill the masks and stay
  /// inside.
  std::span<const SilhouetteView> front, back;
  rig::Support front_support, back_support;  ///< in the scans' own frames, z up
};

/// Default is ours because no library weighs the fracture, the rest on the plate, the silhouettes
/// and the colours together, nor says how far its pose can be trusted. The others are other
/// people's, asked with the same fracture strips; what they find is measured and checked as ours.
/// New ones go to the end: results keep the number.
enum class Method {
  Default,            ///< strip, rest on the plate and silhouettes in one estimate
  BilateralBoundary,  ///< the paper's BBICP, equation 2, point to point: in no library
  TrimmedIcp,         ///< from the starts, as GeneralizedIcp
  GeneralizedIcp,
  FeatureRansac,  ///< FPFH + RANSAC; this and all that follow ask no start
  FourPointSets,
  KeypointFourPointSets,
  FastGlobal,         ///< in no package of Debian 12
  SuperFourPointSets  ///< likewise
};
/// As options name them: "default", "bbicp", ...
const std::map<std::string, Method>& methodsByName();

struct RegistrationOptions {
  Method method = Method::Default;
  StripOptions strip;
  double first_radius_mm = 3.0;  ///< start poses hold to a third of a wall in height
  double last_radius_mm = 0.35;  ///< about one scan spacing; grows with the strips' own noise
  bool free_scale = false;       ///< of BilateralBoundary: the pair's own scale, found on the way
  double max_normal_angle_rad = 0.785;  ///< 45 degrees: beyond, it is another face
  double height_step_mm = 2.0;          ///< starts are also tried this much higher and lower
  int max_survivors = 3;                ///< starts that go on to the fine rounds
  int threads = 1;
};

/// Why a pose must not be believed, for programs; `reason` says it to people.
enum class FailedCheck {
  None,
  UpsideDown,        ///< both sides face the same way
  FacesCross,        ///< crossing_share
  NoSharedFracture,  ///< fracture_overlap
  FractureMisfits,   ///< fracture_rms_mm
  FractureLoose,     ///< uncertainty_mm
  RivalPlace,        ///< runner_up_mm
  OutlinesAlone      ///< the fractures could not be compared
};

/// Where the back belongs, and how far that can be trusted.
struct Registration {
  Eigen::Isometry3d front_from_back = Eigen::Isometry3d::Identity();
  double scale = 1;             ///< front size / back size: p_front = T (scale * p_back)
  double fracture_rms_mm = 0;   ///< normal-checked closest pairs of the strips, point to plane
  double fracture_overlap = 0;  ///< share of the strip points in reach that have a partner
  double misfit_mm = 0;         ///< how far the breaks differ, noise averaged away; 0: nothing met
  double misfit_places = 0;     ///< independent places that misfit_mm comes from
  double log_likelihood = 0;    ///< of the fractures being one against being two similar fractures
  /// Of front_from_back, for a small turn (rad) then shift (mm) in the front's frame about the
  /// strip's centre `pivot`; inverse covariance.
  Eigen::Matrix<double, 6, 6> information = Eigen::Matrix<double, 6, 6>::Zero();
  Eigen::Vector3d pivot = Eigen::Vector3d::Zero();
  double uncertainty_mm = 0;  ///< 1-sigma RMS displacement over the back scan's points
  double runner_up_gap = 0;   ///< log-likelihood above the best pose that differs; 1e9: none
  double runner_up_mm = 0;    ///< RMS distance to that pose over the back's points
  double crossing_share = 0;  ///< share of faces that lie behind the other side's face
  double thickness_mm = 0;    ///< median distance of the faces
  bool check_failed = false;  ///< the pose must not be believed
  FailedCheck failed_check = FailedCheck::None;  ///< why
  std::string reason;  ///< why the check failed, one sentence; empty otherwise
  int start = -1;      ///< index of the start it came from
};

/// Registers the strips of two scans that show the two sides of one sherd, prepared once with
/// prepareStrip(scan, options.strip, views of its side), from rough start poses (within about
/// 3 mm along the fracture and in height, and 5 degrees; where the contour does not tell how far
/// the back is turned, the colours of the strips do, from any turn).
/// Errors: Cancelled, UnusableInput (options), NotEnough (no start), Failed (a method but the
/// default did not converge). 0.3 s a pair, 1 thread; other methods up to 15 s.
Result<Registration> registerSides(const Strip& front, const Strip& back,
                                   std::span<const Eigen::Isometry3d> front_from_back_starts,
                                   const Constraints& constraints,
                                   const RegistrationOptions& options, Progress& progress,
                                   std::stop_token stop);

}  // namespace ostraka::registration
