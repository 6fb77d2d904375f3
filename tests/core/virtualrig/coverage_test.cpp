#include "virtualrig/coverage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "virtualrig/predict.h"

namespace ostraka::virtualrig {
namespace {

VirtualRig standardRig() {
  Random random(5);
  return makeRig(800, 8, random);
}

VirtualRig without(VirtualRig rig, int camera) {
  rig.intrinsics.erase(rig.intrinsics.begin() + camera);
  rig.camera_from_room.erase(rig.camera_from_room.begin() + camera);
  return rig;
}

std::vector<VirtualSherd> twoSherds() {
  SimulateOptions options;
  options.seed = 11;
  options.sherds = 2;
  options.radii_mm = {24, 13};
  return *makeSherds(options);
}

CoverageOptions quick() {
  CoverageOptions options;
  options.points_per_sherd = 500;
  return options;
}

TEST(Coverage, IsNearlyWholeForTheDesignedRigAndLessWithoutItsLowCamera) {
  const auto sherds = twoSherds();
  const VirtualRig rig = standardRig();
  const auto whole = coverage(sherds, rig, quick());
  const auto part = coverage(sherds, without(rig, 0), quick());  // camera 0 stands at 25 degrees
  for (std::size_t i = 0; i < sherds.size(); ++i) {
    EXPECT_GT(whole[i].seen, 0.95);
    EXPECT_EQ(whole[i].outside, 0);
    EXPECT_LT(part[i].break_seen, whole[i].break_seen);
  }
}

TEST(Coverage, IsTheSameForAnyNumberOfThreads) {
  CoverageOptions one = quick(), three = quick();
  one.threads = 1;
  three.threads = 3;
  const auto sherds = twoSherds();
  const auto a = coverage(sherds, standardRig(), one), b = coverage(sherds, standardRig(), three);
  for (std::size_t i = 0; i < sherds.size(); ++i) EXPECT_EQ(a[i].seen, b[i].seen);
}

TEST(Coverage, LowersACameraWhenAllLookDownSteeply) {
  VirtualRig rig = standardRig();
  for (int c = 0; c < 3; ++c)
    rig.camera_from_room[static_cast<std::size_t>(c)] =
        rig.camera_from_room[2];  // all at 64 degrees
  const auto advice = bestMove(twoSherds(), rig, quick(), {});
  ASSERT_TRUE(advice.has_value());
  EXPECT_LT(advice->raise_rad, 0);
  EXPECT_GT(advice->gain, 0.01);
}

// Rays alone would lower the middle camera beside the lowest: pictures 40 degrees apart do not
// match.
TEST(Coverage, OpensNoStepBetweenTheCamerasThatPicturesDoNotMatchOver) {
  const VirtualRig rig = standardRig();
  const auto advice = bestMove(twoSherds(), rig, quick(), {});
  ASSERT_TRUE(advice.has_value());
  std::vector<double> elevations;
  for (int c = 0; c < rig.cameras(); ++c)
    elevations.push_back(elevation(rig, c) + (c == advice->camera ? advice->raise_rad : 0));
  std::sort(elevations.begin(), elevations.end());
  for (std::size_t c = 1; c < elevations.size(); ++c)
    EXPECT_LT(elevations[c] - elevations[c - 1], 26.1 * std::numbers::pi / 180);
}

TEST(Coverage, KnowsWhereACameraStands) {
  const VirtualRig rig = standardRig();
  EXPECT_NEAR(elevation(rig, 1) * 180 / M_PI, 44, 3);  // 44 degrees, drawn within 2
  EXPECT_NEAR(pixelSize(rig, 0), 0.48, 0.03);          // 0.24 mm at 1600 pixels
}

TEST(AsVirtual, ScalesPicturesAndKeepsPlaces) {
  rig::Rig rig;
  rig::RigCamera camera;
  camera.intrinsics.width = 1600;
  camera.intrinsics.height = 1200;
  camera.intrinsics.fx = camera.intrinsics.fy = 2600;
  camera.intrinsics.cx = 799.5;
  camera.intrinsics.cy = 599.5;
  camera.camera_from_turntable.translation() = Eigen::Vector3d(1, 2, 600);
  rig.cameras = {camera};
  rig.stops = {0, 1};
  rig.stop_angles_rad = {0, 0.8};
  const VirtualRig half = asVirtual(rig, 800);
  EXPECT_EQ(half.intrinsics[0].height, 600);
  EXPECT_DOUBLE_EQ(half.intrinsics[0].fx, 1300);
  EXPECT_DOUBLE_EQ(half.intrinsics[0].cx, 399.5);  // the picture's middle stays its middle
  EXPECT_EQ(half.angles_rad[1], 0.8);
  EXPECT_EQ(half.camera_from_room[0].translation().z(), 600);
}

TEST(Predict, NamesTheFieldThatCannotBe) {
  QuietProgress quiet;
  PredictOptions options;
  EXPECT_NE(predict({}, options, quiet, {}).error().what.find("work"), std::string::npos);
  options.work = "/tmp/unused";
  options.width = 99;
  EXPECT_NE(predict({}, options, quiet, {}).error().what.find("width"), std::string::npos);
}

}  // namespace
}  // namespace ostraka::virtualrig
