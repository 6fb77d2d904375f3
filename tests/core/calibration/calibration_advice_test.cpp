#include "calibration/calibration_advice.h"

#include <gmock/gmock.h>

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

TEST(CalibrationAdvice, WithoutBoardAndMarkersSaysWhatToTake) {
  CameraCalibration camera = wellTaken();
  camera.pictures = 0;
  camera.focal_sd_px = 0;
  const auto report = judged(camera, fourStops(), {});
  EXPECT_THAT(report.missing,
              testing::ElementsAre(HasSubstr("Camera B: take 12 pictures of the board"),
                                   HasSubstr("the scale is not checked")));
  EXPECT_EQ(report.verdict, Verdict::Usable);
  EXPECT_THAT(report.verdict_in_words, HasSubstr("for a trial only: the lens of camera B"));
}

// A thousandth of 2600 px.
TEST(CalibrationAdvice, AFocalLengthKnownToLessThanAThousandthIsNotGood) {
  CameraCalibration camera = wellTaken();
  camera.focal_sd_px = 2.59;
  EXPECT_EQ(judged(camera, fourStops(), {{0, 12, 290, 290}}).verdict, Verdict::Good);
  camera.focal_sd_px = 2.61;
  const auto report = judged(camera, fourStops(), {{0, 12, 290, 290}});
  EXPECT_EQ(report.verdict, Verdict::Usable);
  EXPECT_THAT(report.verdict_in_words, HasSubstr("uncertain by more than a thousandth"));
}

}  // namespace
}  // namespace ostraka::calibration
