#include "stereo/outside_adapter.h"

#include <gmock/gmock.h>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "cloud/ply.h"
#include "colmap/colmap_program.h"
#include "stand_in.h"
#include "tests/core/colmap/model_forms.h"
#include "textured_ball.h"

namespace ostraka::stereo {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

using OutsideAdapter = StandIns;

TEST_F(OutsideAdapter, WritesPinholesWithTheirCentreHalfAPixelOn) {
  const std::vector<View> views = ballViews({}, 4);
  ASSERT_TRUE(writeOutsideFolder(views, {}, work(), MaskStyle::Colmap, {}).has_value());
  // cx 99.5, cy 79.5 where a pixel's centre is whole; the lens's distortion is taken out.
  EXPECT_THAT(textOf(work() / "sparse" / "cameras.txt"),
              HasSubstr("\n8 PINHOLE 200 160 900 900 100 80\n"));
  const colmap::ColmapModel model = colmap::textModelIn(work() / "sparse");
  ASSERT_EQ(model.images.size(), 8U);
  EXPECT_EQ(model.images[7].name, "0007.png");
  EXPECT_TRUE(model.images[5].camera_from_world.isApprox(views[5].camera.camera_from_plate, 1e-12));
}

TEST_F(OutsideAdapter, GivesEachViewThePointsOfTheHullThatItSees) {
  const TexturedBall ball;
  const std::vector<View> views = ballViews(ball, 4);
  DenseOptions options;
  options.floor_z_mm = ball.centre.z();
  ASSERT_TRUE(writeOutsideFolder(views, options, work(), MaskStyle::OpenMvs, {}).has_value());
  const colmap::ColmapModel model = colmap::textModelIn(work() / "sparse");
  ASSERT_GT(model.points.size(), 500U);
  int facing = 0, all = 0, far = 0;
  for (const colmap::ColmapPoint& point : model.points) {
    ASSERT_GE(point.track.size(), 2U);
    const Eigen::Vector3d out = point.position - ball.centre;
    far += out.norm() > 1.6 * ball.radius_mm ? 1 : 0;
    for (const auto& [image, index] : point.track) {
      const colmap::ColmapImage& seen = model.images[image - 1];
      ASSERT_EQ(seen.observations[index].point, static_cast<std::int64_t>(point.id));
      const Eigen::Vector3d q = seen.camera_from_world * point.position;
      const Eigen::Vector2d pixel(900 * q.x() / q.z() + 100, 900 * q.y() / q.z() + 80);
      // Cubes' places are held in single precision.
      EXPECT_LT((seen.observations[index].pixel - pixel).norm(), 1e-3);
      const Eigen::Vector3d eye = seen.camera_from_world.inverse().translation();
      facing += out.dot(eye - point.position) > 0 ? 1 : 0;
      ++all;
    }
  }
  EXPECT_GT(facing, 0.95 * all);
  // Outlines from four sides leave a square about the circle: its corners are sqrt(2) radii away.
  // A few points above lie beyond the pictures of the lower cameras.
  EXPECT_LT(far, 0.05 * static_cast<double>(model.points.size()));
}

TEST_F(OutsideAdapter, TakesTheLensOutOfPhotographAndMask) {
  std::vector<View> views = ballViews({}, 4);
  // At 100 pixels from the middle this lens shifts by 1.9 pixels.
  views[0].camera.intrinsics.distortion = {{1.5, 0, 0, 0, 0}};
  const Eigen::Vector2d straight(20, 30), middle(99.5, 79.5);
  const Eigen::Vector2d n = (straight - middle) / 900;
  const Eigen::Vector2d bent = middle + (straight - middle) * (1 + 1.5 * n.squaredNorm());
  views[0].photograph.setTo(0);
  for (int y = 0; y < 160; ++y)
    for (int x = 0; x < 200; ++x) {
      const double light = 200 * std::exp(-0.5 * (Eigen::Vector2d(x, y) - bent).squaredNorm() / 4);
      views[0].photograph.at<cv::Vec3b>(y, x) = cv::Vec3b::all(cv::saturate_cast<uchar>(light));
    }
  ASSERT_TRUE(writeOutsideFolder(views, {}, work(), MaskStyle::OpenMvs, {}).has_value());
  const cv::Mat photograph =
      cv::imread((work() / "images" / "0000.png").string(), cv::IMREAD_GRAYSCALE);
  ASSERT_EQ(photograph.size(), cv::Size(200, 160));
  const cv::Moments m = cv::moments(photograph);
  EXPECT_NEAR(m.m10 / m.m00, straight.x(), 0.05);
  EXPECT_NEAR(m.m01 / m.m00, straight.y(), 0.05);
  EXPECT_TRUE(fs::exists(work() / "masks" / "0007.mask.png"));
}

TEST_F(OutsideAdapter, KeepsTheCornersWithAnOwnSizeAndCentre) {
  std::vector<View> views = ballViews({}, 4);
  // Without a mask the corners show the object, too. Straight they lie 0.1721 off the axis, not
  // 0.1415: 22 px beyond across and 17 px along, for which there are two blocks of 16.
  views[0].camera.intrinsics.distortion = {{-6}};
  views[0].mask.release();
  ASSERT_TRUE(writeOutsideFolder(views, {}, work(), MaskStyle::OpenMvs, {}).has_value());
  const cv::Mat1b mask =
      cv::imread((work() / "masks" / "0000.mask.png").string(), cv::IMREAD_GRAYSCALE);
  EXPECT_EQ(mask.size(), cv::Size(264, 224));
  EXPECT_THAT(textOf(work() / "sparse" / "cameras.txt"),
              HasSubstr("\n1 PINHOLE 264 224 900 900 132 112\n"));
  EXPECT_THAT(textOf(work() / "sparse" / "cameras.txt"),
              HasSubstr("\n2 PINHOLE 200 160 900 900 100 80\n"));
}

TEST_F(OutsideAdapter, PaintsWhatIsNoObjectBlackForColmap) {
  const std::vector<View> views = ballViews({}, 4);
  ASSERT_TRUE(writeOutsideFolder(views, {}, work(), MaskStyle::Colmap, {}).has_value());
  const cv::Mat photograph =
      cv::imread((work() / "images" / "0003.png").string(), cv::IMREAD_COLOR);
  const cv::Mat1b mask =
      cv::imread((work() / "masks" / "0003.png.png").string(), cv::IMREAD_GRAYSCALE);
  ASSERT_EQ(mask.size(), photograph.size());
  cv::Mat1b dark;
  cv::inRange(photograph, cv::Scalar::all(0), cv::Scalar::all(0), dark);
  EXPECT_EQ(cv::countNonZero(dark != (255 - mask)), 0);
  // The ball's grey is above 0.6 times 40, the background's is 12.
  EXPECT_NEAR(cv::countNonZero(mask), cv::countNonZero(views[3].mask), 20);
}

TEST_F(OutsideAdapter, DropsWhatLiesBelowTheFloorOutsideTheMasksOrWithoutDirection) {
  const TexturedBall ball;
  const std::vector<View> views = ballViews(ball, 4);
  PointCloud cloud;
  const Eigen::Vector3f centre = ball.centre.cast<float>();
  cloud.points = {centre + Eigen::Vector3f(0, 0, 10), centre + Eigen::Vector3f(0, 0, 8),
                  centre + Eigen::Vector3f(25, 0, 0), centre + Eigen::Vector3f(0, 0, 9)};
  cloud.normals = {{0, 0, 2}, {0, 0, 1}, {0, 0, 1}, {0, 0, 0}};
  cloud.colors = {{10, 20, 30}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}};
  ASSERT_TRUE(writePly(folder_ / "fused.ply", cloud, "world").has_value());
  DenseOptions options;
  options.floor_z_mm = ball.centre.z() + 8.5;
  const auto read = readOutsideCloud(folder_ / "fused.ply", "X", "log.txt", views, options);
  ASSERT_TRUE(read.has_value()) << read.error().sentence();
  ASSERT_EQ(read->size(), 1U);
  EXPECT_EQ(read->points[0], cloud.points[0]);
  EXPECT_EQ(read->normals[0], Eigen::Vector3f(0, 0, 1));
  EXPECT_EQ(read->colors[0], (Color{10, 20, 30}));
}

