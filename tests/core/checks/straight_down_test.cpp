#include "checks/straight_down.h"

#include <gtest/gtest.h>

#include <numbers>
#include <vector>

namespace ostraka::checks {
namespace {

rig::PosedImage tiltedBy(double degrees) {
  rig::PosedImage image;
  image.camera_from_plate.linear() =
      Eigen::AngleAxisd(std::numbers::pi * (1 + degrees / 180), Eigen::Vector3d::UnitX()).matrix();
  image.camera_from_plate.translation().z() = 500;
  return image;
}

TEST(StraightDown, IsToldWhereNoPhotographIsTilted) {
  std::vector<rig::PosedImage> images = {tiltedBy(0), tiltedBy(10), tiltedBy(-12)};
  EXPECT_TRUE(straightDown(images).has_value());
  images.push_back(tiltedBy(40));
  EXPECT_FALSE(straightDown(images).has_value());
  EXPECT_FALSE(straightDown({}).has_value());
}

}  // namespace
}  // namespace ostraka::checks
