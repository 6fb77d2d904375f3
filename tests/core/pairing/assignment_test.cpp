#include "pairing/assignment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

namespace ostraka::pairing {
namespace {

Evidence pair(int front, int back, double log_likelihood) {
  Evidence e;
  e.front = front, e.back = back, e.log_likelihood = log_likelihood;
  return e;
}

TEST(AssignPairs, TakesTheBestTotalNotTheBestPair) {
  // 10 + 1 = 11 loses against 9 + 8 = 17.
  const std::vector<Evidence> evidence = {pair(0, 0, 10), pair(0, 1, 9), pair(1, 0, 8),
                                          pair(1, 1, 1)};
  const auto found = assignPairs(evidence, 2, 2, {});
  ASSERT_TRUE(found.has_value());
  ASSERT_EQ(found->pairs.size(), 2u);
  EXPECT_EQ(found->pairs[0].back, 1);
  EXPECT_EQ(found->pairs[1].back, 0);
  // The only rival is the swap, 6 below: 1 / (1 + e^-6), by hand.
  EXPECT_NEAR(*found->pairs[0].score, 1 / (1 + std::exp(-6)), 1e-3);
}

TEST(AssignPairs, LeavesScansAloneThatFitNobody) {
  const std::vector<Evidence> evidence = {pair(0, 0, 20), pair(1, 0, 5), pair(1, 1, -8),
                                          pair(2, 1, -9)};
  const auto found = assignPairs(evidence, 3, 2, {});
  ASSERT_TRUE(found.has_value());
  ASSERT_EQ(found->pairs.size(), 1u);
  EXPECT_FALSE(found->pairs[0].ambiguous());
  EXPECT_EQ(found->unpaired_front, (std::vector<int>{1, 2}));
  EXPECT_EQ(found->unpaired_back, (std::vector<int>{1}));
}

TEST(AssignPairs, AsksAboutTwoScansThatWouldBothStayAlone) {
  std::vector<Evidence> evidence = {pair(0, 1, 20), pair(1, 0, -1.3), pair(1, 2, -1.9),
                                    pair(2, 2, -2)};
  const auto found = assignPairs(evidence, 3, 3, {});
  ASSERT_EQ(found->pairs.size(), 3u);
  EXPECT_FALSE(found->pairs[0].ambiguous());
  EXPECT_EQ(found->pairs[1].back, 0) << "the likelier of two";
  EXPECT_EQ(found->pairs[2].back, 2);
  for (const int k : {1, 2}) EXPECT_TRUE(found->pairs[k].ambiguous()) << k;
  EXPECT_LT(*found->pairs[1].score, 0.5) << "less than even odds, and said so";
  EXPECT_TRUE(found->unpaired_front.empty());
  EXPECT_TRUE(found->unpaired_back.empty());
  evidence[1].check_failed = true;  // an error that the registration itself has seen is no question
  EXPECT_EQ(assignPairs(evidence, 3, 3, {})->unpaired_back, std::vector<int>{0});
  EXPECT_EQ(assignPairs({{pair(0, 0, -2.3)}}, 1, 1, {})->pairs.size(), 0u) << "one in ten, no less";
}

TEST(AssignPairs, FlagsAPairThatAnotherPartnerExplainsNearlyAsWell) {
  const std::vector<Evidence> evidence = {pair(0, 0, 20), pair(0, 1, 19)};
  const auto found = assignPairs(evidence, 1, 2, {});
  ASSERT_EQ(found->pairs.size(), 1u);
  EXPECT_TRUE(found->pairs[0].ambiguous());
  EXPECT_NEAR(*found->pairs[0].score, 1 / (1 + std::exp(-1)), 1e-6);
  ASSERT_EQ(found->pairs[0].alternatives.size(), 1u);
  EXPECT_EQ(found->pairs[0].alternatives[0].back, 1);
  EXPECT_NEAR(found->pairs[0].alternatives[0].score, 1 / (1 + std::exp(1)), 1e-6);
}

TEST(AssignPairs, FlagsAPairWhoseSecondPoseFitsNearlyAsWell) {
  std::vector<Evidence> evidence = {pair(0, 0, 20)};
  evidence[0].runner_up_start_log_likelihood = 18;
  EXPECT_TRUE(assignPairs(evidence, 1, 1, {})->pairs[0].ambiguous());
  evidence[0].runner_up_start_log_likelihood = 10;
  EXPECT_FALSE(assignPairs(evidence, 1, 1, {})->pairs[0].ambiguous());
}

// A sentence that contradicts the probability beside it helps nobody.
TEST(AssignPairs, GivesAReasonThatFitsTheProbability) {
  const auto doubt = [](double own, double rival, double other_pose) {
    std::vector<Evidence> evidence = {pair(0, 0, own), pair(0, 1, rival)};
    evidence[0].runner_up_start_log_likelihood = other_pose;
    return assignPairs(evidence, 1, 2, {})->pairs.at(0).doubt;
  };
  const double no = -1e9;
  EXPECT_EQ(doubt(20, no, no), Doubt::None);
  // Both sides alone is the rival: 1 / (1 + e^-4) is 98 %.
  EXPECT_EQ(doubt(4, no, no), Doubt::NotSure);
  EXPECT_EQ(doubt(0.4, no, no), Doubt::Unrelated) << "60 %";
  EXPECT_EQ(doubt(20, 16, no), Doubt::NotSure) << "98 %";
  EXPECT_EQ(doubt(20, 19, no), Doubt::OtherPartner) << "73 %";
  EXPECT_EQ(doubt(20, no, 16), Doubt::NotSure) << "98 %";
  EXPECT_EQ(doubt(20, no, 19), Doubt::OtherPose) << "73 %";
}

TEST(AssignPairs, FlagsASlippedPair) {
  std::vector<Evidence> evidence = {pair(0, 0, 20)};
  evidence[0].check_failed = true;
  EXPECT_TRUE(assignPairs(evidence, 1, 1, {})->pairs[0].ambiguous());
}

TEST(AssignPairs, DoesNotDependOnTheOrderOfTheScans) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> figure(-5, 15);
  std::vector<Evidence> evidence, renamed;
  const std::vector<int> front = {3, 1, 4, 0, 2}, back = {2, 0, 1, 4, 3};
  for (int f = 0; f < 5; ++f) {
    for (int b = 0; b < 5; ++b) {
      evidence.push_back(pair(f, b, figure(random)));
      renamed.push_back(pair(front[static_cast<std::size_t>(f)], back[static_cast<std::size_t>(b)],
                             evidence.back().log_likelihood));
    }
  }
  const auto a = assignPairs(evidence, 5, 5, {}), b = assignPairs(renamed, 5, 5, {});
  ASSERT_EQ(a->pairs.size(), b->pairs.size());
  for (const Decision& d : a->pairs) {
    const auto same = std::find_if(b->pairs.begin(), b->pairs.end(), [&](const Decision& e) {
      return e.front == front[static_cast<std::size_t>(d.front)];
    });
    ASSERT_NE(same, b->pairs.end());
    EXPECT_EQ(same->back, back[static_cast<std::size_t>(d.back)]);
    EXPECT_NEAR(*same->score, *d.score, 1e-9);
  }
}

TEST(AssignPairs, RefusesIndicesAndFiguresThatCannotBe) {
  EXPECT_EQ(assignPairs(std::vector<Evidence>{pair(2, 0, 1)}, 2, 2, {}).error().code,
            ErrorCode::UnusableInput);
  EXPECT_EQ(assignPairs(std::vector<Evidence>{pair(0, 0, NAN)}, 2, 2, {}).error().code,
            ErrorCode::UnusableInput);
}

TEST(AssignPairs, OfNothingIsNothing) {
  const auto found = assignPairs({}, 0, 3, {});
  ASSERT_TRUE(found.has_value());
  EXPECT_TRUE(found->pairs.empty());
  EXPECT_EQ(found->unpaired_back.size(), 3u);
}

/// Best total with pair (force_f, force_b) taken, by trying everything; -1 = nothing forced.
double bruteForce(const std::vector<std::vector<double>>& gain, int force_f, int force_b) {
  std::function<double(std::size_t, unsigned)> best = [&](std::size_t f, unsigned taken) -> double {
    if (f == gain.size()) return 0;
    double most = static_cast<int>(f) == force_f ? -1e9 : best(f + 1, taken);
    for (unsigned b = 0; b < gain[f].size(); ++b) {
      const bool forced = static_cast<int>(f) == force_f;
      if ((taken >> b & 1u) || (forced && static_cast<int>(b) != force_b) ||
          (!forced && static_cast<int>(b) == force_b && force_f >= 0)) {
        continue;
      }
      most = std::max(most, gain[f][b] + best(f + 1, taken | 1u << b));
    }
    return most;
  };
  return best(0, 0);
}

TEST(Regrets, AgreeWithTryingAllAssignments) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> figure(-10, 10);
  for (int round = 0; round < 20; ++round) {
    std::vector<Evidence> evidence;
    std::vector<std::vector<double>> gain(4, std::vector<double>(5));
    for (int f = 0; f < 4; ++f) {
      for (int b = 0; b < 5; ++b) {
        evidence.push_back(pair(f, b, figure(random)));
        gain[static_cast<std::size_t>(f)][static_cast<std::size_t>(b)] =
            evidence.back().log_likelihood;
      }
    }
    const auto found = regrets(evidence, 4, 5, 0);
    ASSERT_TRUE(found.has_value());
    const double best = bruteForce(gain, -1, -1);
    for (std::size_t i = 0; i < evidence.size(); ++i) {
      EXPECT_NEAR((*found)[i], best - bruteForce(gain, evidence[i].front, evidence[i].back), 1e-9);
    }
  }
}