// As of the built-in stereo's hull: one mask in 24.
TEST_F(OutsideAdapter, KeepsWhatTwoOf48MasksMiss) {
  const TexturedBall ball;
  std::vector<View> views = ballViews(ball, 24);
  views[0].mask.setTo(0);
  views[1].mask.setTo(0);
  PointCloud cloud;
  cloud.points = {ball.centre.cast<float>() + Eigen::Vector3f(0, 0, 10)};
  cloud.normals = {{0, 0, 1}};
  ASSERT_TRUE(writePly(folder_ / "fused.ply", cloud, "world").has_value());
  const DenseOptions options;
  const auto kept = readOutsideCloud(folder_ / "fused.ply", "X", "log.txt", views, options);
  ASSERT_TRUE(kept.has_value()) << kept.error().sentence();
  EXPECT_EQ(kept->size(), 1U);
  views[2].mask.setTo(0);
  EXPECT_FALSE(readOutsideCloud(folder_ / "fused.ply", "X", "log.txt", views, options).has_value());
}

TEST_F(OutsideAdapter, RefusesPointsWithoutNormals) {
  PointCloud cloud;
  cloud.points = {{3, -2, 20}};
  ASSERT_TRUE(writePly(folder_ / "fused.ply", cloud, "world").has_value());
  const auto read =
      readOutsideCloud(folder_ / "fused.ply", "X", "log.txt", ballViews({}, 4), DenseOptions());
  ASSERT_FALSE(read.has_value());
  EXPECT_EQ(read.error().code, ErrorCode::Failed);
  EXPECT_THAT(read.error().what, HasSubstr("without normals"));
}

