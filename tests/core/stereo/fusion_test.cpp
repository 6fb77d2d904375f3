#include "stereo/fusion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ball_frames.h"

namespace ostraka::stereo {
namespace {

TEST(FusePlanes, GivesTheSurfaceOnWhichTheViewsAgree) {
  const BallFrames ball(6);
  Agreement agreement;
  const auto points = fusePlanes(ball.all, ball.truth, {}, agreement);
  ASSERT_GT(points.size(), 5000u);
  double sum = 0;
  for (const SurfacePoint& point : points) {
    const double off = std::abs(ball.off(point.position));
    EXPECT_LT(off, 0.05) << "a quarter of a pixel";
    sum += off;
    const Eigen::Vector3f out = (point.position - ball.ball.centre.cast<float>()).normalized();
    EXPECT_GT(point.normal.dot(out), 0.99F);
    EXPECT_NEAR(point.footprint_mm, 190 / 900.0, 0.02);  // the depth over the focal length
    EXPECT_GE(point.agreeing, 2);
  }
  EXPECT_LT(sum / static_cast<double>(points.size()), 0.005);
  std::int64_t pixels = 0;
  for (const Frame& frame : ball.frames) pixels += static_cast<std::int64_t>(frame.pixels.size());
  EXPECT_EQ(agreement.matched, pixels);
  EXPECT_GT(agreement.confirmedShare(), 0.8);
  EXPECT_LT(static_cast<std::int64_t>(points.size()), agreement.confirmed)
      << "a place is taken from one of the views that see it";
}

TEST(FusePlanes, BelievesNoViewAloneAndNoPlaneThatMatchesBadly) {
  BallFrames ball(3);
  Agreement agreement;
  EXPECT_TRUE(
      fusePlanes(std::span(ball.all).first(1), std::span(ball.truth).first(1), {}, agreement)
          .empty());
  EXPECT_EQ(agreement.confirmed, 0);
  EXPECT_GT(agreement.matched, 0);
  for (PlaneMap& map : ball.truth) std::ranges::fill(map.cost, 0.9F);
  EXPECT_TRUE(fusePlanes(ball.all, ball.truth, {}, agreement).empty());
}

TEST(FusePlanes, GivesTheSameForAnyNumberOfThreads) {
  const BallFrames ball(3);
  Agreement agreement;
  const auto one = fusePlanes(ball.all, ball.truth, {.threads = 1}, agreement);
  const auto three = fusePlanes(ball.all, ball.truth, {.threads = 3}, agreement);
  ASSERT_EQ(one.size(), three.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].position, three[i].position);
    EXPECT_EQ(one[i].view, three[i].view);
  }
}

}  // namespace
}  // namespace ostraka::stereo
