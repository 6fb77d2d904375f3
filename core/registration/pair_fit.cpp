#include "registration/pair_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "registration/break_misfit.h"
#include "registration/fracture_colour.h"

namespace ostraka::registration {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double kCorrelationMm = 0.9;  // stereo's and scanners' noise is alike over a window
constexpr double kStartTurnRad = 0.06;  // outlines fix a start's tilt to a few degrees ...
constexpr double kStartShiftMm = 1.5;   // ... and its height to a third of a wall

// Fatness comes from windows that straddle depth steps and grows far faster than the noise: strips
// with 0.06 mm of noise are 0.01 mm fat, those of photographs with 0.12-0.16 mm more than 0.1.
double commonBias(double sigma_mm) {
  return std::clamp(0.015 * std::pow(sigma_mm / 0.1, 6), 0.004, 0.5);
}

// Strips of photographs sink, too: shading of fine relief that moves with the light, and hollows
// that hide behind it, leave up to 0.1 mm of height between the two sides, in pixels' widths of
// 0.24 mm.
constexpr double kSink_px = 0.2;

// The start itself is evidence: outlines were laid on each other to find it.
Evidence startEvidence(const FittedPose& pose, const Vector3d& at) {
  Evidence evidence;
  const Eigen::AngleAxisd off(
      Eigen::Matrix3d(pose.front_from_back.linear() * pose.begun.linear().transpose()));
  const Vector3d turned = off.angle() * off.axis();
  const Vector3d moved = at - pose.begun * (pose.front_from_back.inverse() * at);
  for (int k = 0; k < 3; ++k) {
    evidence.add(turned[k] / kStartTurnRad, Vector6::Unit(k) / kStartTurnRad);
    evidence.add(moved[k] / kStartShiftMm, Vector6::Unit(k + 3) / kStartShiftMm);
  }
  return evidence;
}

// Of the nearest camera, on the sherd; 0 without photographs.
double pixelMm(std::span<const SilhouetteView> views, const Vector3d& centre) {
  double least = 0;
  for (const SilhouetteView& view : views) {
    const double depth = (view.camera.camera_from_plate * centre).z();
    const double pixel = depth / view.camera.intrinsics.fx;
    if (pixel > 0 && (least == 0 || pixel < least)) least = pixel;
  }
  return least;
}

}  // namespace

PairFit::PairFit(const Strip& front, const Strip& back, const Constraints& constraints,
                 const RegistrationOptions& options)
    : front_(front), back_(back), constraints_(constraints), options_(options) {
  radius_mm_ = 0.5 * (front.radius_mm + back.radius_mm);
  spacing_mm_ = std::max(front.spacing_mm, back.spacing_mm);
  const double pixel_mm =
      std::max(pixelMm(constraints.front, front.centre), pixelMm(constraints.back, back.centre));
  if (pixel_mm > 0) contact_.grain_mm = std::max(spacing_mm_, pixel_mm);
  const double noise = std::max(front.noise_mm, back.noise_mm);
  last_radius_mm_ = std::max({options.last_radius_mm, 4.0 * noise, 0.9 * spacing_mm_});
}

Vector3d PairFit::pivot(const Isometry3d& pose) const {
  return 0.5 * (front_.centre + pose * back_.centre);
}

FractureFit PairFit::fracture(const FittedPose& pose, bool fine, double radius, double robust,
                              double sigma) const {
  const double spacing = fine ? spacing_mm_ : options_.strip.coarse_mm;
  FracturePairing pairing;
  pairing.radius_mm = radius;
  pairing.min_cos = std::cos(options_.max_normal_angle_rad);
  pairing.robust_mm = robust;
  pairing.sigma_mm = sigma;
  // Each pair is met from both sides, and neighbours err together.
  const double usual = std::max(1.0, std::pow(kCorrelationMm / std::max(spacing, 0.05), 2));
  pairing.correlated = 2 * (fine ? std::max(usual, pose.alike) : usual);
  pairing.bias_mm = fine ? std::max(commonBias(sigma), kSink_px * contact_.grain_mm) : 0.02;
  return fitFracture(fine ? front_.fine : front_.coarse, fine ? back_.fine : back_.coarse,
                     front_.up, pose.front_from_back, pivot(pose.front_from_back), radius_mm_,
                     pairing);
}

