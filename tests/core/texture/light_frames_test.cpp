#include "texture/light_frames.h"

#include <gtest/gtest.h>

#include "block.h"

namespace ostraka::texture {
namespace {

using batch::Side;
using Eigen::Vector3d;

Eigen::Isometry3d turnedBy(double angle) {
  return Eigen::Isometry3d(Eigen::AngleAxisd(angle, Vector3d::UnitZ()));
}

// Of one side: a camera that the plate turned below.
std::vector<rig::PosedImage> ring(Side side, double height_mm) {
  std::vector<rig::PosedImage> images;
  for (int i = 0; i < 12; ++i) {
    const double around = i * M_PI / 6;
    images.push_back(
        lookingAt({250 * std::cos(around), 250 * std::sin(around), height_mm}, {0, 0, 0}));
    images.back().side = side;
  }
  return images;
}

// A person's way around a sheet: each place has a height and a distance of its own.
std::vector<rig::PosedImage> byHand(Side side) {
  std::vector<rig::PosedImage> images;
  for (int i = 0; i < 12; ++i) {
    const double around = i * M_PI / 6, far_mm = 180 + 40 * (i % 3), high_mm = 120 + 35 * (i % 5);
    images.push_back(
        lookingAt({far_mm * std::cos(around), far_mm * std::sin(around), high_mm}, {0, 0, 0}));
    images.back().side = side;
  }
  return images;
}

TEST(LightFrames, AreTheTurntablesOfARig) {
  rig::Rig rig;
  rig::RigCamera camera;
  camera.camera_from_turntable = lookingAt({0, -300, 200}, {0, 0, 0}).camera_from_plate;
  rig.cameras = {camera};
  rig::PosedImage image;
  image.camera_from_plate = camera.camera_from_turntable * turnedBy(0.7);
  const auto frames = lightFrames({image}, rig);
  ASSERT_TRUE(frames.has_value());
  EXPECT_TRUE(frames->at(0).isApprox(turnedBy(0.7).linear(), 1e-9));
  image.camera = 1;
  EXPECT_FALSE(lightFrames({image}, rig)) << "no camera of the rig";
}

TEST(LightFrames, HaveACameraAtRestWhereItIs) {
  const std::vector<rig::PosedImage> images = ring(Side::Front, 200);
  const auto frames = lightFrames(images, {});
  ASSERT_TRUE(frames.has_value());
  for (std::size_t i = 0; i < images.size(); ++i)
    EXPECT_TRUE((frames->at(i) * images[i].centre()).isApprox(Vector3d(0, -250, 200), 1e-6)) << i;
}

TEST(LightFrames, AreThePlatesByHand) {
  std::vector<rig::PosedImage> images = byHand(Side::Front);
  const std::vector<rig::PosedImage> back = byHand(Side::Back);
  images.insert(images.end(), back.begin(), back.end());
  const auto frames = lightFrames(images, {});
  ASSERT_TRUE(frames.has_value());
  for (const Eigen::Matrix3d& frame : *frames) EXPECT_TRUE(frame.isIdentity());
}

TEST(LightFrames, AreNotGuessedWhereTheLightMayStandElsewhere) {
  std::vector<rig::PosedImage> twice = ring(Side::Front, 200);
  const std::vector<rig::PosedImage> lower = ring(Side::Front, 90), hand = byHand(Side::Back);
  std::vector<rig::PosedImage> mixed = twice;
  twice.insert(twice.end(), lower.begin(), lower.end());
  EXPECT_FALSE(lightFrames(twice, {})) << "a camera in two places";
  mixed.insert(mixed.end(), hand.begin(), hand.end());
  EXPECT_FALSE(lightFrames(mixed, {})) << "a side on a turning plate and a side by hand";
}

}  // namespace
}  // namespace ostraka::texture
