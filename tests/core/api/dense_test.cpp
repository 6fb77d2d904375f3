#include "api/dense.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <limits>

#include "tests/core/api/quiet.h"
#include "tests/core/stereo/textured_ball.h"

namespace ostraka::api {
namespace {

TEST(Dense, RefusesPhotographsWhoseCameraOrPoseIsNone) {
  const std::vector<std::uint8_t> rgb(std::size_t{3} * 64 * 48, 128);
  DensePhotograph good;
  good.width = 64;
  good.height = 48;
  good.rgb = rgb;
  good.fx = good.fy = 80;
  good.cx = 31.5;
  good.cy = 23.5;
  std::vector<DensePhotograph> bad(9, good);
  bad[0].camera_from_world.matrix().setZero();
  bad[1].camera_from_world(0, 3) = 1e30;
  bad[2].camera_from_world(0, 0) = -1;
  bad[3].fx = std::numeric_limits<double>::quiet_NaN();
  bad[4].fy = 0;
  bad[5].fx = 1e300;
  bad[6].distortion[2] = std::numeric_limits<double>::quiet_NaN();
  bad[7].cx = std::numeric_limits<double>::infinity();
  bad[8].distortion[0] = -1000, bad[8].distortion[5] = 1;  // folds a pixel off the middle
  for (std::size_t i = 0; i < bad.size(); ++i) {
    const std::vector<DensePhotograph> photographs = {good, bad[i], good};
    const auto found = dense(photographs, 1, quiet, {});
    ASSERT_FALSE(found.has_value()) << i;
    EXPECT_EQ(found.error().code, ErrorCode::UnusableInput) << i;
    EXPECT_EQ(found.error().where, "photograph 1") << i;
  }
}

TEST(Dense, SaysThatPhotographsAreTooSmall) {
  const std::vector<std::uint8_t> rgb(3, 128), mask(1, 255);
  DensePhotograph pixel;
  pixel.width = pixel.height = 1;
  pixel.rgb = rgb;
  pixel.mask = mask;
  pixel.fx = pixel.fy = 1;
  const auto found = dense(std::vector<DensePhotograph>(3, pixel), 1, quiet, {});
  ASSERT_FALSE(found.has_value());
  EXPECT_EQ(found.error().code, ErrorCode::UnusableInput);
  EXPECT_THAT(found.error().sentence(), testing::HasSubstr("less than 16 pixels"));
}

TEST(Dense, FindsABallInPhotographsWithKnownCameras) {
  const stereo::TexturedBall ball;
  std::vector<cv::Mat> kept;
  std::vector<DensePhotograph> photographs;
  for (const stereo::View& view : stereo::ballViews(ball, 6)) {
    const rig::Intrinsics& camera = view.camera.intrinsics;
    kept.push_back(view.photograph);  // grey: red, green and blue are alike
    kept.push_back(view.mask);
    photographs.push_back({camera.width,
                           camera.height,
                           {view.photograph.data, 3 * view.photograph.total()},
                           {view.mask.data, view.mask.total()},
                           camera.fx,
                           camera.fy,
                           camera.cx,
                           camera.cy,
                           camera.distortion.terms,
                           view.camera.camera_from_plate});
  }
  const Result<DenseCloud> found = dense(photographs, 2, quiet, {});
  ASSERT_TRUE(found.has_value()) << found.error().sentence();
  EXPECT_TRUE(found->plausible);
  ASSERT_TRUE(found->cloud.hasNormals());
  std::vector<double> off;
  for (const Eigen::Vector3f& p : found->cloud.points)
    off.push_back(std::abs((p.cast<double>() - ball.centre).norm() - ball.radius_mm));
  std::sort(off.begin(), off.end());
  EXPECT_LT(off[off.size() / 2], 0.06);  // stereo_test.cpp: bias 0.04, spread 0.08

  photographs[1].height += 1;
  const Result<DenseCloud> wrong = dense(photographs, 2, quiet, {});
  ASSERT_FALSE(wrong.has_value());
  EXPECT_EQ(wrong.error().where, "photograph 1");
}

}  // namespace
}  // namespace ostraka::api
