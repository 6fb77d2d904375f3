#include "virtualrig/coverage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stop_token>

#include "virtualrig/predict.h"

namespace ostraka::virtualrig {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

VirtualRig standardRig() {
  vessels::Random random(5);
  return makeRig(800, 8, random);
}

VirtualRig without(VirtualRig rig, int camera) {
  rig.intrinsics.erase(rig.intrinsics.begin() + camera);
  rig.camera_from_room.erase(rig.camera_from_room.begin() + camera);
  return rig;
}

std::vector<vessels::VirtualSherd> twoSherds() {
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
  const auto whole = *coverage(sherds, rig, quick(), {});
  const auto part =
      *coverage(sherds, without(rig, 0), quick(), {});  // camera 0 stands at 25 degrees
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
  const auto a = *coverage(sherds, standardRig(), one, {}),
             b = *coverage(sherds, standardRig(), three, {});
  for (std::size_t i = 0; i < sherds.size(); ++i) EXPECT_EQ(a[i].seen, b[i].seen);
}

TEST(Coverage, StopsWhileRaysAreShot) {
  const auto sherds = twoSherds();
  std::stop_source stop;
  stop.request_stop();
  CoverageOptions endless = quick();  // hours of rays
  endless.least_views = 1'000'000'000;
  VirtualRig many = standardRig();
  many.angles_rad.assign(100'000, 0.0);
  const auto found = coverage(sherds, many, endless, stop.get_token());
  ASSERT_FALSE(found.has_value());
  EXPECT_EQ(found.error().code, ErrorCode::Cancelled);
  EXPECT_EQ(promisingMoves(sherds, many, endless, stop.get_token()).error().code,
            ErrorCode::Cancelled);
}

// The designed rig with its cameras at these elevations, degrees.
VirtualRig rigAt(std::array<double, 3> elevations) {
  VirtualRig rig = standardRig();
  for (int c = 0; c < 3; ++c) {
    Eigen::Isometry3d& pose = rig.camera_from_room[static_cast<std::size_t>(c)];
    pose = raised(pose, elevations[static_cast<std::size_t>(c)] * kDegree - elevation(rig, c));
  }
  return rig;
}

std::vector<CameraMove> movesOf(const VirtualRig& rig) {
  const auto moves = promisingMoves(twoSherds(), rig, quick(), {});
  EXPECT_TRUE(moves.has_value());
  return moves ? *moves : std::vector<CameraMove>();
}

double widestStepAfter(const VirtualRig& rig, const CameraMove& move) {
  std::vector<double> elevations;
  for (int c = 0; c < rig.cameras(); ++c)
    elevations.push_back(elevation(rig, c) + (c == move.camera ? move.raise_rad : 0));
  std::sort(elevations.begin(), elevations.end());
  double widest = 0;
  for (std::size_t c = 1; c < elevations.size(); ++c)
    widest = std::max(widest, elevations[c] - elevations[c - 1]);
  return widest / kDegree;
}

TEST(Coverage, RaisedTurnsACameraAboutThePlatesMiddle) {
  const VirtualRig rig = standardRig();
  const Eigen::Isometry3d& pose = rig.camera_from_room[1];
  VirtualRig moved = rig;
  moved.camera_from_room[1] = raised(pose, 10 * kDegree);
  EXPECT_NEAR(elevation(moved, 1), elevation(rig, 1) + 10 * kDegree, 1e-9);
  EXPECT_NEAR((moved.camera_from_room[1].translation() - pose.translation()).norm(), 0, 1e-9);
}

TEST(Coverage, LowersACameraWhenAllLookDownSteeply) {
  const auto moves = movesOf(rigAt({64, 65, 66}));
  ASSERT_FALSE(moves.empty());
  EXPECT_LT(moves.front().raise_rad, 0);
  EXPECT_GT(moves.front().gain, 0.01);
}

TEST(Coverage, RaisesACameraWhenAllLookAlongThePlate) {
  const auto moves = movesOf(rigAt({24, 26, 28}));
  ASSERT_FALSE(moves.empty());
  EXPECT_GT(moves.front().raise_rad, 0);
}

// From 26 to 64 degrees pictures do not match, however squarely the two low cameras look.
TEST(Coverage, ClosesAStepThatPicturesDoNotMatchOver) {
  const VirtualRig rig = rigAt({24, 26, 64});
  const auto moves = movesOf(rig);
  ASSERT_FALSE(moves.empty());
  EXPECT_LT(widestStepAfter(rig, moves.front()), 26);
}

// Rays alone would lower the middle camera of the designed rig beside the lowest, 40 degrees from
// the highest.
TEST(Coverage, OpensNoStepBetweenTheCamerasThatPicturesDoNotMatchOver) {
  for (const auto& elevations :
       {std::array{25.0, 44.0, 64.0}, std::array{30.0, 50.0, 70.0}, std::array{40.0, 50.0, 60.0}})
    for (const CameraMove& move : movesOf(rigAt(elevations)))
      EXPECT_LT(widestStepAfter(rigAt(elevations), move), 26.1);
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
  EXPECT_NE(predict({}, options, quiet, {}).error().what.english().find("work"), std::string::npos);
  options.work = "/tmp/unused";
  options.width = 99;
  EXPECT_NE(predict({}, options, quiet, {}).error().what.english().find("width"),
            std::string::npos);
}

}  // namespace
}  // namespace ostraka::virtualrig
