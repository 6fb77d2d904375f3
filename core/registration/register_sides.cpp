#include "registration/register_sides.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "base/message.h"
#include "base/parallel.h"
#include "baselines/fast_global_registration.h"
#include "baselines/pcl_methods.h"
#include "baselines/super_four_point_sets.h"
#include "cloud/point_cloud.h"
#include "registration/bilateral_boundary_icp.h"
#include "registration/break_misfit.h"
#include "registration/fracture_colour.h"
#include "registration/pair_fit.h"
#include "registration/self_check.h"
#include "registration/turn_search.h"

namespace ostraka::registration {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double kNoPairLogLikelihood = -3.5;  // 1 to 30: photographs need not be asked
constexpr double kSamePoseMm = 0.5;            // poses nearer than this run into the same place

bool better(const FittedPose& a, const FittedPose& b) {
  return a.score < b.score;
}

std::vector<FittedPose> startPoses(const Strip& front, std::span<const Isometry3d> starts,
                                   const Constraints& constraints,
                                   const RegistrationOptions& options) {
  std::vector<FittedPose> poses;
  // On plates the rest tells the height; elsewhere the planes of two contours lie up to a wall's
  // thickness apart.
  const bool grounded = constraints.front_support && constraints.back_support;
  for (int s = 0; s < static_cast<int>(starts.size()); ++s)
    for (const double h : {0.0, 1.0, -1.0}) {
      if (grounded && h != 0) continue;
      FittedPose pose;
      pose.front_from_back = starts[static_cast<std::size_t>(s)];
      pose.front_from_back.pretranslate(h * options.height_step_mm * front.up);
      pose.begun = pose.front_from_back;
      pose.start = s;
      poses.push_back(pose);
    }
  return poses;
}

// Best first, no two alike.
std::vector<FittedPose> distinct(std::vector<FittedPose> poses, const PairFit& pair, int count) {
  std::stable_sort(poses.begin(), poses.end(), better);
  std::vector<FittedPose> kept;
  for (const FittedPose& pose : poses) {
    const bool near = std::any_of(kept.begin(), kept.end(), [&](const FittedPose& other) {
      return pair.distance(pose.front_from_back, other.front_from_back) < kSamePoseMm;
    });
    if (!near && static_cast<int>(kept.size()) < count) kept.push_back(pose);
  }
  return kept;
}

// Turned about the viewer's axis so that the fracture slides by +-1.5 and +-3 mm: a false valley of
// the relief lies about a wavelength of it away.
std::vector<FittedPose> alongTheFracture(const FittedPose& best, const PairFit& pair,
                                         const Strip& front) {
  std::vector<FittedPose> poses;
  const Vector3d at = pair.pivot(best.front_from_back);
  for (const double slide_mm : {1.5, -1.5, 3.0, -3.0}) {
    FittedPose pose;
    Vector6 x = Vector6::Zero();
    x.head<3>() = slide_mm / std::max(1.0, pair.radius()) * front.up;
    pose.front_from_back = pose.begun = changed(best.front_from_back, x, at);
    pose.start = best.start;
    poses.push_back(pose);
  }
  return poses;
}

double fracturesAreOne(const FittedPose& pose, const Strip& front, const Strip& back) {
  return fractureLogLikelihood(pose.fracture.rms_mm, std::hypot(front.noise_mm, back.noise_mm),
                               pose.fracture.pairs);
}

Registration reported(const FittedPose& best, const PairFit& pair, const Strip& front,
                      const Strip& back) {
  Registration found;
  found.front_from_back = best.front_from_back;
  found.fracture_rms_mm = best.fracture.rms_mm;
  found.fracture_overlap = best.fracture.overlap;
  const Matrix6 covariance = pair.covariance(best);
  found.information = covariance.inverse();
  found.pivot = pair.pivot(best.front_from_back);
  found.uncertainty_mm = pair.uncertainty(covariance);
  found.start = best.start;
  found.log_likelihood = fracturesAreOne(best, front, back);
  found.runner_up_gap = 1e9;
  return found;
}

// With how far the breaks differ there, and whether the pose can be believed.
Registration checked(Registration found, const Strip& front, const Strip& back) {
  const BreakMisfit misfit = breakMisfit(front, back, found.front_from_back);
  found.misfit_mm = misfit.rms_mm;
  found.misfit_places = misfit.places;
  checkRegistration(front, back, found);
  return found;
}

// The likelihood of a pose of the same pair, for comparing poses: points that do not fit cost as
// Tukey's weight has it, and 30 or so places along a fracture are independent.
double poseGap(const FittedPose& best, const FittedPose& other) {
  return 30.0 * std::log(std::max(other.score, 1e-6) / std::max(best.score, 1e-6));
}

// How much likelier the colours of the fracture make a pose.
double agreement(const Strip& front, const Strip& back, const FittedPose& pose) {
  return correlateColours(front.fine, back.fine, pose.front_from_back, {}).log_likelihood;
}

// By fit and colours together: a box fits as well when it is turned by half.
FittedPose likeliest(const std::vector<FittedPose>& poses, const Strip& front, const Strip& back) {
  std::size_t best = 0;
  double most = agreement(front, back, poses[0]);
  for (std::size_t k = 1; k < poses.size(); ++k) {
    const double colours = agreement(front, back, poses[k]);
    if (colours - most + poseGap(poses[k], poses[best]) <= 0) continue;
    best = k;
    most = colours;
  }
  return poses[best];
}

// What the contour leaves loose the colours may hold, at another turn. Where they do, the pose that
// was best so far becomes a rival.
void turnLoose(FittedPose& best, std::vector<FittedPose>& rivals, const Strip& front,
               const Strip& back, const PairFit& pair, int threads, const std::stop_token& stop) {
  std::optional<FittedPose> turned = turnByColours(best, front, back, pair, threads, stop);
  if (!turned) return;
  pair.weighed(*turned);
  const double likelier =
      agreement(front, back, *turned) - agreement(front, back, best) + poseGap(*turned, best);
  if (likelier <= 0) return;
  rivals.push_back(best);
  best = *turned;
}

// A pose of another people's method, and the start that it came from.
struct FoundPose {
  Isometry3d front_from_back;
  int start = 0;
  double scale = 1;
};

Result<FoundPose> byBoundaries(const Strip& front, const Strip& back,
                               std::span<const Isometry3d> starts,
                               const RegistrationOptions& options, std::stop_token stop) {
  BilateralBoundaryIcpOptions icp;
  icp.first_radius_mm = options.first_radius_mm;
  icp.free_scale = options.free_scale;
  std::optional<BilateralBoundaryFit> best;
  int best_start = -1;
  std::optional<Error> failure;
  for (const FittedPose& start : startPoses(front, starts, {}, options)) {
    const auto fit = bilateralBoundaryIcp(front, back, start.front_from_back, icp, stop);
    if (!fit) {
      if (fit.error().code == ErrorCode::Cancelled) return fit.error();
      failure = fit.error();
      continue;
    }
    const bool first =
        !best || fit->rms_mm * fit->rms_mm * best->pairs < best->rms_mm * best->rms_mm * fit->pairs;
    if (!first) continue;
    best = *fit;
    best_start = start.start;
  }
  if (!best) return *failure;
  return FoundPose{best->front_from_back, best_start, best->scale};
}

PointCloud fractureOf(const Strip& strip) {
  return {strip.fine.points, strip.fine.normals, {}, {}};
}

FittedPose measuredPose(const Isometry3d& front_from_back, int start, const PairFit& pair) {
  FittedPose pose;
  pose.front_from_back = pose.begun = front_from_back;
  pose.start = start;
  pair.measure(pose);
  return pose;
}

// ICPs go on from each start; of where they end, the place where most of the strips fit counts.
Result<FoundPose> byIcp(const Strip& front, const Strip& back, std::span<const Isometry3d> starts,
                        const Constraints& constraints, const PairFit& pair,
                        const RegistrationOptions& options, std::stop_token stop) {
  const auto method =
      options.method == Method::TrimmedIcp ? baselines::trimmedIcp : baselines::generalizedIcp;
  baselines::IcpOptions icp;
  icp.reach_mm = options.first_radius_mm;
  const PointCloud front_points = fractureOf(front), back_points = fractureOf(back);
  std::optional<FittedPose> best;
  std::optional<Error> failure;
  for (const FittedPose& start : startPoses(front, starts, constraints, options)) {
    const auto found = method(front_points, back_points, start.front_from_back, icp, stop);
    if (!found) {
      if (found.error().code == ErrorCode::Cancelled) return found.error();
      failure = found.error();
      continue;
    }
    const FittedPose pose = measuredPose(*found, start.start, pair);
    if (!best || better(pose, *best)) best = pose;
  }
  if (!best) return *failure;
  return FoundPose{best->front_from_back, best->start};
}

// The others ask no start; theirs is the nearest.
Result<FoundPose> byGlobalMethod(const Strip& front, const Strip& back,
                                 std::span<const Isometry3d> starts, const PairFit& pair,
                                 Method method, std::stop_token stop) {
  const PointCloud front_points = fractureOf(front), back_points = fractureOf(back);
  const auto found = [&]() -> Result<Isometry3d> {
    switch (method) {
      case Method::FeatureRansac:
        return baselines::featureRansac(front_points, back_points, {}, stop);
      case Method::FourPointSets:
        return baselines::fourPointSets(front_points, back_points, {}, stop);
      case Method::KeypointFourPointSets:
        return baselines::keypointFourPointSets(front_points, back_points,
                                                baselines::keypointDefaults(), stop);
      case Method::SuperFourPointSets:
        return baselines::superFourPointSets(front_points, back_points, {}, stop);
      default:
        return baselines::fastGlobalRegistration(front_points, back_points, {}, stop);
    }
  }();
  if (!found) return found.error();
  const auto nearest =
      std::min_element(starts.begin(), starts.end(), [&](const Isometry3d& a, const Isometry3d& b) {
        return pair.distance(*found, a) < pair.distance(*found, b);
      });
  return FoundPose{*found, static_cast<int>(nearest - starts.begin())};
}

// What other people's methods do not state about their pose (overlap, uncertainty, whether the
// faces cross) is measured as for our own.
Result<Registration> byOthers(const Strip& front, const Strip& back,
                              std::span<const Isometry3d> starts, const Constraints& constraints,
                              const RegistrationOptions& options, std::stop_token stop) {
  const PairFit pair(front, back, constraints, options);
  const Method method = options.method;
  const bool icp = method == Method::TrimmedIcp || method == Method::GeneralizedIcp;
  const Result<FoundPose> found =
      method == Method::BilateralBoundary ? byBoundaries(front, back, starts, options, stop)
      : icp ? byIcp(front, back, starts, constraints, pair, options, stop)
            : byGlobalMethod(front, back, starts, pair, method, stop);
  if (!found) return found.error();
  const auto measured = [&](const Strip& sized, const PairFit& sized_pair) {
    const FittedPose pose = measuredPose(found->front_from_back, found->start, sized_pair);
    Registration registration = checked(reported(pose, sized_pair, front, sized), front, sized);
    registration.scale = found->scale;
    return registration;
  };
  if (found->scale == 1) return measured(back, pair);
  const Strip sized = scaled(back, found->scale);
  return measured(sized, PairFit(front, sized, constraints, options));
}

}  // namespace

