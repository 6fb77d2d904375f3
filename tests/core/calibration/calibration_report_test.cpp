#include "calibration/calibration_report.h"

#include <gmock/gmock.h>

#include "calibration/calibration_advice.h"
#include "calibration/held_out.h"
#include "tests/core/rig/simulated_rig.h"

namespace ostraka::calibration {
namespace {

using testing::Contains;
using testing::HasSubstr;

CameraCalibration wellTaken() {
  CameraCalibration camera;
  camera.camera = 1;
  camera.pictures = 12;
  camera.tilted_pictures = 6;
  camera.corners_per_region.fill(40);
  camera.focal_px = 2600;
  camera.focal_sd_px = 0.5;
  camera.plate_residual_px = 0.05;
  return camera;
}

BatchPoses fourStops() {
  BatchPoses poses;
  for (int stop = 0; stop < 4; ++stop) {
    rig::PosedImage image;
    image.stop = stop;
    image.camera = 1;
    poses.images.push_back(image);
    poses.markers_per_image.push_back(24);
    poses.rig.stops.push_back(stop);
  }
  return poses;
}

CalibrationReport judged(const CameraCalibration& camera, const BatchPoses& poses,
                         std::vector<HeldOutDistance> held_out) {
  CalibrationReport report;
  report.cameras = {camera};
  report.held_out = std::move(held_out);
  adviseOnBoard(camera, report.missing);
  adviseOnPlate(poses, report);
  return report;
}

TEST(CalibrationAdvice, IsSilentWhenAllIsThere) {
  const auto report = judged(wellTaken(), fourStops(), {{0, 12, 290, 290.05}, {6, 18, 290, 290}});
  EXPECT_THAT(report.missing, testing::IsEmpty());
  EXPECT_EQ(report.verdict, Verdict::Good);
}

TEST(CalibrationAdvice, NamesTheRegionsThatTheBoardDoesNotReach) {
  CameraCalibration camera = wellTaken();
  camera.corners_per_region[0] = 0;
  camera.corners_per_region[5] = 3;
  const auto report = judged(camera, fourStops(), {{0, 12, 290, 290}});
  EXPECT_THAT(report.missing,
              Contains(HasSubstr("barely reaches the upper left and right middle")));
  EXPECT_EQ(report.verdict, Verdict::Usable);
}

TEST(CalibrationAdvice, AsksForTiltsStopsAndMarkers) {
  CameraCalibration camera = wellTaken();
  camera.tilted_pictures = 1;
  BatchPoses poses = fourStops();
  poses.rig.stops.pop_back();
  poses.markers_per_image[2] = 3;
  const auto report = judged(camera, poses, {{0, 12, 290, 290}});
  EXPECT_THAT(report.missing, Contains(HasSubstr("only 1 picture shows the board tilted")));
  EXPECT_THAT(report.missing, Contains(HasSubstr("Positions photographed: 3;")));
  EXPECT_THAT(report.missing,
              Contains(HasSubstr(
                  "Camera B sees fewer than six of the plate's markers at position front 3")));
}

TEST(CalibrationAdvice, HoldsARigWhoseScaleIsOff) {
  // 1 mm in 290 is 0.34 %, above the 0.3 % that hold a batch.
  const auto report = judged(wellTaken(), fourStops(), {{0, 12, 290, 291}});
  EXPECT_EQ(report.verdict, Verdict::NotUsable);
  EXPECT_FALSE(scaleIsRight(report));
  EXPECT_THAT(report.missing, Contains(HasSubstr("+1.00 mm, +0.345 %")));
}

TEST(CalibrationAdvice, HoldsARigThatMissesAHandMeasuredLength) {
  CalibrationReport report;
  report.cameras = {wellTaken()};
  report.held_out = {{0, 12, 290, 290}};
  report.lengths = {{{0, 12, 310}, 314}};
  adviseOnPlate(fourStops(), report);
  EXPECT_EQ(report.verdict, Verdict::NotUsable);
  EXPECT_FALSE(scaleIsRight(report));
  EXPECT_THAT(report.missing, Contains(HasSubstr("--ruler-measured")));
}

TEST(CalibrationAdvice, NamesACameraThatWasTouched) {
  CameraCalibration camera = wellTaken();
  camera.plate_residual_px = 1.3;
  const auto report = judged(camera, fourStops(), {{0, 12, 290, 290}});
  EXPECT_EQ(report.verdict, Verdict::NotUsable);
  EXPECT_THAT(report.verdict_in_words,
              HasSubstr("camera B misses the plate's markers by a median of 1.30 px"));
}

TEST(HeldOut, DistancesComeFromTheRaysAlone) {
  const RigState truth = rig::trueRig();
  const batch::Plate plate = rig::ring(24);
  const std::vector<PlateCorner> corners = rig::cornersSeen(truth, plate, 0);
  const std::vector<std::size_t> chosen = markersToHoldOut(plate, corners);
  ASSERT_EQ(chosen.size(), 4U);
  // plate.json says all is 1 % smaller than it was photographed.
  batch::Plate small = plate;
  for (batch::Marker& marker : small.markers)
    for (Eigen::Vector3d& corner : marker.corners) corner *= 0.99;
  const auto distances = heldOutDistances(small, chosen, truth, corners);
  ASSERT_EQ(distances.size(), 2U);
  for (const HeldOutDistance& d : distances) {
    EXPECT_NEAR(d.measured_mm, 290, 1e-4);  // opposite markers, 145 mm from the axis
    EXPECT_NEAR(d.error(), 1 / 0.99 - 1, 1e-6);
  }
}

TEST(HeldOut, MoveOfACameraIsToldByTheOther) {
  const RigState known = rig::trueRig();
  RigState now = known;
  now.cameras[1].camera_from_turntable =
      rig::rigid({0, 0.01, 0}, {0, 0, 0}) * now.cameras[1].camera_from_turntable;
  now.cameras[1].camera_from_turntable.translate(Eigen::Vector3d(0, 0, 2));  // the eye goes down
  // A turntable's frame of its own changes nothing.
  for (RigState::Camera& camera : now.cameras)
    camera.camera_from_turntable =
        camera.camera_from_turntable * rig::rigid({0, 0, 0.3}, {0, 0, 5});
  const Move move = moveAgainst(known, now, 1, 0);
  EXPECT_NEAR(move.moved_mm, 2, 1e-9);
  EXPECT_NEAR(move.turned_rad, 0.01, 1e-9);
}

TEST(CalibrateFolder, RefusesWhatIsNoFolder) {
  QuietProgress quiet;
  const auto report = calibrateFolder("/nonexistent", {}, quiet, {});
  ASSERT_FALSE(report.has_value());
  EXPECT_EQ(report.error().code, ErrorCode::UnusableInput);
}

}  // namespace
}  // namespace ostraka::calibration
