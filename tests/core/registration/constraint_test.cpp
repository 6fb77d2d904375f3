#include "registration/constraint.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <array>

namespace ostraka::registration {
namespace {

// A constraint that puts the height at z_mm, seen from a pose at `here`.
Evidence heightAt(double z_mm, double sigma_mm, double here_mm) {
  Evidence evidence;
  evidence.add((here_mm - z_mm) / sigma_mm, Vector6::Unit(5) / sigma_mm);
  return evidence;
}

Matrix6 weakStart() {
  return 0.4 * Matrix6::Identity();
}

// Height and its sigma once constraints and their weights have settled.
std::pair<double, double> settled(const std::array<double, 3>& heights_mm, double sigma_mm) {
  std::array<Constraint, 3> said;
  double here = 0;
  Matrix6 information;
  for (int round = 0; round < 60; ++round) {
    for (std::size_t k = 0; k < said.size(); ++k)
      said[k].evidence = heightAt(heights_mm[k], sigma_mm, here);
    learnWeights(said, weakStart());
    information = together(said).information + 1e-6 * Matrix6::Identity();
    here -= (information.inverse() * together(said).gradient)[5];
  }
  return {here, inconsistency(said, weakStart()) * std::sqrt(information.inverse()(5, 5))};
}

TEST(Constraint, ThatAgreesIsBelievedAsItIs) {
  const auto [height, sigma] = settled({0.02, -0.02, 0.0}, 0.05);
  EXPECT_NEAR(height, 0, 1e-6);
  EXPECT_NEAR(sigma, 0.05 / std::sqrt(3.0), 1e-4);  // three equal constraints
}

TEST(Constraint, ThatAllOthersContradictIsLeftAside) {
  const auto [height, sigma] = settled({0.0, 0.0, 1.0}, 0.05);
  EXPECT_LT(height, 0.05);  // the mean would be 0.33
  EXPECT_GT(sigma, 0.05 / std::sqrt(2.0));
}

TEST(Constraint, OfWhichNoneIsTheOddOneLeavesTheHeightUncertain) {
  const auto [height, sigma] = settled({-0.5, 0.0, 0.5}, 0.05);
  EXPECT_NEAR(height, 0, 1e-3);
  EXPECT_GT(sigma, 2 * 0.05 / std::sqrt(3.0));
}

TEST(Constraint, OfOneAloneIsBelieved) {
  std::array<Constraint, 2> said;  // the second is silent
  said[0].evidence = heightAt(0.2, 0.05, 0.2);
  learnWeights(said, weakStart());
  EXPECT_EQ(said[0].weight, 1);
  EXPECT_EQ(said[1].weight, 1);
}

}  // namespace
}  // namespace ostraka::registration
