#include "calibration/rig_start.h"

#include <gtest/gtest.h>

#include "tests/core/rig/simulated_rig.h"

namespace ostraka::calibration {
namespace {

const std::vector<int> kStops{0, 1, 2, 3, 4, 5, 6, 7};

std::vector<ViewPose> allViews(const RigState& truth) {
  std::vector<ViewPose> views;
  for (int c = 0; c < 2; ++c)
    for (int side = 0; side < 2; ++side)
      for (int stop = 0; stop < 8; ++stop)
        views.push_back({c, side, stop, truth.cameraFromPlate(c, side, stop), 10});
  return views;
}

RigState onlyLenses() {
  RigState state;
  state.cameras.resize(2);
  return state;
}

double worstAngle(const RigState& a, const RigState& b) {
  double worst = 0;
  for (int c = 0; c < 2; ++c)
    for (int side = 0; side < 2; ++side)
      for (int stop = 0; stop < 8; ++stop)
        worst =
            std::max(worst, Eigen::AngleAxisd(a.cameraFromPlate(c, side, stop).linear() *
                                              b.cameraFromPlate(c, side, stop).linear().transpose())
                                .angle());
  return worst;
}

// The start takes the plate's normal for the axis, which is 0.004 rad off here.
constexpr double kTiltRad = 0.02;

TEST(StartRig, FindsCamerasAndAngles) {
  const RigState truth = rig::trueRig();
  const auto start = startRig(onlyLenses(), allViews(truth), kStops, Cameras::Free);
  ASSERT_TRUE(start.has_value());
  EXPECT_EQ(start->state.angles_rad[0][0], 0);
  EXPECT_LT(worstAngle(start->state, truth), kTiltRad);
}

// The best two views of a stop's three bear each other's name.
TEST(StartRig, FollowsMostViewsWhereOneBearsAnothersName) {
  RigState truth = rig::trueRig();
  truth.cameras.push_back(truth.cameras[1]);
  truth.cameras[2].camera_from_turntable =
      truth.cameras[1].camera_from_turntable *
      Eigen::Isometry3d(Eigen::AngleAxisd(0.6, Eigen::Vector3d::UnitZ()));
  std::vector<ViewPose> views;
  for (int c = 0; c < 3; ++c)
    for (int side = 0; side < 2; ++side)
      for (int stop = 0; stop < 8; ++stop) {
        const bool swapped = c == 1 && side == 0 && (stop == 3 || stop == 4);
        views.push_back({c, side, stop, truth.cameraFromPlate(c, side, swapped ? 7 - stop : stop),
                         swapped ? 20 : 10});
      }
  RigState lenses;
  lenses.cameras.resize(3);
  const auto start = startRig(lenses, views, kStops, Cameras::Free);
  ASSERT_TRUE(start.has_value());
  EXPECT_LT(worstAngle(start->state, truth), kTiltRad);
}

TEST(StartRig, BridgesLostViewsAndAWholeLostStop) {
  const RigState truth = rig::trueRig();
  std::vector<ViewPose> views = allViews(truth);
  // Camera 1 keeps two views of the back; stop 3 is seen by nobody.
  std::erase_if(views, [](const ViewPose& v) {
    return v.stop == 3 || (v.camera == 1 && (v.side == 0 || v.stop > 1));
  });
  const auto start = startRig(onlyLenses(), views, kStops, Cameras::Free);
  ASSERT_TRUE(start.has_value());
  EXPECT_FALSE(start->stop_measured[0][3]);
  EXPECT_LT(worstAngle(start->state, truth), kTiltRad);
}

TEST(StartRig, KeepsKnownCameras) {
  const RigState truth = rig::trueRig();
  RigState known = onlyLenses();
  for (int c = 0; c < 2; ++c)
    known.cameras[c].camera_from_turntable = truth.cameras[c].camera_from_turntable;
  const auto start = startRig(known, allViews(truth), kStops, Cameras::Known);
  ASSERT_TRUE(start.has_value());
  EXPECT_TRUE(start->state.cameras[1].camera_from_turntable.isApprox(
      truth.cameras[1].camera_from_turntable));
  EXPECT_LT(worstAngle(start->state, truth), kTiltRad);
}

TEST(StartRig, GivesNothingWithoutAnyViewOfASide) {
  std::vector<ViewPose> views = allViews(rig::trueRig());
  std::erase_if(views, [](const ViewPose& v) { return v.side == 1; });
  EXPECT_FALSE(startRig(onlyLenses(), views, kStops, Cameras::Free).has_value());
}

}  // namespace
}  // namespace ostraka::calibration
