#include "stereo/hull.h"

#include <gtest/gtest.h>

#include "textured_ball.h"

namespace ostraka::stereo {
namespace {

struct Carved {
  std::vector<std::vector<Frame>> pyramids;
  std::vector<const Frame*> frames;
};

Carved framesOf(const std::vector<View>& views) {
  Carved carved;
  for (const View& view : views) carved.pyramids.push_back(buildPyramid(view, 2));
  for (const auto& pyramid : carved.pyramids) carved.frames.push_back(&pyramid.back());
  return carved;
}

TEST(Hull, HoldsTheObjectAndLittleMore) {
  const TexturedBall ball;
  const Carved carved = framesOf(ballViews(ball, 6));
  DenseOptions options;
  options.floor_z_mm = 10.0;
  const Result<Hull> hull = carveHull(carved.frames, options, 2);
  ASSERT_TRUE(hull.has_value());
  for (const Eigen::Vector3d& out :
       {Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(1, 0, 0.3), Eigen::Vector3d(-0.5, 0.7, 0.4)}) {
    const Eigen::Vector3d direction = out.normalized();
    EXPECT_TRUE(hull->at((ball.centre + 9.9 * direction).cast<float>()));
    EXPECT_FALSE(hull->at((ball.centre + 15.0 * direction).cast<float>()));
  }
  EXPECT_FALSE(hull->at((ball.centre - Eigen::Vector3d(0, 0, 2)).cast<float>()));  // the floor
}

TEST(Hull, GivesEachPixelARangeAroundItsDepth) {
  const TexturedBall ball;
  const Carved carved = framesOf(ballViews(ball, 6));
  DenseOptions options;
  options.floor_z_mm = 10.0;
  const Result<Hull> hull = carveHull(carved.frames, options, 2);
  ASSERT_TRUE(hull.has_value());
  const Frame& frame = *carved.frames[1];
  const std::vector<DepthRange> ranges = depthRanges(*hull, frame);
  const DepthRange middle = ranges[static_cast<std::size_t>(40 * frame.width + 50)];
  EXPECT_LT(middle.near, 190.5);  // the eye is 200 mm from the centre of a ball of 10
  EXPECT_GT(middle.near, 180.0);
  EXPECT_GT(middle.far, 190.0);
  EXPECT_EQ(ranges.front().far, 0.0F);  // the corner shows the background
}

TEST(Hull, OneMaskThatMissesTheObjectDoesNotCostIt) {
  std::vector<View> views = ballViews({}, 4);
  views[3].mask.setTo(0);
  const Carved carved = framesOf(views);
  const Result<Hull> hull = carveHull(carved.frames, {}, 1);
  ASSERT_TRUE(hull.has_value());
  EXPECT_TRUE(hull->at(TexturedBall().centre.cast<float>()));
}

TEST(Hull, OneIn24MasksMayErr) {
  EXPECT_EQ(masksThatMayErr(3), 1);
  EXPECT_EQ(masksThatMayErr(24), 1);
  EXPECT_EQ(masksThatMayErr(48), 2);
}

TEST(Hull, IsAnErrorWhenTheMasksHaveNothingInCommon) {
  std::vector<View> views = ballViews({}, 4);
  for (std::size_t i = 2; i < views.size(); ++i) views[i].mask.setTo(0);
  const Carved carved = framesOf(views);
  const Result<Hull> hull = carveHull(carved.frames, {}, 1);
  ASSERT_FALSE(hull.has_value());
  EXPECT_EQ(hull.error().code, ErrorCode::NotEnough);
}

}  // namespace
}  // namespace ostraka::stereo
