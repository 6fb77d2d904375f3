#include "registration/fracture_icp.h"

#include <gtest/gtest.h>

#include "simulated_sherd.h"

namespace ostraka::registration {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

class FractureIcp : public testing::Test {
 protected:
  FractureIcp() {
    const SimulatedSherd sherd = simulatedSherd({.noise_mm = 0.0});
    truth = sherd.truth;
    front = std::move(*prepareStrip(sherd.front, {}));
    back = std::move(*prepareStrip(sherd.back, {}));
    pivot = front.centre;
  }
  FractureFit at(const Isometry3d& pose, double bias_mm) const {
    FracturePairing pairing;
    pairing.bias_mm = bias_mm;
    return fitFracture(front.fine, back.fine, front.up, pose, pivot, front.radius_mm, pairing);
  }
  Strip front, back;
  Isometry3d truth;
  Vector3d pivot;
};

TEST_F(FractureIcp, TheTruthFitsAndNothingPullsAtIt) {
  const FractureFit fit = at(truth, 0.02);
  // Points of both sides lie on the same grid of the wall: the fit is exact.
  EXPECT_LT(fit.sigma_mm, 0.01);
  EXPECT_GT(fit.overlap, 0.6);  // 2.6 of 3.8 mm of wall are seen by both
  const Vector6 x = fit.evidence.information.ldlt().solve(fit.evidence.gradient);
  EXPECT_LT(x.tail<3>().norm(), 0.05);
}

TEST_F(FractureIcp, AShiftIsFoundWithItsSign) {
  Isometry3d moved = truth;
  moved.pretranslate(Vector3d(0.2, 0, 0));
  const FractureFit fit = at(moved, 0.02);
  const Vector6 x = -fit.evidence.information.ldlt().solve(fit.evidence.gradient);
  EXPECT_NEAR(x[3], -0.2, 0.08);  // closest points see a part of a shift at once
}

TEST_F(FractureIcp, AnUnknownFatnessTakesHeightAndTiltOutOfTheEvidence) {
  const Matrix6 sure = at(truth, 1e-4).evidence.information;
  const Matrix6 unsure = at(truth, 10.0).evidence.information;
  EXPECT_LT(unsure(5, 5), 0.05 * sure(5, 5));
  EXPECT_GT(unsure(3, 3), 0.5 * sure(3, 3));  // sideways the fatness cancels
}

TEST_F(FractureIcp, PointsWithoutPartnerCountAsMisfit) {
  Isometry3d far = truth;
  far.pretranslate(Vector3d(0, 0, 100));
  const FractureFit fit = at(far, 0.02);
  EXPECT_EQ(fit.pairs, 0);
  EXPECT_DOUBLE_EQ(fit.spread, 1.0);
  EXPECT_DOUBLE_EQ(fit.overlap, 0.0);
}

}  // namespace
}  // namespace ostraka::registration
