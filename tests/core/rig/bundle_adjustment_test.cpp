#include "rig/bundle_adjustment.h"

#include <gtest/gtest.h>

#include "simulated_rig.h"

namespace ostraka::rig {
namespace {

constexpr int kMarkers = 12;

RigState disturbed(RigState state) {
  state.print_errors_mm.assign(kMarkers * 4, Eigen::Vector3d::Zero());
  for (RigState::Camera& camera : state.cameras)
    camera.camera_from_turntable =
        rigid({0.01, -0.01, 0.02}, {1, -2, 3}) * camera.camera_from_turntable;
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
  const RigState truth = trueRig();
  AdjustOptions options;
  options.cameras = Cameras::LensKnown;
  const auto found = adjust(disturbed(truth), cornersSeen(truth, ring(kMarkers), 0), {}, options);
  ASSERT_TRUE(found.has_value()) << found.error().sentence();
  EXPECT_LT(worstProjection_px(*found, truth), 0.01);
}

TEST(Adjust, KeepsKnownCamerasAndFindsAnglesAndPlate) {
  const RigState truth = trueRig();
  RigState start = disturbed(truth);
  for (int c = 0; c < 2; ++c)
    start.cameras[c].camera_from_turntable = truth.cameras[c].camera_from_turntable;
  AdjustOptions options;
  options.cameras = Cameras::Known;
  const auto found = adjust(start, cornersSeen(truth, ring(kMarkers), 0.05), {}, options);
  ASSERT_TRUE(found.has_value());
  EXPECT_TRUE(
      found->cameras[0].camera_from_turntable.isApprox(truth.cameras[0].camera_from_turntable));
  EXPECT_LT(worstProjection_px(*found, truth), 0.05);
}

TEST(Adjust, TellsThePlatesSizeByKnownCamerasAtAFewStops) {
  const RigState truth = trueRig();
  RigState start = disturbed(truth);
  for (int c = 0; c < 2; ++c)
    start.cameras[c].camera_from_turntable = truth.cameras[c].camera_from_turntable;
  std::vector<PlateCorner> corners = cornersSeen(truth, ring(kMarkers), 0.05);
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
  const RigState truth = trueRig();
  std::vector<PlateCorner> corners = cornersSeen(truth, ring(kMarkers), 0.05);
  for (int k = 0; k < 4; ++k) corners[k].pixel.x() += 4;
  AdjustOptions options;
  options.cameras = Cameras::LensKnown;
  const auto found = adjust(disturbed(truth), corners, {}, options);
  ASSERT_TRUE(found.has_value());
  EXPECT_LT(worstProjection_px(*found, truth), 0.1);
  EXPECT_GT(residual(*found, corners[0]).norm(), 3);
}

}  // namespace
}  // namespace ostraka::rig
