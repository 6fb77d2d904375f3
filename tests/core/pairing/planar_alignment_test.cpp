#include "pairing/planar_alignment.h"

#include <gtest/gtest.h>

#include "pairing/contour.h"
#include "synthetic_sherd.h"

namespace ostraka::pairing {
namespace {

std::vector<Eigen::Vector2d> moved(const std::vector<Eigen::Vector2d>& line,
                                   const PlanarPose& front_from_back) {
  std::vector<Eigen::Vector2d> out;
  for (const Eigen::Vector2d& p : line) out.push_back(front_from_back.unapply(p));
  return out;
}

TEST(OutlineField, GivesTheExactDistanceToASquare) {
  const std::vector<Eigen::Vector2d> corners = {{0, 0}, {20, 0}, {20, 20}, {0, 20}};
  const OutlineField field(resampled(corners, 400));
  EXPECT_NEAR(field.nearest({10.03, 3}).distance, 3, 1e-9);
  EXPECT_NEAR(field.nearest({10.03, -4}).distance, 4, 1e-9);
  EXPECT_NEAR(field.nearest({10, -4}).normal.y(), -1, 1e-9);
  EXPECT_NEAR(field.nearest({-3, -4}).distance, 5, 1e-9);
  EXPECT_NEAR((field.centroid() - Eigen::Vector2d(10, 10)).norm(), 0, 1e-9);
}

TEST(AlignOutlines, FindsTheKnownPoseFromTwoMillimetresAndSixDegreesOff) {
  const auto line = resampled(test::SlabSherd(7).outline(4000), 450);
  const PlanarPose truth{0.7, 1, {3, -2}};
  const OutlineField front(line), back(moved(line, truth));
  PlanarPose start = truth;
  start.angle_rad += 0.1, start.shift += Eigen::Vector2d(1.5, -1.3);
  const PlanarFit fit = alignOutlines(front, back, start, {});
  EXPECT_NEAR(fit.pose.angle_rad, 0.7, 1e-3);
  EXPECT_NEAR((fit.pose.shift - truth.shift).norm(), 0, 0.02);
  EXPECT_LT(fit.rms_mm, 0.01);
}

TEST(AlignOutlines, HoldsWhereAPartOfOneOutlineIsMissing) {
  const test::SlabSherd sherd(7);
  auto line = sherd.outline(4000);
  auto cut = line;
  for (std::size_t i = 0; i < 600; ++i) cut[i] *= 0.88;  // 15 % of the strip hidden, 2 mm deep
  const OutlineField front(resampled(line, 450)), back(resampled(cut, 450));
  const PlanarFit fit = alignOutlines(front, back, {0.05, 1, {0.8, 0.8}}, {});
  EXPECT_NEAR(fit.pose.angle_rad, 0, 5e-3);
  EXPECT_LT(fit.pose.shift.norm(), 0.1);  // plain least squares ends 0.25 mm off
}

TEST(AlignOutlines, FindsTheScaleWhenItIsFree) {
  const auto line = resampled(test::SlabSherd(7).outline(4000), 450);
  const PlanarPose truth{-0.4, 1.05, {1, 1}};
  const OutlineField front(line), back(moved(line, truth));
  PlanarPose start = truth;
  start.scale = 1;
  PlanarAlignOptions options;
  options.scale = FreeScale::Yes;
  options.rounds = 20;
  EXPECT_NEAR(alignOutlines(front, back, start, options).pose.scale, 1.05, 1e-3);
}

TEST(BestTurns, NamesAllTurnsOfASquareAndTheTrueTurnOfASherd) {
  const std::vector<Eigen::Vector2d> corners = {{0, 0}, {20, 0}, {20, 20}, {0, 20}};
  const OutlineField square(resampled(corners, 400));
  EXPECT_EQ(bestTurns(square, square, 1, 16).size(), 4u);
  const auto line = resampled(test::SlabSherd(2).outline(4000), 450);
  const OutlineField front(line), back(moved(line, {1.5, 1, {4, 4}}));
  EXPECT_NEAR(bestTurns(front, back, 1, 16).front().angle_rad, 1.5, 0.06);  // steps of 0.052
}

}  // namespace
}  // namespace ostraka::pairing
