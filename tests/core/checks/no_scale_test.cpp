#include "checks/no_scale.h"

#include <gtest/gtest.h>

namespace ostraka::checks {
namespace {

TEST(NoScale, MakesAPixelAFifthOfAMillimetreWhateverColmapsUnit) {
  colmap::ColmapPoses poses;
  poses.images.resize(1);
  poses.images[0].intrinsics = {1600, 1200, 2000, 2000, 800, 600, {}};
  // Depths 3, 4, 5 and one point behind the camera: the median pixel is 4 / 2000 units.
  poses.points = {{0, 0, 3}, {1, 0, 4}, {0, 1, 5}, {0, 0, -7}};
  EXPECT_DOUBLE_EQ(nominalScale(poses), 0.2 / (4.0 / 2000));
  const colmap::ColmapPoses sized = colmap::scaledTo(poses, nominalScale(poses));
  EXPECT_NEAR(nominalScale(sized), 1, 1e-12);
  poses.points.clear();
  EXPECT_EQ(nominalScale(poses), 1);
}

TEST(NoScale, ResizesOneSideAndKeepsWhatItsCamerasShow) {
  std::vector<rig::PosedImage> images(2);
  images[1].side = batch::Side::Back;
  for (rig::PosedImage& image : images) {
    image.intrinsics = {1600, 1200, 2000, 2000, 800, 600, {}};
    image.camera_from_plate.translation() = Eigen::Vector3d(1, 2, 50);
  }
  const Eigen::Vector3d point(3, -1, 4);
  const Eigen::Vector2d before = images[1].project(point);
  resizeSide(images, batch::Side::Back, 1.5);
  EXPECT_EQ(images[0].camera_from_plate.translation(), Eigen::Vector3d(1, 2, 50));
  EXPECT_LT((images[1].project(1.5 * point) - before).norm(), 1e-9);
}

}  // namespace
}  // namespace ostraka::checks
