#include "pairing/fracture_evidence.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ostraka::pairing {
namespace {

TEST(FractureLogLikelihoods, LearnFromTheBatchHowWellTrueFracturesFit) {
  // Four certain pairs whose breaks fit to 0.15 mm, and a near-duplicate of the first at 0.4 mm.
  std::vector<FractureFigures> ragged;
  for (int i = 0; i < 4; ++i) ragged.push_back({i, i, 40, 0.15, 100});
  ragged.push_back({0, 1, 20, 0.4, 100});
  const std::vector<double> found = fractureLogLikelihoods(ragged);
  EXPECT_GT(found[0], 0.3);
  EXPECT_LT(found[4], -2.5);
  // The same 0.15 mm beside breaks that fit to 0.04 mm is a near-duplicate's.
  std::vector<FractureFigures> clean;
  for (int i = 0; i < 4; ++i) clean.push_back({i, i, 40, 0.04, 100});
  clean.push_back({0, 1, 20, 0.15, 100});
  EXPECT_GT(fractureLogLikelihoods(clean)[0], 2);
  EXPECT_LT(fractureLogLikelihoods(clean)[4], -2.5);
}

TEST(FractureLogLikelihoods, SeeThatMostOfTheCertainPairsAreStrays) {
  // Fronts and backs of three near-duplicates whose own other sides are missing, and two true
  // pairs.
  const std::vector<FractureFigures> figures = {{0, 0, 40, 0.04, 100},
                                                {1, 1, 40, 0.045, 100},
                                                {2, 2, 40, 0.20, 100},
                                                {3, 3, 40, 0.24, 100},
                                                {4, 4, 40, 0.30, 100}};
  const std::vector<double> found = fractureLogLikelihoods(figures);
  EXPECT_GT(found[0], 2);
  EXPECT_GT(found[1], 2);
  for (int i = 2; i < 5; ++i) EXPECT_NEAR(found[i], std::log(0.01), 0.01);
}

TEST(FractureLogLikelihoods, BelieveABatchThatIsAllAlikeAndRagged) {
  std::vector<FractureFigures> figures;
  for (int i = 0; i < 7; ++i) figures.push_back({i, i, 40, 0.15 + 0.005 * i, 60});
  for (const double ratio : fractureLogLikelihoods(figures)) EXPECT_GT(ratio, 0.3);
}

TEST(FractureLogLikelihoods, NeverSayMoreThanAFailedRegistrationMay) {
  std::vector<FractureFigures> figures;
  for (int i = 0; i < 4; ++i) figures.push_back({i, i, 40, 0.04, 100});
  figures.push_back({4, 4, 40, 0.9, 100});
  EXPECT_NEAR(fractureLogLikelihoods(figures)[4], std::log(0.01), 1e-3);
}

TEST(FractureLogLikelihoods, SayLittleOfARimThatHardlyMet) {
  // Alone, without a batch to compare with, 0.12 mm over two places may be anything. True breaks
  // that fit to 0.01 to 0.30 mm, all as likely, have it less often than near-duplicates about 0.22
  // mm apart, but no more than four to one: an outline's 10 outweighs it.
  const std::vector<FractureFigures> met = {{0, 0, 40, 0.05, 100}};
  const std::vector<FractureFigures> hardly = {{0, 0, 40, 0.12, 2}};
  EXPECT_GT(fractureLogLikelihoods(met)[0], 2);
  EXPECT_GT(fractureLogLikelihoods(hardly)[0], -std::log(4.0));
  EXPECT_LT(fractureLogLikelihoods(hardly)[0], 0.5);
}

}  // namespace
}  // namespace ostraka::pairing
