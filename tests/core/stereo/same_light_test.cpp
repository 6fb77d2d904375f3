#include "stereo/same_light.h"

#include <gtest/gtest.h>

#include <cmath>

#include "ball_frames.h"

namespace ostraka::stereo {
namespace {

class SameLight : public testing::Test {
 protected:
  // The ball's surface, too far out by this.
  std::vector<SurfacePoint> tooFarOut(float mm) const {
    Agreement agreement;
    std::vector<SurfacePoint> points = fusePlanes(ball_.all, ball_.truth, {}, agreement);
    for (SurfacePoint& point : points) point.position += mm * point.normal;
    return points;
  }
  double meanOff(const std::vector<SurfacePoint>& points) const {
    double sum = 0;
    for (const SurfacePoint& point : points) sum += ball_.off(point.position);
    return sum / static_cast<double>(points.size());
  }
  BallFrames ball_{6};
};

TEST_F(SameLight, MovesPointsToWhereThePhotographsOfOneStopSeeThem) {
  const auto points = tooFarOut(0.08F);
  ASSERT_NEAR(meanOff(points), 0.08, 0.005);
  EXPECT_LT(std::abs(meanOff(settledInSameLight(ball_.all, ball_.truth, points, {}))), 0.04);
}

TEST_F(SameLight, LeavesPointsWhereNoTwoPhotographsOrAllHaveTheirLightInCommon) {
  const auto points = tooFarOut(0.08F);
  for (const bool all : {false, true}) {
    for (std::size_t i = 0; i < ball_.frames.size(); ++i)
      ball_.frames[i].light = all ? 0 : static_cast<int>(i);
    const auto settled = settledInSameLight(ball_.all, ball_.truth, points, {});
    ASSERT_EQ(settled.size(), points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
      EXPECT_EQ(settled[i].position, points[i].position);
  }
}

}  // namespace
}  // namespace ostraka::stereo