// One Gauss-Newton step on the gathered evidence; returns the RMS displacement in mm.
double PairFit::solve(FittedPose& pose, const Vector3d& at) const {
  Matrix6 damped = pose.evidence.information;
  damped.topLeftCorner<3, 3>().diagonal().array() += 1e-3 * radius_mm_ * radius_mm_;
  damped.bottomRightCorner<3, 3>().diagonal().array() += 1e-3;
  Vector6 x = -damped.ldlt().solve(pose.evidence.gradient);
  const double moved = std::sqrt(x.head<3>().squaredNorm() * radius_mm_ * radius_mm_ * 2.0 / 3.0 +
                                 x.tail<3>().squaredNorm());
  if (!std::isfinite(moved)) return 0;
  if (moved > 2.0) x *= 2.0 / moved;  // never farther than a wall's thickness at once
  pose.front_from_back = changed(pose.front_from_back, x, at);
  return moved;
}

void PairFit::coarse(FittedPose& pose) const {
  for (const double r : {1.0, 0.85, 0.7, 0.58, 0.48, 0.4, 0.35, 0.33}) {
    const double radius = options_.first_radius_mm * r;
    const Vector3d at = pivot(pose.front_from_back);
    pose.evidence = fracture(pose, false, radius, radius, 0.3 * radius).evidence;
    pose.evidence +=
        contactEvidence(front_, back_, pose.front_from_back, at, constraints_.front_support,
                        constraints_.back_support, 0.2 * radius, contact_);
    pose.evidence += startEvidence(pose, at);
    solve(pose, at);
  }
  pose.score = fracture(pose, false, 1.2, 0.6, 0.3).spread;
}

void PairFit::askConstraints(FittedPose& pose, double radius,
                             const SilhouetteConstraint* silhouettes, double reach_px) const {
  const Vector3d at = pivot(pose.front_from_back);
  const double robust = std::max(0.12, std::min(radius, 3.0 * pose.sigma_mm));
  const FractureFit strip = fracture(pose, true, radius, robust, pose.sigma_mm);
  const auto rest = [&](bool on_front) {
    return contactEvidence(front_, back_, pose.front_from_back, at,
                           on_front ? constraints_.front_support : std::nullopt,
                           on_front ? std::nullopt : constraints_.back_support, 0, contact_);
  };
  const Vector3d seen = (front_.up - pose.front_from_back.linear() * back_.up).normalized();
  std::array<Evidence, 6> said = {
      strip.evidence,
      rest(true),
      rest(false),
      fitOutlines(front_.all, back_.all, spacing_mm_, pose.front_from_back, seen, at).evidence,
      silhouettes == nullptr ? Evidence{}
                             : silhouettes->evidence(pose.front_from_back, at, reach_px).evidence,
      pose.alike > 0 ? fitColours(front_.fine, back_.fine, pose.front_from_back, at, {}).evidence
                     : Evidence{}};
  for (std::size_t k = 0; k < said.size(); ++k) pose.constraints[k].evidence = said[k];
  // Only at the end of the way: before, all are far off together.
  if (pose.settled) learnWeights(pose.constraints, startEvidence(pose, at).information);
  pose.evidence = together(pose.constraints);
  // Few pairs tell little of their own noise: half of what strips of photographs show is assumed.
  pose.sigma_mm = strip.pairs < 100 ? 0.15 : std::clamp(strip.sigma_mm, 0.02, 0.3);
  pose.fracture = strip;
}

double PairFit::fineRound(FittedPose& pose, double radius, const SilhouetteConstraint* silhouettes,
                          double reach_px) const {
  const Vector3d at = pivot(pose.front_from_back);
  askConstraints(pose, radius, silhouettes, reach_px);
  return solve(pose, at);
}

void PairFit::score(FittedPose& pose) const {
  const FractureFit whole = fracture(pose, true, 1.0, 0.5, std::max(0.03, pose.sigma_mm));
  pose.score = whole.spread;
  pose.fracture.rms_mm = whole.rms_mm;
  pose.fracture.overlap = whole.overlap;
  pose.fracture.pairs = whole.pairs;
}

void PairFit::fine(FittedPose& pose) const {
  double radius = 1.0;
  for (int round = 0; round < 30; ++round) {
    const double moved = fineRound(pose, radius, nullptr, 0);
    if (radius <= last_radius_mm_ && moved < 1e-3) break;  // 1/30 of what scans can tell
    radius = std::max(last_radius_mm_, radius * 0.75);
  }
  score(pose);
}

void PairFit::weighed(FittedPose& pose) const {
  pose.alike = breakMisfit(front_, back_, pose.front_from_back).alike;
  for (int round = 0; round < 10; ++round) {
    // Weights come from residuals, and a constraint that is new on the way has large ones.
    pose.settled = round >= 3;
    if (fineRound(pose, last_radius_mm_, nullptr, 0) < 1e-3 && pose.settled) break;
  }
  score(pose);
}

