#include "evaluate/pairs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "box.h"
#include "evaluate/samples.h"

namespace ostraka::evaluate {
namespace {

// A box sampled on its outside; every scan of these tests, in the front's frame.
PointCloud boxScan(bool normals) {
  PointCloud cloud;
  const SurfaceSamples samples = areaSamples(boxMesh(50, 40, 6), 0.5, 3);
  for (std::size_t i = 0; i < samples.points.size(); ++i) {
    cloud.points.push_back(samples.points[i].cast<float>());
    if (normals) cloud.normals.push_back(samples.normals[i].cast<float>());
  }
  return cloud;
}

Result<PointCloud> readBox(const std::string& file) {
  return boxScan(file.starts_with("front"));
}

PairsTruth truthOf(int pairs) {
  PairsTruth truth;
  truth.set = "boxes";
  for (int k = 0; k < pairs; ++k) {
    const std::string n = std::to_string(k);
    truth.pairs.push_back({"f" + n, "b" + n, "front/f" + n + ".ply", "back/b" + n + ".ply",
                           Eigen::Isometry3d::Identity()});
  }
  truth.unpaired_front = {"f9"};
  truth.unpaired_back = {"b9"};
  return truth;
}

Proposal perfect(const PairsTruth& truth) {
  Proposal proposal;
  for (const TruePair& pair : truth.pairs) {
    ProposedPair p;
    p.front = pair.front;
    p.back = pair.back;
    p.has_transform = true;
    p.front_from_back = pair.front_from_back;
    proposal.pairs.push_back(p);
  }
  proposal.unpaired_front = truth.unpaired_front;
  proposal.unpaired_back = truth.unpaired_back;
  return proposal;
}

PairsSummary judged(const Proposal& proposal, const PairsTruth& truth) {
  const auto evaluation = evaluatePairs(proposal, truth, readBox);
  EXPECT_TRUE(evaluation.has_value());
  return evaluation ? summarise({*evaluation}) : PairsSummary{};
}

TEST(EvaluatePairs, MeetsTheGoalsWithThePerfectAnswer) {
  const PairsTruth truth = truthOf(4);
  const PairsSummary sum = judged(perfect(truth), truth);
  EXPECT_EQ(sum.right, 4);
  EXPECT_EQ(sum.lone_right, 2);
  EXPECT_LT(sum.rms_max_mm, 1e-9);
  EXPECT_TRUE(sum.goals_met);
}

TEST(EvaluatePairs, CallsAWrongPairSilentOnlyWhenItIsNotFlagged) {
  const PairsTruth truth = truthOf(4);
  Proposal proposal = perfect(truth);
  std::swap(proposal.pairs[0].back, proposal.pairs[1].back);
  PairsSummary sum = judged(proposal, truth);
  EXPECT_EQ(sum.right, 2);
  EXPECT_EQ(sum.silent_errors, 2);
  EXPECT_FALSE(sum.goals_met);
  proposal.pairs[0].ambiguous = proposal.pairs[1].ambiguous = true;
  sum = judged(proposal, truth);
  EXPECT_EQ(sum.silent_errors, 0);
  EXPECT_EQ(sum.flagged_wrong, 2);
}

TEST(EvaluatePairs, CountsALoneScanThatWasGivenAPartner) {
  const PairsTruth truth = truthOf(4);
  Proposal proposal = perfect(truth);
  proposal.pairs[0].back = "b9";
  proposal.unpaired_back = {"b0"};
  const PairsSummary sum = judged(proposal, truth);
  EXPECT_EQ(sum.silent_errors, 1);
  EXPECT_EQ(sum.lone_right, 1);
}

TEST(EvaluatePairs, TellsMissedPairsFromForgottenScans) {
  const PairsTruth truth = truthOf(4);
  Proposal proposal = perfect(truth);
  proposal.pairs.erase(proposal.pairs.begin());
  PairsSummary sum = judged(proposal, truth);
  EXPECT_EQ(sum.missed, 1);
  EXPECT_EQ(sum.forgotten, 2);
  proposal.unpaired_front.push_back("f0");
  proposal.unpaired_back.push_back("b0");
  sum = judged(proposal, truth);
  EXPECT_EQ(sum.missed, 1);
  EXPECT_EQ(sum.forgotten, 0);
}

TEST(EvaluatePairs, CountsAMissingOrMirroredTransformAsInfinite) {
  const PairsTruth truth = truthOf(4);
  Proposal proposal = perfect(truth);
  proposal.pairs[0].has_transform = false;
  proposal.pairs[1].has_transform = false;
  proposal.pairs[1].transform_not_rigid = true;
  const PairsSummary sum = judged(proposal, truth);
  EXPECT_EQ(sum.not_registered, 2);
  EXPECT_TRUE(std::isinf(sum.rms_max_mm));
  EXPECT_DOUBLE_EQ(sum.share_within_0_10_percent, 50);
}

TEST(EvaluatePairs, RefusesUnknownScansAndScansInTwoPairs) {
  const PairsTruth truth = truthOf(2);
  Proposal proposal = perfect(truth);
  proposal.pairs[0].front = "f7";
  EXPECT_FALSE(evaluatePairs(proposal, truth, readBox).has_value());
  proposal = perfect(truth);
  proposal.pairs[1].back = "b0";
  EXPECT_FALSE(evaluatePairs(proposal, truth, readBox).has_value());
}

TEST(EvaluatePairs, JudgesBothFrontsOfABackThatTheyShareAndSaySo) {
  const PairsTruth truth = truthOf(2);
  Proposal proposal = perfect(truth);
  proposal.pairs[1].back = "b0";
  for (ProposedPair& pair : proposal.pairs) pair.ambiguous = true;
  const auto evaluation = evaluatePairs(proposal, truth, readBox);
  ASSERT_TRUE(evaluation.has_value()) << evaluation.error().sentence();
  EXPECT_TRUE(evaluation->verdicts.at(0).right);
  EXPECT_FALSE(evaluation->verdicts.at(1).right);
  EXPECT_FALSE(evaluation->verdicts.at(1).silent_error);
}

TEST(RegistrationError, IsTheShiftForAPureShift) {
  Eigen::Isometry3d found = Eigen::Isometry3d::Identity();
  found.translation() << 0.03, 0, 0.04;
  const RegistrationError error =
      registrationError(found, Eigen::Isometry3d::Identity(), boxScan(false), boxScan(true));
  EXPECT_NEAR(error.rms_mm, 0.05, 1e-12);
  EXPECT_NEAR(error.shift_mm, 0.05, 1e-12);
  EXPECT_NEAR(error.rotation_deg, 0, 1e-6);
  EXPECT_FALSE(error.slipped);
}

TEST(RegistrationError, CallsABoxTurnedInItsPlaneSlipped) {
  const Eigen::Vector3d middle(25, 20, 3);
  const double angle = std::numbers::pi / 180;
  Eigen::Isometry3d found = Eigen::Translation3d(middle) *
                            Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()) *
                            Eigen::Translation3d(-middle);
  const RegistrationError error =
      registrationError(found, Eigen::Isometry3d::Identity(), boxScan(false), boxScan(true));
  EXPECT_NEAR(error.rotation_deg, 1, 1e-9);
  ASSERT_TRUE(error.across_share.has_value());
  EXPECT_TRUE(error.slipped);
}

TEST(Summarise, TakesTheSmallestValueThatReachesTheShare) {
  PairsEvaluation set;
  set.true_pairs = 4;
  for (const double rms : {0.04, 0.01, 0.08, 0.20}) {
    PairVerdict verdict;
    verdict.right = true;
    verdict.transform = TransformState::Measured;
    verdict.error.rms_mm = rms;
    set.verdicts.push_back(verdict);
  }
  const PairsSummary sum = summarise({set});
  EXPECT_EQ(sum.rms_median_mm,
            0.04);  // the second of four reaches a half; no mean of 0.04 and 0.08
  EXPECT_EQ(sum.rms_p95_mm, 0.20);
  EXPECT_EQ(sum.share_within_0_10_percent, 75);
  EXPECT_EQ(sum.share_within_0_05_percent, 50);
}

}  // namespace
}  // namespace ostraka::evaluate
