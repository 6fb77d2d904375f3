#include "hull/hull.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>

namespace ostraka::hull {
namespace {

// Twelve cameras around a ball of 10 mm at z = 12, looking down by 35 degrees.
std::vector<rig::PosedImage> camerasAround() {
  std::vector<rig::PosedImage> images;
  for (int k = 0; k < 12; ++k) {
    rig::PosedImage image;
    image.intrinsics = {320, 240, 600, 600, 159.5, 119.5, {}};
    image.camera_from_plate.linear() =
        (Eigen::AngleAxisd(M_PI / 2 + 0.6, Eigen::Vector3d::UnitX()) *
         Eigen::AngleAxisd(k * M_PI / 6, Eigen::Vector3d::UnitZ()))
            .toRotationMatrix();
    image.camera_from_plate.translation() = Eigen::Vector3d(0, 0, 200);
    images.push_back(image);
  }
  return images;
}

class Hull : public testing::Test {
 protected:
  Hull() : images_(camerasAround()) {
    space_.low = Eigen::Vector3d(-20, -20, 0.5);
    space_.count = {41, 41, 30};
    for (const rig::PosedImage& image : images_) {
      HullView view{&image, cv::Mat1f(60, 80), cv::Mat1f(60, 80)};
      for (int y = 0; y < 60; ++y)
        for (int x = 0; x < 80; ++x) {
          const Eigen::Vector2d n = image.intrinsics.unproject({4 * x + 1.5, 4 * y + 1.5});
          const Eigen::Vector3d ray = n.homogeneous().normalized();
          const Eigen::Vector3d ball = image.camera_from_plate * Eigen::Vector3d(0, 0, 12);
          const bool hit = ball.cross(ray).norm() < 10;
          view.inside(y, x) = hit ? 1 : 0;
          view.clear(y, x) = hit ? 0 : 1;
        }
      views_.push_back(view);
    }
  }
  std::size_t index(int x, int y, int z) const {
    return (static_cast<std::size_t>(z) * space_.count.y() + y) * space_.count.x() + x;
  }
  std::vector<rig::PosedImage> images_;
  std::vector<HullView> views_;
  HullSpace space_;
};

TEST_F(Hull, KeepsTheBallAndEmptiesTheSpaceAround) {
  const auto voxels = carveHull(space_, views_, {}, {});
  EXPECT_EQ(voxels[index(20, 20, 11)], 1);
  EXPECT_EQ(voxels[index(28, 20, 11)], 1);
  EXPECT_EQ(voxels[index(33, 20, 11)], 0);
  EXPECT_EQ(voxels[index(2, 2, 1)], 0);
}

TEST_F(Hull, LeavesTheFloorBareWhereItsLowestLayerIsEmpty) {
  std::vector<unsigned char> voxels(
      static_cast<std::size_t>(space_.count.x()) * space_.count.y() * space_.count.z(), 0);
  voxels[index(25, 20, 0)] = 1;
  voxels[index(10, 20, 3)] = 1;  // above the floor
  EXPECT_FALSE(bareAt(space_, voxels, {5, 0}));
  EXPECT_TRUE(bareAt(space_, voxels, {-10, 0}));
  EXPECT_FALSE(bareAt(space_, voxels, {-21, 0})) << "beyond the space nothing is known";
}

TEST_F(Hull, OneViewThatIsWrongDoesNotEmptyIt) {
  views_[3].clear = 1;
  views_[3].inside = 0;
  EXPECT_EQ(carveHull(space_, views_, {}, {})[index(20, 20, 11)], 1);
}

// r - 0.3 r^3 grows up to 1.05 off the axis; what lies at 1.5 would come to 0.49, in the picture.
TEST(HullBehindALens, IsNotCarvedByViewsThatDoNotShowIt) {
  rig::PosedImage before, beside;
  before.intrinsics = beside.intrinsics = {320, 240, 300, 300, 159.5, 119.5, {}};
  before.camera_from_plate.translation() = Eigen::Vector3d(-150, 0, 0);
  beside.intrinsics.distortion[0] = -0.3;
  const cv::Mat1f none(60, 80, 0.0F), all(60, 80, 1.0F);
  HullSpace space;
  space.low = Eigen::Vector3d(150, 0, 100);
  space.count = {1, 1, 1};
  const std::vector<HullView> views{
      {&before, all, none}, {&before, all, none}, {&beside, none, all}, {&beside, none, all}};
  EXPECT_EQ(carveHull(space, views, {}, {}), std::vector<unsigned char>{1});
  EXPECT_GT(cv::countNonZero(silhouetteOfHull(space, {1}, views[0], {}).group), 0);
  EXPECT_EQ(cv::countNonZero(silhouetteOfHull(space, {1}, views[2], {}).group), 0);
}

TEST_F(Hull, IsTheSameForAnyNumberOfThreads) {
  HullOptions three;
  three.threads = 3;
  EXPECT_EQ(carveHull(space_, views_, {}, {}), carveHull(space_, views_, three, {}));
}

TEST_F(Hull, SilhouetteCoversWhatWasSeen) {
  const auto voxels = carveHull(space_, views_, {}, {});
  const cv::Mat1b shown = silhouetteOfHull(space_, voxels, views_[0], {}).group;
  int missed = 0;
  for (int y = 0; y < 60; ++y)
    for (int x = 0; x < 80; ++x)
      if (views_[0].inside(y, x) > 0 && shown(y, x) == 0) ++missed;
  EXPECT_LE(missed, 3);
  EXPECT_EQ(shown(2, 2), 0);
}

TEST_F(Hull, IsAsDeepBehindItsMiddleAsTheBallIsThick) {
  const auto voxels = carveHull(space_, views_, {}, {});
  const Silhouette shown = silhouetteOfHull(space_, voxels, views_[0], {});
  const Eigen::Vector2d middle =
      images_[0].intrinsics.project(images_[0].camera_from_plate * Eigen::Vector3d(0, 0, 12));
  const int x = static_cast<int>(middle.x()) / 4, y = static_cast<int>(middle.y()) / 4;
  EXPECT_NEAR(shown.depth(y, x), 20, 4);  // two voxels, and what no camera sees of the hull
  EXPECT_EQ(shown.depth(2, 2), 0);
}

TEST_F(Hull, SmallGroupsGoAndLargeOnesStay) {
  std::vector<unsigned char> voxels(41 * 41 * 30, 0);
  for (int y = 5; y < 15; ++y)
    for (int x = 5; x < 15; ++x) voxels[index(x, y, 0)] = 1;
  voxels[index(30, 30, 2)] = 1;
  for (int y = 25; y < 35; ++y)
    for (int x = 5; x < 15; ++x) voxels[index(x, y, 0)] = 1;
  EXPECT_EQ(dropSmallGroups(space_, voxels, 25), 2);
  EXPECT_EQ(voxels[index(7, 27, 0)], 2);
  EXPECT_EQ(voxels[index(30, 30, 2)], 0);
  EXPECT_EQ(voxels[index(7, 7, 0)], 1);
}

TEST_F(Hull, GroupsAtTheSidesGoUnlessThereAreNoOthers) {
  std::vector<unsigned char> voxels(41 * 41 * 30, 0);
  for (int y = 5; y < 15; ++y)
    for (int x = 0; x < 15; ++x) {
      voxels[index(x, y, 0)] = 1;
      voxels[index(x + 20, y, 0)] = 2;
    }
  std::vector<unsigned char> alone = voxels;
  dropGroupsAtSides(space_, voxels);
  EXPECT_EQ(voxels[index(7, 7, 0)], 0);
  EXPECT_EQ(voxels[index(27, 7, 0)], 2);
  std::replace(alone.begin(), alone.end(), static_cast<unsigned char>(2),
               static_cast<unsigned char>(0));
  dropGroupsAtSides(space_, alone);
  EXPECT_EQ(alone[index(7, 7, 0)], 1) << "a large thing on a ground of which little was seen";
}

TEST_F(Hull, WhatFloatsAboveThePlateAreRaysThatCrossByChance) {
  std::vector<unsigned char> voxels(41 * 41 * 30, 0);
  const int bridged = 2 + kMostGapLayers;
  for (int y = 5; y < 15; ++y)
    for (int x = 5; x < 15; ++x) {
      voxels[index(x, y, 12)] = 1;      // above nothing
      voxels[index(x + 20, y, 1)] = 1;  // stands on the plate
      voxels[index(x + 20, y, bridged)] = voxels[index(x + 20, y, 29)] = 1;
    }
  EXPECT_EQ(dropSmallGroups(space_, voxels, 25), 1);
  EXPECT_EQ(voxels[index(7, 7, 12)], 0);
  EXPECT_EQ(voxels[index(27, 7, 1)], 1);
  EXPECT_EQ(voxels[index(27, 7, bridged)], 1) << "a stripe of the plate's colour divides no thing";
  EXPECT_EQ(voxels[index(27, 7, 29)], 0) << "a cloud above a thing is none of it";
}

TEST(KeepTouching, TakesPartsOfASilhouetteThatNowhereShowBeforeTheFloor) {
  cv::Mat1b floor(20, 30, uchar{0}), group(20, 30, uchar{0});
  floor.rowRange(10, 20).setTo(255);
  group(cv::Rect(2, 2, 5, 12)).setTo(3);  // leans over the floor's edge
  group(cv::Rect(20, 2, 5, 6)).setTo(3);  // beyond it
  keepTouching(floor, group);
  EXPECT_EQ(group(3, 4), 3);
  EXPECT_EQ(group(4, 22), 0);
}

}  // namespace
}  // namespace ostraka::hull