void PairFit::measure(FittedPose& pose) const {
  pose.alike = breakMisfit(front_, back_, pose.front_from_back).alike;
  for (const bool settled : {false, true}) {  // the strips' own noise first, then the weights
    pose.settled = settled;
    askConstraints(pose, last_radius_mm_, nullptr, 0);
  }
  score(pose);
}

void PairFit::withSilhouettes(FittedPose& pose, const SilhouetteConstraint& silhouettes) const {
  for (const double reach_px : {6.0, 4.5, 3.5, 3.0, 3.0, 3.0})
    if (fineRound(pose, last_radius_mm_, &silhouettes, reach_px) < 1e-3) break;
  score(pose);
}

// How fast the strip's gradient really grows. Closest pairs slide along with the pose, so it grows
// more slowly than the rows say, most of all in height, where walls are near vertical.
Matrix6 PairFit::stripStiffness(const FittedPose& pose) const {
  constexpr double kOffMm = 0.05;  // of the size of the errors
  const double robust = std::max(0.12, std::min(last_radius_mm_, 3.0 * pose.sigma_mm));
  const auto said = [&](const FittedPose& at) {
    return fracture(at, true, last_radius_mm_, robust, pose.sigma_mm).evidence;
  };
  const Evidence here = said(pose);
  Matrix6 stiffness;
  for (int k = 0; k < 6; ++k) {
    const double off = k < 3 ? kOffMm / std::max(1.0, radius_mm_) : kOffMm;
    FittedPose moved = pose;
    moved.front_from_back =
        changed(pose.front_from_back, off * Vector6::Unit(k), pivot(pose.front_from_back));
    stiffness.col(k) = (said(moved).gradient - here.gradient) / off;
  }
  // Between next to nothing and what the rows say, in each direction.
  const Matrix6 claimed = here.information + 1e-9 * Matrix6::Identity();
  const Eigen::LLT<Matrix6> root(claimed);
  const Matrix6 lower = root.matrixL();
  const Matrix6 half = root.matrixL().solve(0.5 * (stiffness + stiffness.transpose()));
  const Matrix6 relative = root.matrixL().solve(Matrix6(half.transpose()));
  const Eigen::SelfAdjointEigenSolver<Matrix6> own(0.5 * (relative + relative.transpose()));
  const Vector6 kept = own.eigenvalues().cwiseMax(0.05).cwiseMin(1.0);
  const Matrix6 turned = own.eigenvectors() * kept.asDiagonal() * own.eigenvectors().transpose();
  return lower * turned * lower.transpose();
}

// Where the gradient grows by H and scatters by I, the pose scatters by H^-1 I H^-1. Directions
// that no constraint holds are held by the start, from which the fit did not move there.
Matrix6 PairFit::covariance(const FittedPose& pose) const {
  const Matrix6 start = startEvidence(pose, pivot(pose.front_from_back)).information;
  const double apart = inconsistency(pose.constraints, start);
  const Matrix6 scatter = pose.evidence.information + start;
  // Strips of scanners hold what their rows say: errors are 0.6 to 0.9 of what is stated.
  if (contact_.grain_mm <= 0) return apart * apart * scatter.inverse();
  const Constraint& strip = pose.constraints[0];
  const Matrix6 soft =
      (scatter + strip.weight * (stripStiffness(pose) - strip.evidence.information)).inverse();
  return apart * apart * soft * scatter * soft.transpose();
}

double PairFit::uncertainty(const Matrix6& covariance) const {
  // RMS over points spread by the radius: each turn moves two of three coordinates. Beyond the
  // sherd's own size no pose is off: its outlines were laid on each other.
  return std::min(2 * radius_mm_, std::sqrt(covariance.bottomRightCorner<3, 3>().trace() +
                                            covariance.topLeftCorner<3, 3>().trace() * radius_mm_ *
                                                radius_mm_ * 2.0 / 3.0));
}

double PairFit::distance(const Isometry3d& a, const Isometry3d& b) const {
  const Isometry3d change = a.inverse() * b;
  const double turn = Eigen::AngleAxisd(change.linear()).angle();
  return std::sqrt((change * back_.centre - back_.centre).squaredNorm() +
                   2.0 / 3.0 * turn * turn * back_.radius_mm * back_.radius_mm);
}

}  // namespace ostraka::registration
