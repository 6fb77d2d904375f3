#include "stereo/stereo.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "textured_ball.h"

namespace ostraka::stereo {
namespace {

PointCloud reconstructed(const std::vector<View>& views, int threads) {
  DenseOptions options;
  options.threads = threads;
  options.floor_z_mm = 10.0;
  QuietProgress quiet;
  Result<Reconstruction> cloud = reconstruct(views, options, quiet, {});
  EXPECT_TRUE(cloud.has_value()) << (cloud ? "" : cloud.error().what);
  return cloud ? std::move(cloud->cloud) : PointCloud{};
}

TEST(Stereo, FindsABallToAFifthOfAPixelWithItsNormals) {
  const TexturedBall ball;
  const PointCloud cloud = reconstructed(ballViews(ball, 6), 2);
  ASSERT_GT(cloud.size(), 5000U);  // 628 mm^2 of half ball, one point per 0.2 mm
  ASSERT_TRUE(cloud.hasNormals());
  std::vector<double> distance, angle;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3d out = cloud.points[i].cast<double>() - ball.centre;
    distance.push_back(out.norm() - ball.radius_mm);
    angle.push_back(
        std::acos(std::min(1.0, out.normalized().dot(cloud.normals[i].cast<double>()))));
  }
  std::sort(distance.begin(), distance.end());
  std::sort(angle.begin(), angle.end());
  const std::size_t n = cloud.size();
  // Flat windows of 0.66 mm sink into a ball of 10 mm by r^2 / 2R = 0.02 mm.
  EXPECT_NEAR(distance[n / 2], 0.0, 0.04);
  EXPECT_LT(distance[n * 9 / 10], 0.08);
  EXPECT_GT(distance[n / 10], -0.08);
  EXPECT_LT(angle[n / 2], 0.1);  // 6 degrees
}

TEST(Stereo, GivesTheSameBytesForOneThreeAndSixteenThreads) {
  const std::vector<View> views = ballViews({}, 4);
  const PointCloud one = reconstructed(views, 1);
  for (const int threads : {3, 16}) {
    const PointCloud other = reconstructed(views, threads);
    ASSERT_EQ(one.size(), other.size());
    EXPECT_EQ(
        0, std::memcmp(one.points.data(), other.points.data(), one.size() * sizeof one.points[0]));
    EXPECT_EQ(0, std::memcmp(one.normals.data(), other.normals.data(),
                             one.size() * sizeof one.normals[0]));
    EXPECT_EQ(one.colors, other.colors);
  }
}

// Shading that follows the camera around the ball by 0.2 mm, as that of bumps does when the light
// stands still, looks like a surface at another depth to photographs of different stops.
TEST(Stereo, IsNotMisledByShadingThatMovesFromStopToStop) {
  const TexturedBall ball;
  const auto median = [&](const std::vector<View>& views) {
    std::vector<double> distance;
    for (const Eigen::Vector3f& p : reconstructed(views, 2).points)
      if (p.z() > ball.centre.z() + 5)  // where both cameras of a stop look
        distance.push_back((p.cast<double>() - ball.centre).norm() - ball.radius_mm);
    std::nth_element(distance.begin(), distance.begin() + static_cast<long>(distance.size() / 2),
                     distance.end());
    return distance[distance.size() / 2];
  };
  std::vector<View> views = ballViews(ball, 6, 0.2);
  const double told = median(views);
  for (View& view : views) view.camera.stop = 0;  // nobody says which were lit alike
  const double untold = median(views);
  EXPECT_GT(std::abs(untold), 0.06);
  EXPECT_LT(std::abs(told), 0.5 * std::abs(untold));
}

// All masks are the same disc, so that the hull is right with any of the cameras: only the surfaces
// that the photographs find tell them apart.
TEST(Stereo, TellsTheCamerasOfThePhotographsFromThoseOfOthers) {
  const std::vector<View> right = ballViews({}, 6);
  std::vector<View> wrong = right;
  for (std::size_t i = 0; i < wrong.size(); ++i)
    wrong[i].camera.camera_from_plate = right[(5 * i + 3) % right.size()].camera.camera_from_plate;
  DenseOptions options;
  options.threads = 2;
  QuietProgress quiet;
  const Result<Reconstruction> found = reconstruct(right, options, quiet, {});
  const Result<Reconstruction> junk = reconstruct(wrong, options, quiet, {});
  ASSERT_TRUE(found.has_value() && junk.has_value());
  EXPECT_TRUE(found->agreement.plausible());
  EXPECT_FALSE(junk->agreement.plausible());
  EXPECT_GT(found->agreement.confirmedShare(), 3 * junk->agreement.confirmedShare());
  EXPECT_LE(found->agreement.confirmed, found->agreement.matched);
  EXPECT_LE(found->agreement.matched, found->agreement.shown);
}

TEST(Stereo, RefusesTwoViews) {
  std::vector<View> views = ballViews({}, 4);
  views.resize(2);
  QuietProgress quiet;
  const Result<Reconstruction> cloud = reconstruct(views, {}, quiet, {});
  ASSERT_FALSE(cloud.has_value());
  EXPECT_EQ(cloud.error().code, ErrorCode::NotEnough);
}

TEST(Stereo, NamesThePhotographWhoseSizeIsNotItsCameras) {
  std::vector<View> views = ballViews({}, 4);
  views[2].photograph = views[2].photograph.rowRange(0, 100).clone();
  QuietProgress quiet;
  const Result<Reconstruction> cloud = reconstruct(views, {}, quiet, {});
  ASSERT_FALSE(cloud.has_value());
  EXPECT_EQ(cloud.error().code, ErrorCode::UnusableInput);
  EXPECT_EQ(cloud.error().where, "stop1");
}

TEST(Stereo, SaysThatEmptyMasksHoldNoObject) {
  std::vector<View> views = ballViews({}, 4);
  for (View& view : views) view.mask.setTo(0);
  QuietProgress quiet;
  const Result<Reconstruction> cloud = reconstruct(views, {}, quiet, {});
  ASSERT_FALSE(cloud.has_value());
  EXPECT_EQ(cloud.error().code, ErrorCode::NotEnough);
}

TEST(Stereo, StopsOnRequest) {
  std::stop_source source;
  source.request_stop();
  QuietProgress quiet;
  const Result<Reconstruction> cloud = reconstruct(ballViews({}, 4), {}, quiet, source.get_token());
  ASSERT_FALSE(cloud.has_value());
  EXPECT_EQ(cloud.error().code, ErrorCode::Cancelled);
}

TEST(Stereo, ReadsNoMorePhotographsOnceAStopIsAskedFor) {
  const std::vector<View> views = ballViews({}, 4);
  std::stop_source source;
  int reads = 0;
  const auto read = [&](std::size_t view) -> Result<cv::Mat> {
    ++reads;
    source.request_stop();
    return views[view].photograph;
  };
  QuietProgress quiet;
  const auto cloud = reconstruct(views, read, {}, quiet, source.get_token());
  ASSERT_FALSE(cloud.has_value());
  EXPECT_EQ(cloud.error().code, ErrorCode::Cancelled);
  EXPECT_EQ(reads, 1);
}

TEST(DenseOptions, NameTheFieldThatIsWrong) {
  DenseOptions options;
  options.max_sources = 17;
  ASSERT_FALSE(options.check().has_value());
  EXPECT_NE(options.check().error().what.english().find("max_sources"), std::string::npos);
}

}  // namespace
}  // namespace ostraka::stereo
