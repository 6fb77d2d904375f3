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

// The ball from straight above, the camera moved by hand: the axes turn outwards by 0.6 degrees and
// meet half a metre above the cameras.
std::vector<View> ballFromAbove(const TexturedBall& ball) {
  std::vector<View> views;
  for (const Eigen::Vector2d& aside :
       {Eigen::Vector2d(0, 0), Eigen::Vector2d(5, 0), Eigen::Vector2d(-5, 0), Eigen::Vector2d(0, 5),
        Eigen::Vector2d(0, -5)}) {
    const Eigen::Vector3d eye = ball.centre + Eigen::Vector3d(aside.x(), aside.y(), 200);
    const Eigen::Vector3d axis =
        Eigen::Vector3d(0.002 * aside.x(), 0.002 * aside.y(), -1).normalized();
    View view;
    view.camera.intrinsics = {200, 160, 900, 900, 99.5, 79.5, {}};
    Eigen::Matrix3d r;
    r.row(2) = axis;
    r.row(0) = (Eigen::Vector3d::UnitX() - axis.x() * axis).normalized();
    r.row(1) = axis.cross(Eigen::Vector3d(r.row(0)));
    view.camera.camera_from_plate.linear() = r;
    view.camera.camera_from_plate.translation() = -r * eye;
    view.photograph = cv::Mat(160, 200, CV_8UC3, cv::Scalar(12, 12, 12));
    view.mask = cv::Mat1b(160, 200, std::uint8_t{0});
    for (int y = 0; y < 160; ++y)
      for (int x = 0; x < 200; ++x) {
        const Eigen::Vector2d n =
            view.camera.intrinsics.unproject({static_cast<double>(x), static_cast<double>(y)});
        const Eigen::Vector3d ray = (r.transpose() * n.homogeneous()).normalized();
        if ((ball.centre - eye).cross(ray).norm() < ball.radius_mm) view.mask(y, x) = 255;
      }
    views.push_back(std::move(view));
  }
  return views;
}

TEST(Hull, IsFoundOnTheFloorWhereTheAxesMeetAboveTheCameras) {
  const TexturedBall ball;
  const Carved carved = framesOf(ballFromAbove(ball));
  DenseOptions options;
  EXPECT_FALSE(carveHull(carved.frames, options, 2).has_value());
  options.floor_z_mm = ball.centre.z() - ball.radius_mm;
  const Result<Hull> hull = carveHull(carved.frames, options, 2);
  ASSERT_TRUE(hull.has_value()) << hull.error().sentence();
  EXPECT_TRUE(hull->at((ball.centre + Eigen::Vector3d(0, 0, 9)).cast<float>()));
  EXPECT_TRUE(hull->at((ball.centre + Eigen::Vector3d(9, 0, 0)).cast<float>()));
  EXPECT_FALSE(hull->at((ball.centre + Eigen::Vector3d(15, 0, 0)).cast<float>()));
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
