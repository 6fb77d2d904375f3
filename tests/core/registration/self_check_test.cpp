#include "registration/self_check.h"

#include <gtest/gtest.h>

#include "simulated_sherd.h"

namespace ostraka::registration {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

class SelfCheck : public testing::Test {
 protected:
  SelfCheck() {
    const SimulatedSherd sherd = simulatedSherd({});
    front = std::move(*prepareStrip(sherd.front, {}));
    back = std::move(*prepareStrip(sherd.back, {}));
    good.front_from_back = truth = sherd.truth;
    good.fracture_rms_mm = 0.08;
    good.fracture_overlap = 0.8;
    good.uncertainty_mm = 0.03;
    good.runner_up_gap = 1e9;
  }
  Registration judged(Registration r) const {
    checkRegistration(front, back, r);
    return r;
  }
  Strip front, back;
  Isometry3d truth;
  Registration good;
};

TEST_F(SelfCheck, AGoodRegistrationPasses) {
  const Registration r = judged(good);
  EXPECT_FALSE(r.check_failed) << r.reason;
  EXPECT_NEAR(r.thickness_mm, 5.0, 0.05);
  EXPECT_EQ(r.crossing_share, 0.0);
}

TEST_F(SelfCheck, FacesThatCrossAreFlagged) {
  Registration r = good;
  r.front_from_back.pretranslate(Vector3d(0, 0, 6));
  r = judged(r);
  EXPECT_TRUE(r.check_failed);
  EXPECT_GT(r.crossing_share, 0.95);
}

TEST_F(SelfCheck, UpsideDownIsFlagged) {
  Registration r = good;
  r.front_from_back.rotate(Eigen::AngleAxisd(3.14159265, Vector3d::UnitX()));
  EXPECT_TRUE(judged(r).check_failed);
}

TEST_F(SelfCheck, APoseThatTheFractureHardlyFixesIsFlagged) {
  Registration r = good;
  r.uncertainty_mm = 1.0;
  EXPECT_TRUE(judged(r).check_failed);
  r = good;
  r.runner_up_gap = 0.1;
  r.runner_up_mm = 2;
  EXPECT_TRUE(judged(r).check_failed);
  r = good;
  r.fracture_overlap = 0;
  EXPECT_TRUE(judged(r).check_failed);
}

// Such a pair may well be right, but not without a word of how little holds it.
TEST_F(SelfCheck, APairThatSharesLittleOfItsBrokenEdgeIsFlaggedWithTheShare) {
  Registration r = good;
  r.fracture_overlap = 0.15;
  r = judged(r);
  EXPECT_TRUE(r.check_failed);
  EXPECT_EQ(r.failed_check, FailedCheck::NoSharedFracture);
  EXPECT_EQ(r.reason, "The two scans share only 15 % of the fracture.");
  r = good;
  r.fracture_overlap = 0.25;
  EXPECT_FALSE(judged(r).check_failed) << r.reason;
}

TEST(FractureLikelihood, TellsTruePairsFromLookAlikesOnCleanScans) {
  // The figures of the clean sets: true pairs up to 0.13 mm, false ones from 0.31 mm.
  EXPECT_GT(fractureLogLikelihood(0.13, 0.09, 5000), 3.0);
  EXPECT_LT(fractureLogLikelihood(0.31, 0.09, 5000), -1.5);
  EXPECT_GT(fractureLogLikelihood(0.10, 0.07, 5000), fractureLogLikelihood(0.15, 0.07, 5000));
}

TEST(FractureLikelihood, SaysLittleWhenFewPairsMeet) {
  EXPECT_NEAR(fractureLogLikelihood(0.10, 0.07, 0), 0.0, 1e-12);
}

}  // namespace
}  // namespace ostraka::registration
