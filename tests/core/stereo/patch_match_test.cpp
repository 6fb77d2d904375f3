#include "stereo/patch_match.h"

#include <gtest/gtest.h>

#include <cmath>

#include "ball_frames.h"

namespace ostraka::stereo {
namespace {

std::vector<Frame> workedOn(int levels) {
  std::vector<Frame> pyramid = buildPyramid(ballViews({}, 1).front(), levels);
  for (Frame& frame : pyramid) workOnMask(frame);
  return pyramid;
}

TEST(StartPlanes, LieInTheirRangesAndFaceTheCamera) {
  const Frame frame = std::move(workedOn(1).front());
  std::vector<DepthRange> ranges;
  for (std::size_t k = 0; k < frame.pixels.size(); ++k)
    ranges.push_back({180, 181 + static_cast<float>(k % 30)});
  PlaneMap planes, again, other;
  startPlanes(frame, ranges, 5, planes);
  startPlanes(frame, ranges, 5, again);
  startPlanes(frame, ranges, 6, other);
  ASSERT_EQ(planes.depth.size(), frame.pixels.size());
  int level = 0;
  for (std::size_t k = 0; k < frame.pixels.size(); ++k) {
    EXPECT_GE(planes.depth[k], ranges[k].near);
    EXPECT_LE(planes.depth[k], ranges[k].far);
    EXPECT_NEAR(planes.normal[k].norm(), 1, 1e-5);
    const Eigen::Vector3f ray =
        frame.ray(static_cast<float>(frame.pixels[k].x), static_cast<float>(frame.pixels[k].y));
    EXPECT_LT(planes.normal[k].dot(ray), 0);
    level += planes.normal[k].dot(frame.rotation.col(2)) > 0.9F ? 1 : 0;
  }
  EXPECT_GT(level, static_cast<int>(frame.pixels.size()) / 4) << "sherds lie on the plate";
  EXPECT_EQ(planes.depth, again.depth);
  EXPECT_NE(planes.depth, other.depth);
}

// The plate itself: a plane that slants to the camera.
TEST(RefinePlanes, ContinuesAPlaneToTheFinerPixels) {
  const std::vector<Frame> pyramid = workedOn(2);
  const Eigen::Vector3f on_plate(3, -2, 15);
  const auto planeAt = [&](const Frame& frame, const cv::Point& pixel) {
    const Eigen::Vector3f normal = frame.rotation.col(2);
    const Eigen::Vector3f ray = frame.ray(static_cast<float>(pixel.x), static_cast<float>(pixel.y));
    return Plane{normal.dot(frame.toCamera(on_plate)) / normal.dot(ray), normal};
  };
  PlaneMap coarse, fine;
  coarse.resize(pyramid[1].pixels.size());
  for (std::size_t k = 0; k < pyramid[1].pixels.size(); ++k) {
    coarse.depth[k] = planeAt(pyramid[1], pyramid[1].pixels[k]).depth;
    coarse.normal[k] = pyramid[1].rotation.col(2);
  }
  refinePlanes(pyramid[1], coarse, pyramid[0], fine);
  ASSERT_EQ(fine.depth.size(), pyramid[0].pixels.size());
  for (std::size_t k = 0; k < fine.depth.size(); ++k) {
    EXPECT_NEAR(fine.depth[k], planeAt(pyramid[0], pyramid[0].pixels[k]).depth, 2e-3);
    EXPECT_EQ(fine.normal[k], coarse.normal[0]);
  }
  Frame nothing = pyramid[1];
  nothing.index = -1;
  refinePlanes(nothing, coarse, pyramid[0], fine);
  EXPECT_EQ(fine.depth, std::vector<float>(pyramid[0].pixels.size(), 0.0F));
}

TEST(Propagate, WhenItIsStoppedAtOnceLeavesThePlanes) {
  BallFrames ball(1);
  std::stop_source stop;
  stop.request_stop();
  const std::vector<DepthRange> ranges(ball.frames[0].pixels.size(), DepthRange{150, 250});
  const std::vector<Link> links = {linkBetween(ball.frames[0], ball.frames[1], 1)};
  const std::vector<float> before = ball.truth[0].depth;
  propagate(ball.all, 0, links, ranges, {}, ball.truth[0], stop.get_token());
  EXPECT_EQ(ball.truth[0].depth, before);
}

// A pixel takes over its neighbour's plane where that fits better than its own.
TEST(Propagate, BringsTheTruePlaneToPixelsThatHaveAWrongOne) {
  BallFrames ball(8);
  const Frame& frame = ball.frames[0];
  const PlaneMap truth = ball.truth[0];
  const std::vector<DepthRange> ranges(frame.pixels.size(), DepthRange{180, 210});
  std::vector<Link> links;
  for (const int source : {1, 2, 14})
    links.push_back(linkBetween(frame, ball.frames[static_cast<std::size_t>(source)], source));
  const cv::Rect middle(90, 70, 20, 20);
  std::vector<std::size_t> wrong;
  for (std::size_t k = 0; k < frame.pixels.size(); ++k)
    if (middle.contains(frame.pixels[k]) && (frame.pixels[k].x + frame.pixels[k].y) % 2 == 0)
      wrong.push_back(k);
  ASSERT_EQ(wrong.size(), 200u);
  for (const std::size_t k : wrong) ball.truth[0].depth[k] += 3;
  PropagationOptions options;
  options.rounds = 1;
  propagate(ball.all, 0, links, ranges, options, ball.truth[0], {});
  int right = 0;
  for (const std::size_t k : wrong)
    right += std::abs(ball.truth[0].depth[k] - truth.depth[k]) < 0.2F ? 1 : 0;
  EXPECT_GT(right, 180);
}

}  // namespace
}  // namespace ostraka::stereo