// The real program: reads our text and writes binary.
TEST_F(OutsideAdapter, IsUnderstoodByColmap) {
  const std::vector<View> views = ballViews({}, 4);
  ASSERT_TRUE(writeOutsideFolder(views, {}, work(), MaskStyle::Colmap, {}).has_value());
  const auto colmap = colmap::findProgram("colmap");
  ASSERT_TRUE(colmap.has_value()) << "Install the package colmap (packaging/).";
  const colmap::ColmapModel ours = colmap::textModelIn(work() / "sparse");
  fs::create_directories(folder_ / "binary");
  const auto run =
      colmap::runProgram(*colmap,
                         {"model_converter", "--input_path", (work() / "sparse").string(),
                          "--output_path", (folder_ / "binary").string(), "--output_type", "BIN"},
                         folder_ / "log.txt", {});
  ASSERT_TRUE(run.has_value()) << textOf(folder_ / "log.txt");
  const auto theirs = colmap::readColmapModel(folder_ / "binary");
  ASSERT_TRUE(theirs.has_value()) << theirs.error().sentence();
  ASSERT_EQ(theirs->images.size(), 8U);
  ASSERT_EQ(theirs->points.size(), ours.points.size());
  EXPECT_EQ(theirs->cameras[2].parameters, ours.cameras[2].parameters);
  EXPECT_EQ(theirs->images[6].name, "0006.png");
  EXPECT_TRUE(
      theirs->images[6].camera_from_world.isApprox(ours.images[6].camera_from_world, 1e-12));
  EXPECT_EQ(theirs->images[6].observations.size(), ours.images[6].observations.size());
  EXPECT_LT((theirs->points[99].position - ours.points[99].position).norm(), 1e-9);
  EXPECT_EQ(theirs->points[99].track, ours.points[99].track);
}

}  // namespace
}  // namespace ostraka::stereo