const std::map<std::string, Method>& methodsByName() {
  static const std::map<std::string, Method> kMethods = {{"default", Method::Default},
                                                         {"bbicp", Method::BilateralBoundary},
                                                         {"trimmed", Method::TrimmedIcp},
                                                         {"gicp", Method::GeneralizedIcp},
                                                         {"fpfh-ransac", Method::FeatureRansac},
                                                         {"4pcs", Method::FourPointSets},
                                                         {"k4pcs", Method::KeypointFourPointSets},
                                                         {"fgr", Method::FastGlobal},
                                                         {"super4pcs", Method::SuperFourPointSets}};
  return kMethods;
}

Result<Registration> registerSides(const Strip& front, const Strip& back,
                                   std::span<const Isometry3d> starts,
                                   const Constraints& constraints,
                                   const RegistrationOptions& options, Progress& progress,
                                   std::stop_token stop) {
  if (starts.empty())
    return Error::notEnough(message("No start pose was given for the registration."));
  if (options.method != Method::Default)
    return byOthers(front, back, starts, constraints, options, stop);
  const PairFit pair(front, back, constraints, options);
  std::vector<FittedPose> poses = startPoses(front, starts, constraints, options);
  const auto each = [&](std::vector<FittedPose>& list, void (PairFit::*fit)(FittedPose&) const) {
    parallelFor(list.size(), options.threads, [&](std::size_t i) {
      if (!stop.stop_requested()) (pair.*fit)(list[i]);
    });
  };
  progress.report(0, 3);
  each(poses, &PairFit::coarse);
  std::vector<FittedPose> survivors = distinct(std::move(poses), pair, options.max_survivors);
  each(survivors, &PairFit::fine);
  if (stop.stop_requested()) return Error::cancelled();
  progress.report(1, 3);
  std::stable_sort(survivors.begin(), survivors.end(), better);
  FittedPose best = survivors.front();

  std::vector<FittedPose> rivals = alongTheFracture(best, pair, front);
  each(rivals, &PairFit::coarse);
  rivals = distinct(std::move(rivals), pair, options.max_survivors);
  std::erase_if(rivals, [&](const FittedPose& rival) {
    return pair.distance(rival.front_from_back, best.front_from_back) < kSamePoseMm;
  });
  each(rivals, &PairFit::fine);
  if (stop.stop_requested()) return Error::cancelled();
  progress.report(2, 3);
  rivals.insert(rivals.end(), survivors.begin(), survivors.end());
  best = likeliest(rivals, front, back);

  pair.weighed(best);
  const bool hopeless = fracturesAreOne(best, front, back) < kNoPairLogLikelihood;
  const bool rivalled = std::any_of(rivals.begin(), rivals.end(), [&](const FittedPose& rival) {
    return pair.distance(rival.front_from_back, best.front_from_back) > kRivalMm &&
           poseGap(best, rival) < kRivalGap;
  });
  if (!hopeless && (rivalled || pair.uncertainty(pair.covariance(best)) > kLargestUncertaintyMm))
    turnLoose(best, rivals, front, back, pair, options.threads, stop);
  if (!hopeless && (!constraints.front.empty() || !constraints.back.empty())) {
    const SilhouetteConstraint silhouettes(front, back, constraints.front, constraints.back,
                                           best.front_from_back, options.threads);
    FittedPose refined = best;
    pair.withSilhouettes(refined, silhouettes);
    best = refined;
  }
  if (stop.stop_requested()) return Error::cancelled();
  Registration found = reported(best, pair, front, back);
  const double colours = agreement(front, back, best);
  for (const FittedPose& rival : rivals) {
    const double away = pair.distance(rival.front_from_back, best.front_from_back);
    if (away < kSamePoseMm) continue;
    const double gap = poseGap(best, rival) + colours - agreement(front, back, rival);
    if (gap >= found.runner_up_gap) continue;
    found.runner_up_gap = gap;
    found.runner_up_mm = away;
  }
  found = checked(std::move(found), front, back);
  progress.report(3, 3);
  return found;
}

}  // namespace ostraka::registration
