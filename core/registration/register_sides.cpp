#include "registration/register_sides.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "base/parallel.h"
#include "registration/contact.h"
#include "registration/rim_icp.h"

namespace ostraka::registration {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double kCorrelationMm = 0.9;  // stereo's and scanners' noise is alike over a window

struct Pose {
  Isometry3d front_from_back;
  int start = -1;
  RimFit rim;
  Evidence evidence;
  double score = 1e9;
};

class PairFit {
 public:
  PairFit(const Strip& front, const Strip& back, const Witnesses& witnesses,
          const RegistrationOptions& options)
      : front_(front), back_(back), witnesses_(witnesses), options_(options) {
    const double noise = std::max(front.noise_mm, back.noise_mm);
    bias_mm_ = std::max(0.02, 3.0 * (noise - 0.05));
    radius_ = 0.5 * (front.radius_mm + back.radius_mm);
  }

  Vector3d pivot(const Isometry3d& pose) const {
    return 0.5 * (front_.centre + pose * back_.centre);
  }

  double correlated(double spacing) const {
    return 2 * std::max(1.0, std::pow(kCorrelationMm / std::max(spacing, 0.05), 2));
  }

  // One Gauss-Newton step at this radius; returns the RMS displacement in mm.
  double step(Pose& pose, bool fine, double radius, double robust, double sigma) const {
    const StripLevel& f = fine ? front_.fine : front_.coarse;
    const StripLevel& b = fine ? back_.fine : back_.coarse;
    RimPairing pairing;
    pairing.radius_mm = radius;
    pairing.min_cos = std::cos(options_.max_normal_angle_rad);
    pairing.robust_mm = robust;
    pairing.sigma_mm = sigma;
    pairing.correlated = correlated(fine ? std::max(front_.spacing_mm, back_.spacing_mm) : 1.2);
    pairing.bias_mm = bias_mm_;
    const Vector3d at = pivot(pose.front_from_back);
    pose.rim = fitRim(f, b, front_.up, pose.front_from_back, at, radius_, pairing);
    pose.evidence = pose.rim.evidence;
    pose.evidence +=
        contactEvidence(front_, back_, pose.front_from_back, at, witnesses_.front_on_plate,
                        witnesses_.back_on_plate, fine ? 0.0 : 0.2 * radius, {});
    Matrix6 damped = pose.evidence.information;
    damped.topLeftCorner<3, 3>().diagonal().array() += 1e-3 * radius_ * radius_;
    damped.bottomRightCorner<3, 3>().diagonal().array() += 1e-3;
    Vector6 x = -damped.ldlt().solve(pose.evidence.gradient);
    const double moved =
        std::sqrt(x.head<3>().squaredNorm() * radius_ * radius_ * 0.67 + x.tail<3>().squaredNorm());
    if (moved > 2.0) x *= 2.0 / moved;  // never farther than a wall's thickness at once
    pose.front_from_back = changed(pose.front_from_back, x, at);
    return moved;
  }

  void coarse(Pose& pose) const {
    for (const double r : {1.0, 0.85, 0.7, 0.58, 0.48, 0.4, 0.35, 0.33}) {
      const double radius = options_.first_radius_mm * r;
      step(pose, false, radius, radius, 0.3 * radius);
    }
    Pose probe = pose;
    step(probe, false, 1.2, 0.6, 0.3);
    pose.score = probe.rim.spread;
  }

  void fine(Pose& pose) const {
    const double noise = std::max(front_.noise_mm, back_.noise_mm);
    const double last = std::max(
        {options_.last_radius_mm, 4.0 * noise, 0.9 * front_.spacing_mm, 0.9 * back_.spacing_mm});
    double sigma = 0.15, radius = 1.0;
    for (int round = 0; round < 30; ++round) {
      const double moved =
          step(pose, true, radius, std::max(0.12, std::min(radius, 3.0 * sigma)), sigma);
      sigma = std::clamp(pose.rim.sigma_mm, 0.02, 0.3);
      if (radius <= last && moved < 2e-4) break;
      radius = std::max(last, radius * 0.8);
    }
    Pose probe = pose;
    step(probe, true, 1.0, 0.5, std::max(0.03, sigma));
    pose.score = probe.rim.spread;
    pose.rim.rms_mm = probe.rim.rms_mm;
    pose.rim.overlap = probe.rim.overlap;
  }

  double uncertainty(const Evidence& evidence) const {
    Matrix6 damped = evidence.information;
    damped.diagonal().array() += 1e-9;
    const Matrix6 covariance = damped.inverse();
    // RMS over points spread by radius_: each turn moves two of three coordinates.
    return std::sqrt(covariance.bottomRightCorner<3, 3>().trace() +
                     covariance.topLeftCorner<3, 3>().trace() * radius_ * radius_ * 2.0 / 3.0);
  }

