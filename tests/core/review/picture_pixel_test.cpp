#include "review/picture_pixel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace ostraka::review {
namespace {

// From 600 mm above the plate, straight down.
rig::PosedImage above(double focal_px) {
  rig::PosedImage image;
  image.intrinsics = {6000, 4000, focal_px, focal_px, 2999.5, 1999.5, {}};
  image.camera_from_plate.linear() =
      Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX()).toRotationMatrix();
  image.camera_from_plate.translation() = Eigen::Vector3d(0, 0, 600);
  return image;
}

std::vector<Eigen::Vector3f> cornersOf(float side_mm) {
  return {{0, 0, 0}, {side_mm, side_mm, 0}};
}

TEST(PicturePixel, IsThePhotographsOwnAsFarAsAWindowShowsThem) {
  EXPECT_NEAR(picturePixel_mm(above(6000), cornersOf(40)), 0.1, 1e-9);    // 600 / 6000
  EXPECT_NEAR(picturePixel_mm(above(10000), cornersOf(40)), 0.06, 1e-9);  // a finer photograph
  EXPECT_NEAR(picturePixel_mm(above(10000), cornersOf(60)), 60 / std::sqrt(6e5), 1e-6);
  EXPECT_EQ(picturePixel_mm(above(2000), cornersOf(40)), 0.15);  // drawn smoothly
  EXPECT_EQ(picturePixel_mm(above(10000), cornersOf(400)), 0.15);
}

}  // namespace
}  // namespace ostraka::review