TEST(JointLogLikelihood, IsHeldDownByTheWeakerWitness) {
  // With 100 scans the prior is even: 0.1 * 0.1 * 100 = 1.
  // A certain outline, an undecided fracture: a near-duplicate (1 in 50) remains possible, odds 50
  // to 1.
  EXPECT_NEAR(jointLogLikelihood(100, 0, 100), std::log(50.0), 1e-9);
  // An undecided outline keeps the pair undecided however well the fractures of near-duplicates
  // part.
  EXPECT_NEAR(jointLogLikelihood(0, 100, 100), -std::log(0.98), 1e-9);
  EXPECT_NEAR(jointLogLikelihood(100, 50, 8) - jointLogLikelihood(100, 50, 1), -std::log(8.0),
              1e-9);
}

Evidence near(int front, int back, double distance_rad) {
  Evidence e;
  e.front = front, e.back = back, e.distance_rad = distance_rad;
  return e;
}

TEST(NearestPairs, TakeWhatIsGivenAndStateNoProbability) {
  std::vector<Evidence> evidence = {near(2, 0, 0.9), near(0, 1, 0.1)};
  evidence[1].log_likelihood = -1000;  // says nothing here
  const auto found = nearestPairs(evidence, 4, 3);
  ASSERT_TRUE(found.has_value()) << found.error().sentence();
  ASSERT_EQ(found->pairs.size(), 2u);
  EXPECT_EQ(found->pairs[0].front, 0);
  EXPECT_EQ(found->pairs[0].back, 1);
  EXPECT_EQ(found->pairs[0].distance_rad, 0.1);
  EXPECT_EQ(found->pairs[1].front, 2);
  for (const Decision& d : found->pairs) {
    EXPECT_FALSE(d.score.has_value());
    EXPECT_FALSE(d.margin.has_value());
    EXPECT_FALSE(d.ambiguous());
  }
  EXPECT_EQ(found->unpaired_front, (std::vector<int>{1, 3}));
  EXPECT_EQ(found->unpaired_back, std::vector<int>{2});
}

TEST(NearestPairs, AreAmbiguousWhereTwoFrontsTakeOneBackOrTheCheckFails) {
  std::vector<Evidence> evidence = {near(0, 0, 0.1), near(1, 0, 0.2), near(2, 1, 0.3)};
  evidence[2].check_failed = true;
  const auto found = nearestPairs(evidence, 3, 2);
  ASSERT_TRUE(found.has_value()) << found.error().sentence();
  ASSERT_EQ(found->pairs.size(), 3u);
  EXPECT_EQ(found->pairs[0].doubt, Doubt::SharedBack);
  EXPECT_EQ(found->pairs[1].doubt, Doubt::SharedBack);
  EXPECT_EQ(found->pairs[2].doubt, Doubt::SelfCheck);
  for (const Decision& d : found->pairs) EXPECT_TRUE(d.ambiguous());
}

TEST(NearestPairs, RefuseScansThatDoNotExist) {
  const std::vector<Evidence> evidence = {near(0, 2, 0.1)};
  EXPECT_EQ(nearestPairs(evidence, 1, 2).error().code, ErrorCode::UnusableInput);
}

}  // namespace
}  // namespace ostraka::pairing