  double bias() const { return bias_mm_; }

 private:
  const Strip &front_, &back_;
  const Witnesses& witnesses_;
  const RegistrationOptions& options_;
  double bias_mm_ = 0, radius_ = 1;
};

double distanceOf(const Isometry3d& a, const Isometry3d& b, const Strip& back) {
  const Isometry3d change = a.inverse() * b;
  const double turn = Eigen::AngleAxisd(change.linear()).angle();
  return std::sqrt((change * back.centre - back.centre).squaredNorm() +
                   0.67 * turn * turn * back.radius_mm * back.radius_mm);
}

}  // namespace

Result<void> RegistrationOptions::check() const {
  if (auto ok = strip.check(); !ok) return ok;
  if (!(last_radius_mm > 0) || !(first_radius_mm >= last_radius_mm))
    return Error{ErrorCode::UnusableInput,
                 "Registration options: need 0 < last_radius_mm <= first_radius_mm.",
                 {}};
  if (!(max_normal_angle_rad > 0) || !(height_step_mm >= 0) || max_survivors < 1)
    return Error{ErrorCode::UnusableInput,
                 "Registration options: max_normal_angle_rad, height_step_mm or max_survivors is "
                 "out of range.",
                 {}};
  return {};
}

Result<Registration> registerSides(const Strip& front, const Strip& back,
                                   std::span<const Isometry3d> starts, const Witnesses& witnesses,
                                   const RegistrationOptions& options, Progress& progress,
                                   std::stop_token stop) {
  (void)progress;
  if (auto ok = options.check(); !ok) return ok.error();
  if (starts.empty())
    return Error{ErrorCode::NotEnough, "No start pose was given for the registration.", {}};
  const PairFit pair(front, back, witnesses, options);
  std::vector<Pose> poses;
  const bool grounded = witnesses.front_on_plate && witnesses.back_on_plate;
  for (int s = 0; s < static_cast<int>(starts.size()); ++s)
    for (const double h : {0.0, 1.0, -1.0}) {
      if (grounded && h != 0) continue;
      Pose pose{.front_from_back = starts[s], .start = s, .rim = {}, .evidence = {}};
      pose.front_from_back.pretranslate(h * options.height_step_mm * front.up);
      poses.push_back(pose);
    }
  parallelFor(poses.size(), options.threads, [&](std::size_t i) {
    if (!stop.stop_requested()) pair.coarse(poses[i]);
  });
  if (stop.stop_requested()) return Error::cancelled();
  std::stable_sort(poses.begin(), poses.end(),
                   [](const Pose& a, const Pose& b) { return a.score < b.score; });
  std::vector<Pose> survivors;
  for (const Pose& pose : poses) {
    const bool near = std::any_of(survivors.begin(), survivors.end(), [&](const Pose& other) {
      return distanceOf(pose.front_from_back, other.front_from_back, back) < 0.5;
    });
    if (!near && static_cast<int>(survivors.size()) < options.max_survivors)
      survivors.push_back(pose);
  }
  parallelFor(survivors.size(), options.threads, [&](std::size_t i) {
    if (!stop.stop_requested()) pair.fine(survivors[i]);
  });
  if (stop.stop_requested()) return Error::cancelled();
  std::stable_sort(survivors.begin(), survivors.end(),
                   [](const Pose& a, const Pose& b) { return a.score < b.score; });
  const Pose& best = survivors.front();
  Registration result;
  result.front_from_back = best.front_from_back;
  result.rim_rms_mm = best.rim.rms_mm;
  result.rim_overlap = best.rim.overlap;
  result.information = best.evidence.information;
  result.pivot = pair.pivot(best.front_from_back);
  result.uncertainty_mm = pair.uncertainty(best.evidence);
  result.start = best.start;
  return result;
}

Result<Registration> registerSides(const scan::Scan& front, const scan::Scan& back,
                                   std::span<const Isometry3d> starts, const Witnesses& witnesses,
                                   const RegistrationOptions& options, Progress& progress,
                                   std::stop_token stop) {
  auto front_strip = prepareStrip(front, options.strip);
  if (!front_strip) return front_strip.error();
  auto back_strip = prepareStrip(back, options.strip);
  if (!back_strip) return back_strip.error();
  return registerSides(*front_strip, *back_strip, starts, witnesses, options, progress, stop);
}

}  // namespace ostraka::registration
