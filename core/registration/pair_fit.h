#pragma once
#include <Eigen/Geometry>
#include <array>

#include "registration/constraint.h"
#include "registration/contact.h"
#include "registration/fracture_icp.h"
#include "registration/outline.h"
#include "registration/register_sides.h"
#include "registration/silhouettes.h"

namespace ostraka::registration {

/// A pose on its way, with what the constraints last said about it.
struct FittedPose {
  Eigen::Isometry3d front_from_back = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d begun = Eigen::Isometry3d::Identity();
  int start = -1;
  FractureFit fracture;  ///< rms and overlap within 1 mm once fine() has run
  Evidence evidence;     ///< of all constraints together
  /// Strip, rest of the back, rest of the front, outline, photographs, colours of the fracture.
  std::array<Constraint, 6> constraints;
  double sigma_mm = 0.15;  ///< of one pair of strip points
  double alike = 0;        ///< strip points that err together; 0: as many as a good scanner's
  bool settled = false;    ///< weights of the constraints follow their residuals
  double score = 1e9;      ///< share of strip points that do not fit, lower is better
};

/// The joint estimate of one pair of strips: strip, outline, rest on the plate, photographs.
class PairFit {
 public:
  PairFit(const Strip& front, const Strip& back, const Constraints& constraints,
          const RegistrationOptions& options);

  /// Eight rounds on the thinned strips, radius 3 to 1 mm; the start itself counts as evidence.
  void coarse(FittedPose& pose) const;
  /// All points, radius 1 mm down to one scan spacing, until nothing moves; at most 30 rounds.
  void fine(FittedPose& pose) const;
  /// Goes on from fine() with the weight that the strips' own misfit gives them.
  void weighed(FittedPose& pose) const;
  /// Goes on from weighed() with the photographs' outlines.
  void withSilhouettes(FittedPose& pose, const SilhouetteConstraint& silhouettes) const;

  /// What is known of a pose that another method found: as weighed(), but nothing moves.
  void measure(FittedPose& pose) const;

  /// Of a small change of the pose about its pivot, once weighed() or measure() has run.
  Matrix6 covariance(const FittedPose& pose) const;
  /// 1-sigma RMS displacement over the sherd.
  double uncertainty(const Matrix6& covariance) const;
  /// RMS displacement of the back between two poses.
  double distance(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) const;
  Eigen::Vector3d pivot(const Eigen::Isometry3d& pose) const;
  double radius() const { return radius_mm_; }
  double coarseMm() const { return options_.strip.coarse_mm; }  ///< spacing of the coarse strips

 private:
  double solve(FittedPose& pose, const Eigen::Vector3d& at) const;
  FractureFit fracture(const FittedPose& pose, bool fine, double radius, double robust,
                       double sigma) const;
  void askConstraints(FittedPose& pose, double radius, const SilhouetteConstraint* silhouettes,
                      double reach_px) const;
  double fineRound(FittedPose& pose, double radius, const SilhouetteConstraint* silhouettes,
                   double reach_px) const;
  void score(FittedPose& pose) const;
  Matrix6 stripStiffness(const FittedPose& pose) const;

  const Strip &front_, &back_;
  const Constraints& constraints_;
  const RegistrationOptions& options_;
  ContactOptions contact_;
  double radius_mm_ = 1, last_radius_mm_ = 0.35, spacing_mm_ = 0.4;
};

}  // namespace ostraka::registration
