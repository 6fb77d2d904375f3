#include "calibration/bundle_adjustment.h"

#include <gtest/gtest.h>

#include "tests/core/rig/simulated_rig.h"

namespace ostraka::calibration {
namespace {

constexpr int kMarkers = 12;

RigState disturbed(RigState state) {
  state.print_errors_mm.assign(kMarkers * 4, Eigen::Vector3d::Zero());
  for (RigState::Camera& camera : state.cameras)
    camera.camera_from_turntable =
        rig::rigid({0.01, -0.01, 0.02}, {1, -2, 3}) * camera.camera_from_turntable;
  for (int stop = 1; stop < 8; ++stop) state.angles_rad[0][stop] += 0.01;
  state.turntable_from_plate[0] = Eigen::Isometry3d::Identity();
  return state;
}

double worstProjection_px(const RigState& a, const RigState& b) {
  double worst = 0;
  for (int c = 0; c < 2; ++c)
    for (int side = 0; side < 2; ++side)
      for (int stop = 0; stop < 8; ++stop)
        for (const Eigen::Vector3d& p : {Eigen::Vector3d(60, 20, 0), Eigen::Vector3d(-70, -50, 15)})
          worst = std::max(worst,
                           (a.cameras[c].intrinsics.project(a.cameraFromPlate(c, side, stop) * p) -
                            b.cameras[c].intrinsics.project(b.cameraFromPlate(c, side, stop) * p))
                               .norm());
  return worst;
}

TEST(Adjust, FindsTheRigFromExactCornersWithKnownLenses) {
  const RigState truth = rig::trueRig();
  AdjustOptions options;
  options.cameras = Cameras::LensKnown;
  const auto found =
      adjust(disturbed(truth), rig::cornersSeen(truth, rig::ring(kMarkers), 0), {}, options);
  ASSERT_TRUE(found.has_value()) << found.error().sentence();
  EXPECT_LT(worstProjection_px(*found, truth), 0.01);
}

TEST(Adjust, KeepsKnownCamerasAndFindsAnglesAndPlate) {
  const RigState truth = rig::trueRig();
  RigState start = disturbed(truth);
  for (int c = 0; c < 2; ++c)
    start.cameras[c].camera_from_turntable = truth.cameras[c].camera_from_turntable;
  AdjustOptions options;
  options.cameras = Cameras::Known;
  const auto found = adjust(start, rig::cornersSeen(truth, rig::ring(kMarkers), 0.05), {}, options);
  ASSERT_TRUE(found.has_value());
  EXPECT_TRUE(
      found->cameras[0].camera_from_turntable.isApprox(truth.cameras[0].camera_from_turntable));
  EXPECT_LT(worstProjection_px(*found, truth), 0.05);
}

TEST(Adjust, TellsThePlatesSizeByKnownCamerasAtAFewStops) {
  const RigState truth = rig::trueRig();
  RigState start = disturbed(truth);
  for (int c = 0; c < 2; ++c)
    start.cameras[c].camera_from_turntable = truth.cameras[c].camera_from_turntable;
  std::vector<PlateCorner> corners = rig::cornersSeen(truth, rig::ring(kMarkers), 0.05);
  std::erase_if(corners, [](const PlateCorner& corner) { return corner.stop >= 3; });
  for (PlateCorner& corner : corners) corner.point *= 0.99;  // as a wrong plate.json would have it
  AdjustOptions options;
  options.cameras = Cameras::Known;
  const auto found = adjust(start, corners, {}, options);
  ASSERT_TRUE(found.has_value());
  EXPECT_NEAR(found->plate_scale, 1 / 0.99, 1e-4);  // 0.05 px of 400 px over hundreds of corners
  double worst = 0;
  for (const PlateCorner& corner : corners)
    worst = std::max(worst, residual(*found, corner).norm());
  EXPECT_LT(worst, 0.3);  // six standard deviations of the noise: nothing is left of the 1 %
  options.cameras = Cameras::LensKnown;
  EXPECT_EQ(adjust(*found, corners, {}, options)->plate_scale, 1) << "the plate gives the scale";
}

TEST(Adjust, IsNotPulledAwayByOneWrongMarker) {
  const RigState truth = rig::trueRig();
  std::vector<PlateCorner> corners = rig::cornersSeen(truth, rig::ring(kMarkers), 0.05);
  for (int k = 0; k < 4; ++k) corners[k].pixel.x() += 4;
  AdjustOptions options;
  options.cameras = Cameras::LensKnown;
  const auto found = adjust(disturbed(truth), corners, {}, options);
  ASSERT_TRUE(found.has_value());
  EXPECT_LT(worstProjection_px(*found, truth), 0.1);
  EXPECT_GT(residual(*found, corners[0]).norm(), 3);
}

TEST(Adjust, TurnsCamerasBehindAFisheyeAndKeepsItsTerms) {
  RigState truth = rig::trueRig();
  const rig::Distortion fisheye{{0.03, -0.01, 0.004, -0.001}, rig::Lens::Fisheye};
  truth.cameras[0].intrinsics.distortion = fisheye;
  truth.cameras[1].intrinsics.distortion = {{0.9, 0.1, 0, 0, 0, 1, 0.2, 0, 0.001, 0, -0.001, 0},
                                            rig::Lens::Full};
  for (RigState::Camera& camera : truth.cameras)
    camera.intrinsics.fx = camera.intrinsics.fy = 1300;  // wide: the lens shows
  RigState start = disturbed(truth);
  start.cameras[0].intrinsics.fx = start.cameras[0].intrinsics.fy = 1310;
  const auto found = adjust(start, rig::cornersSeen(truth, rig::ring(kMarkers), 0), {}, {});
  ASSERT_TRUE(found.has_value()) << found.error().sentence();
  EXPECT_EQ(found->cameras[0].intrinsics.distortion, fisheye);
  EXPECT_EQ(found->cameras[1].intrinsics.distortion, truth.cameras[1].intrinsics.distortion);
  EXPECT_NEAR(found->cameras[0].intrinsics.fx, 1300, 1);
  EXPECT_LT(worstProjection_px(*found, truth), 0.05);
}

// Twenty photographs by hand over a sheet of 6 x 4 markers that is bent by up to 4 mm: lenses
// breathe by 0.4 % and drift by 3 px.
struct ByHand {
  RigState truth;
  std::vector<PlateCorner> corners;
  OwnLenses lenses;
};

ByHand photographedByHand(double noise_px, const rig::Intrinsics& lens = rig::lens(2600),
                          double distance = 1) {
  std::mt19937 random(11);
  std::normal_distribution<double> normal(0, 1);
  std::uniform_real_distribution<double> height(0.45, 1.2), around(0, 2 * M_PI);
  ByHand hand;
  rig::SheetBend bend;
  bend.reach_mm = 150;
  bend.coefficients_mm = {3, -1, 1.5, 0.8, -0.5, 0.4, 0.6, 0, 0, 0, 0, -0.7};
  hand.truth.angles_rad = {std::vector<double>{0}, std::vector<double>{0}};
  hand.truth.bends[0] = bend;
  for (int i = 0; i < 20; ++i) {
    RigState::Camera& camera = hand.truth.cameras.emplace_back();
    camera.intrinsics = lens;
    camera.intrinsics.fx = camera.intrinsics.fy = lens.fx * (1 + 0.004 * normal(random));
    camera.intrinsics.cx += 3 * normal(random);
    camera.intrinsics.cy += 3 * normal(random);
    camera.camera_from_turntable = rig::lookingDown(height(random), around(random));
    camera.camera_from_turntable.translation() *= distance;
    hand.lenses.lens_of_camera.push_back(0);
    int point = 0;
    for (int column = -3; column < 3; ++column)
      for (int row = -2; row < 2; ++row)
        for (const Eigen::Vector2d& corner : {Eigen::Vector2d(0, 24), {24, 24}, {24, 0}, {0, 0}}) {
          const Eigen::Vector2d at = Eigen::Vector2d(45 * column, 45 * row) + corner;
          const Eigen::Vector3d bent(at.x(), at.y(), bend.at(at.x(), at.y()));
          const Eigen::Vector2d pixel =
              camera.intrinsics.project(camera.camera_from_turntable * bent) +
              noise_px * Eigen::Vector2d(normal(random), normal(random));
          hand.corners.push_back(
              {i, 0, 0, point++, {at.x(), at.y(), 0}, pixel, Eigen::Vector2d(0, 0), 0.1});
        }
  }
  return hand;
}

// From a flat sheet, poses that are off, and one lens.
Result<RigState> adjustedByHand(const ByHand& hand, const rig::Intrinsics& lens) {
  RigState start = hand.truth;
  start.bends = {};
  start.print_errors_mm.assign(2 * 96, Eigen::Vector3d::Zero());
  for (RigState::Camera& camera : start.cameras) {
    camera.intrinsics = lens;
    camera.camera_from_turntable =
        rig::rigid({0.01, -0.01, 0.02}, {1, -2, 6}) * camera.camera_from_turntable;
  }
  AdjustOptions options;
  options.cameras = Cameras::Separate;
  options.lenses = hand.lenses;
  options.bend_sd_mm = 3;
  return adjust(start, hand.corners, {}, options);
}

TEST(Adjust, FindsPosesAndBendOfPhotographsByHandFromAFlatSheetAndOneLens) {
  const ByHand hand = photographedByHand(0.1);
  const auto found = adjustedByHand(hand, rig::lens(2570));
  ASSERT_TRUE(found.has_value()) << found.error().sentence();
  double worst_px = 0;
  for (std::size_t i = 0; i < 20; ++i)
    for (const Eigen::Vector3d& p : {Eigen::Vector3d(60, 20, 0), Eigen::Vector3d(-70, -50, 15)})
      worst_px = std::max(
          worst_px,
          (found->cameras[i].intrinsics.project(found->cameras[i].camera_from_turntable * p) -
           hand.truth.cameras[i].intrinsics.project(hand.truth.cameras[i].camera_from_turntable *
                                                    p))
              .norm());
  // Noise of 0.1 px in 96 corners leaves a tenth of a pixel of each pose; what a common tilt of
  // sheet and cameras leaves is the rest.
  EXPECT_LT(worst_px, 0.6);
  for (const Eigen::Vector2d& p : {Eigen::Vector2d(100, 60), Eigen::Vector2d(-120, 80)})
    EXPECT_NEAR(found->bends[0].at(p.x(), p.y()) - found->bends[0].at(0, 0),
                hand.truth.bends[0].at(p.x(), p.y()), 0.3);
}

// A telephone from 30 cm away sees the sheet out to where the term of sixth order moves it by half
// a pixel; what a flat sheet alone tells of that term may be wrong.
TEST(Adjust, FindsTheSixthOrderOfALensByHand) {
  rig::Intrinsics lens = rig::lens(1290);
  lens.distortion.terms = {0.05, -0.08, 0, 0, 0.1};
  const ByHand hand = photographedByHand(0.05, lens, 0.5);
  rig::Intrinsics first = rig::lens(1270);
  first.distortion.terms = {0.04, -0.03, 0, 0, -0.2};
  const auto found = adjustedByHand(hand, first);
  ASSERT_TRUE(found.has_value()) << found.error().sentence();
  for (const RigState::Camera& camera : found->cameras)
    EXPECT_NEAR(camera.intrinsics.distortion[4], 0.1, 0.05);
}

}  // namespace
}  // namespace ostraka::calibration
