#include <gmock/gmock.h>
#include <unistd.h>

#include <map>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <tuple>

#include "batch/photograph.h"
#include "calibration/calibrate.h"
#include "calibration/held_out.h"

// Figures against the truth of the demo batch; only tests read truth/.
namespace ostraka::rig {
namespace {

const std::filesystem::path kDemo = OSTRAKA_SHARED_DIR "/batches/demo";

struct Errors {
  double worst_px = 0;        // over points 0..15 mm above the inner 100 mm of the plate
  double worst_turn_deg = 0;  // of camera_from_plate
  double worst_shift_mm = 0;
  double worst_focal_pct = 0;
};

std::vector<Eigen::Vector3d> innerZone() {
  std::vector<Eigen::Vector3d> points;
  for (double z = 0; z <= 15; z += 7.5)
    for (double x = -100; x <= 100; x += 20)
      for (double y = -100; y <= 100; y += 20)
        if (x * x + y * y <= 1e4) points.emplace_back(x, y, z);
  return points;
}

Errors against(const std::vector<PosedImage>& images) {
  using Key = std::tuple<batch::Side, int, int>;
  std::map<Key, PosedImage> truth;
  const std::vector<PosedImage> cameras = *readCameras(kDemo / "truth/cameras.json");
  for (const PosedImage& image : cameras)
    truth.emplace(Key(image.side, image.camera, image.stop), image);
  Errors errors;
  for (const PosedImage& image : images) {
    const PosedImage& t = truth.at({image.side, image.camera, image.stop});
    for (const Eigen::Vector3d& p : innerZone())
      errors.worst_px = std::max(errors.worst_px, (image.project(p) - t.project(p)).norm());
    const Eigen::Isometry3d d = image.camera_from_plate * t.camera_from_plate.inverse();
    const double turn_deg = Eigen::AngleAxisd(d.linear()).angle() * 180 / M_PI;
    const double shift_mm =
        (image.camera_from_plate.translation() - t.camera_from_plate.translation()).norm();
    errors.worst_turn_deg = std::max(errors.worst_turn_deg, turn_deg);
    errors.worst_shift_mm = std::max(errors.worst_shift_mm, shift_mm);
    errors.worst_focal_pct =
        std::max(errors.worst_focal_pct, 100 * std::abs(image.intrinsics.fx / t.intrinsics.fx - 1));
  }
  return errors;
}

batch::Batch demo() {
  QuietProgress quiet;
  return *batch::readBatch(kDemo, {}, quiet);
}

batch::Batch stopsBelow(batch::Batch batch, int stops) {
  std::erase_if(batch.shots, [&](const batch::Shot& shot) { return shot.stop >= stops; });
  return batch;
}

Result<calibration::BatchPoses> pose(const batch::Batch& batch,
                                     const std::optional<Rig>& known = {}, int threads = 0) {
  QuietProgress quiet;
  calibration::PoseOptions options;
  options.threads = threads;
  return calibration::poseBatch(batch, known, options, quiet, {});
}

TEST(DemoRig, IsFoundToAFewHundredthsOfAPixel) {
  const auto poses = pose(demo());
  ASSERT_TRUE(poses.has_value()) << poses.error().sentence();
  ASSERT_EQ(poses->images.size(), 48U);
  const Errors errors = against(poses->images);
  EXPECT_LT(errors.worst_px, 0.03);        // measured 0.019
  EXPECT_LT(errors.worst_turn_deg, 0.05);  // measured 0.009
  EXPECT_LT(errors.worst_shift_mm, 0.15);  // measured 0.12
  EXPECT_LT(errors.worst_focal_pct, 0.1);  // measured 0.01
  EXPECT_LT(poses->reprojection_rms_px, 0.03);
  EXPECT_TRUE(poses->warnings.empty());
}

// A third of the markers painted over, and with them a whole view of one camera.
batch::Batch covered(batch::Batch batch, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  const std::vector<PosedImage> truth = *readCameras(kDemo / "truth/cameras.json");
  for (batch::Shot& shot : batch.shots) {
    cv::Mat image = *batch::readPhotograph(shot.file);
    for (const PosedImage& t : truth) {
      if (t.side != shot.side || t.camera != shot.camera || t.stop != shot.stop) continue;
      for (const batch::Marker& marker : batch.plate->markers) {
        const bool lost_view = shot.camera == 1 && shot.stop == 2;
        if (marker.id >= 8 && !lost_view) continue;
        std::vector<cv::Point> outline;
        for (const Eigen::Vector3d& corner : marker.corners) {
          const Eigen::Vector2d p = t.project(corner);
          outline.emplace_back(cvRound(p.x()), cvRound(p.y()));
        }
        cv::fillConvexPoly(image, outline, cv::Scalar(60, 80, 120));
      }
    }
    shot.file = folder / (std::string(batch::name(shot.side)) + shot.file.filename().string());
    cv::imwrite(shot.file.string(), image);
  }
  return batch;
}

TEST(DemoRig, HoldsWithAThirdOfTheMarkersCoveredAndViewsLost) {
  const auto folder =
      std::filesystem::temp_directory_path() / (std::to_string(::getpid()) + "-covered");
  batch::Batch batch = covered(stopsBelow(demo(), 4), folder);
  std::erase_if(batch.shots,
                [](const batch::Shot& shot) { return shot.camera == 2 && shot.stop == 1; });
  const auto poses = pose(batch);
  std::filesystem::remove_all(folder);
  ASSERT_TRUE(poses.has_value()) << poses.error().sentence();
  ASSERT_EQ(poses->images.size(), batch.shots.size());
  EXPECT_EQ(std::count(poses->markers_per_image.begin(), poses->markers_per_image.end(), 0), 2);
  EXPECT_LT(against(poses->images).worst_px, 0.1);
}

TEST(DemoRig, IsTheSameForAnyNumberOfThreads) {
  const batch::Batch batch = stopsBelow(demo(), 2);
  const auto one = pose(batch, {}, 1), five = pose(batch, {}, 5);
  ASSERT_TRUE(one.has_value() && five.has_value());
  for (std::size_t i = 0; i < one->images.size(); ++i)
    EXPECT_EQ(one->images[i].camera_from_plate.matrix(),
              five->images[i].camera_from_plate.matrix());
}

TEST(DemoRig, IsReusedForAnotherBatchWithoutCalibrationPictures) {
  const auto first = pose(stopsBelow(demo(), 4));
  ASSERT_TRUE(first.has_value());
  batch::Batch second = demo();
  std::erase_if(second.shots, [](const batch::Shot& shot) { return shot.stop < 4; });
  second.calibration.clear();
  const auto poses = pose(second, first->rig);
  ASSERT_TRUE(poses.has_value()) << poses.error().sentence();
  EXPECT_TRUE(poses->warnings.empty());
  EXPECT_EQ(poses->rig.cameras[0].intrinsics.fx, first->rig.cameras[0].intrinsics.fx);
  EXPECT_LT(against(poses->images).worst_px, 0.05);
}

TEST(DemoRig, SaysThatAMovedCameraNoLongerFitsAndRecovers) {
  const batch::Batch batch = stopsBelow(demo(), 3);
  auto first = pose(batch);
  ASSERT_TRUE(first.has_value());
  first->rig.cameras[1].camera_from_turntable.translation().x() += 3;
  const auto poses = pose(batch, first->rig);
  ASSERT_TRUE(poses.has_value()) << poses.error().sentence();
  EXPECT_THAT(poses->warnings, testing::Contains(testing::HasSubstr("camera B")));
  EXPECT_LT(against(poses->images).worst_px, 0.05);
}

// A known rig carries the scale: it must not be thrown away because a plate contradicts it.
TEST(DemoRig, AKnownRigTellsAPlateSaidSmallerAtAnyNumberOfStops) {
  const auto first = pose(stopsBelow(demo(), 4));
  ASSERT_TRUE(first.has_value());
  for (const int stops : {1, 3}) {
    batch::Batch batch = stopsBelow(demo(), stops);
    batch.calibration.clear();
    for (batch::Marker& marker : batch.plate->markers)
      for (Eigen::Vector3d& corner : marker.corners) corner *= 0.99;
    const auto poses = pose(batch, first->rig);
    ASSERT_TRUE(poses.has_value()) << poses.error().sentence();
    ASSERT_EQ(poses->held_out.size(), 2U);
    for (const calibration::HeldOutDistance& distance : poses->held_out)
      EXPECT_NEAR(distance.error(), 1 / 0.99 - 1, 3e-4) << stops;  // 0.09 of 287 mm
    EXPECT_THAT(poses->warnings, testing::Contains(testing::HasSubstr("The scale is wrong")));
    EXPECT_THAT(poses->warnings,
                testing::Not(testing::Contains(testing::HasSubstr("no longer fits"))));
  }
}

TEST(DemoRig, ManagesWithoutCalibrationPicturesAndSaysSo) {
  batch::Batch batch = demo();
  batch.calibration.clear();
  const auto poses = pose(batch);
  ASSERT_TRUE(poses.has_value()) << poses.error().sentence();
  EXPECT_THAT(poses->warnings, testing::Contains(testing::HasSubstr("add 12 pictures")));
  // The principal point is not determined; what the plate's zone sees of it stays small.
  EXPECT_LT(against(poses->images).worst_px, 1.0);
}

}  // namespace
}  // namespace ostraka::rig
