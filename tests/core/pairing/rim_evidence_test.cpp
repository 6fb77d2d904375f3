#include "pairing/rim_evidence.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ostraka::pairing {
namespace {

TEST(RimLogLikelihoods, LearnFromTheBatchHowWellTrueRimsFit) {
  // Four certain pairs whose rims fit to 0.3 mm, and a look-alike of the first at 0.7 mm.
  std::vector<RimFigures> ragged;
  for (int i = 0; i < 4; ++i) ragged.push_back({i, i, 40, 0.3, -12});
  ragged.push_back({0, 1, 20, 0.7, -12});
  const std::vector<double> found = rimLogLikelihoods(ragged);
  EXPECT_GT(found[0], 0.3);
  EXPECT_LT(found[4], -2.5);
  // The same 0.3 mm beside rims of 0.1 mm is a look-alike's.
  std::vector<RimFigures> clean;
  for (int i = 0; i < 4; ++i) clean.push_back({i, i, 40, 0.1, 0});
  clean.push_back({0, 1, 20, 0.3, 0});
  EXPECT_GT(rimLogLikelihoods(clean)[0], 2);
  EXPECT_LT(rimLogLikelihoods(clean)[4], -2.5);
}

TEST(RimLogLikelihoods, NeverSayMoreThanAFailedRegistrationMay) {
  std::vector<RimFigures> figures;
  for (int i = 0; i < 4; ++i) figures.push_back({i, i, 40, 0.1, 0});
  figures.push_back({4, 4, 40, 5.0, -1e6});
  EXPECT_NEAR(rimLogLikelihoods(figures)[4], std::log(0.05), 1e-6);
}

TEST(RimLogLikelihoods, TakeTheRegistrationsOwnFigureInASmallBatch) {
  const std::vector<RimFigures> one = {{0, 0, 40, 0.1, 8}};
  EXPECT_NEAR(rimLogLikelihoods(one)[0], std::log(0.95 * std::exp(8.0) + 0.05), 1e-9);
}

}  // namespace
}  // namespace ostraka::pairing
