#include "rig/turntable.h"

#include <gtest/gtest.h>

#include <random>

namespace ostraka::rig {
namespace {

Eigen::Isometry3d lookingAt(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  const Eigen::Vector3d z = (to - from).normalized();
  const Eigen::Vector3d x = Eigen::Vector3d::UnitZ().cross(-z).normalized();
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear().row(0) = x;
  pose.linear().row(1) = z.cross(x);
  pose.linear().row(2) = z;
  pose.translation() = -pose.linear() * from;
  return pose;
}

// A camera at rest; the plate lies `off` the turntable's axis and turns by `step_deg` a photograph.
void addRing(std::vector<PosedImage>& images, double height, int count, double step_deg,
             const Eigen::Vector2d& off = {0, 0}, double wobble_rad = 0) {
  const Eigen::Isometry3d camera_from_room = lookingAt({0, -350, height}, {5, 10, 0});
  for (int i = 0; i < count; ++i) {
    const double wobble = wobble_rad * std::sin(i);
    const Eigen::Isometry3d room_from_plate =
        Eigen::AngleAxisd(wobble, Eigen::Vector3d::UnitX()) *
        Eigen::AngleAxisd(i * step_deg * M_PI / 180, Eigen::Vector3d::UnitZ()) *
        Eigen::Translation3d(off.x(), off.y(), 0);
    PosedImage image;
    image.camera_from_plate = camera_from_room * room_from_plate;
    images.push_back(image);
  }
}

void addWalk(std::vector<PosedImage>& images, int count, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> scatter(0, 1);
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * M_PI * i / count;
    const double reach = 400 + 25 * scatter(random), height = 350 + 25 * scatter(random);
    PosedImage image;
    image.camera_from_plate = Eigen::AngleAxisd(0.05 * scatter(random), Eigen::Vector3d::UnitZ()) *
                              lookingAt({reach * std::cos(angle), reach * std::sin(angle), height},
                                        {15 * scatter(random), 15 * scatter(random), 0});
    images.push_back(image);
  }
}

TEST(Turntable, FindsWhereTheCameraStoodBesideAnAxisOffThePlatesMiddle) {
  std::vector<PosedImage> images;
  addRing(images, 200, 24, 15, {40, -25}, 0.008);
  addRing(images, 420, 12, 30, {40, -25}, 0.008);
  const auto places = turntablePlaces(images);
  ASSERT_TRUE(places);
  for (int i = 0; i < 24; ++i) {
    EXPECT_EQ((*places)[i].ring, 0) << i;
    EXPECT_EQ((*places)[i].stop, i);
  }
  for (int i = 24; i < 36; ++i) {
    EXPECT_EQ((*places)[i].ring, 1) << i;
    EXPECT_EQ((*places)[i].stop, i - 24);
  }
}

TEST(Turntable, AnglesAreFree) {
  std::vector<PosedImage> images;
  addRing(images, 300, 17, 23.7);
  const auto places = turntablePlaces(images);
  ASSERT_TRUE(places);
  for (const TurntablePlace& place : *places) EXPECT_EQ(place.ring, 0);
}

TEST(Turntable, WhatWasTakenFromElsewhereBelongsNowhere) {
  std::vector<PosedImage> images;
  addRing(images, 300, 20, 18);
  addWalk(images, 3, 1);
  const auto places = turntablePlaces(images);
  ASSERT_TRUE(places);
  for (int i = 0; i < 20; ++i) EXPECT_EQ((*places)[i].ring, 0) << i;
  for (int i = 20; i < 23; ++i) EXPECT_EQ((*places)[i].ring, -1) << i;
}

TEST(Turntable, AWalkAroundTheSheetIsNone) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    std::vector<PosedImage> images;
    addWalk(images, 30, seed);
    EXPECT_FALSE(turntablePlaces(images)) << seed;
  }
}

TEST(Turntable, APlateThatStoodIsNone) {
  std::vector<PosedImage> images;
  addRing(images, 300, 12, 0.5);
  EXPECT_FALSE(turntablePlaces(images));
  EXPECT_FALSE(turntablePlaces({}));
}

}  // namespace
}  // namespace ostraka::rig
