#include "calibration/lenses.h"

#include <gmock/gmock.h>

#include "tests/core/rig/simulated_rig.h"

namespace ostraka::calibration {
namespace {

TEST(Lenses, AreSharedByPhotographsOfOneSizeWithoutAWordFromTheCamera) {
  std::vector<batch::Shot> shots(4);
  for (batch::Shot& shot : shots) shot.width = 4000, shot.height = 3000, shot.file = "/nowhere.jpg";
  shots[1].width = 3000, shots[1].height = 4000;  // turned, or of another camera: nothing tells
  EXPECT_THAT(lensesOf(shots), testing::ElementsAre(0, 1, 0, 0));
}

// Twelve photographs by hand of a ring of markers, a tenth of a pixel off, with these focal
// lengths.
std::vector<TargetView> photographed(const std::vector<double>& focals) {
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0, 0.1);
  std::vector<TargetView> views;
  const batch::Plate plate = rig::ring(12);
  for (std::size_t k = 0; k < focals.size(); ++k) {
    rig::PosedImage image;
    image.intrinsics = rig::lens(focals[k]);
    image.camera_from_plate =
        rig::lookingDown(0.6 + 0.05 * static_cast<double>(k % 5), 0.55 * static_cast<double>(k));
    TargetView& view = views.emplace_back();
    for (const batch::Marker& marker : plate.markers)
      for (const Eigen::Vector3d& corner : marker.corners) {
        view.points.push_back(corner);
        view.pixels.push_back(image.project(corner) +
                              Eigen::Vector2d(noise(random), noise(random)));
      }
  }
  return views;
}

std::vector<int> told(const std::vector<double>& focals) {
  std::vector<batch::Shot> shots(focals.size());
  for (batch::Shot& shot : shots) shot.width = 1600, shot.height = 1200;
  return toldApart(std::vector<int>(focals.size(), 0), shots, photographed(focals));
}

TEST(Lenses, AreToldApartByAZoomThatNoExifTells) {
  const double wide = 1700, tele = 2400;
  const std::vector<int> lenses =
      told({wide, tele, wide, wide, tele, wide, tele, wide, wide, tele, wide, wide});
  EXPECT_THAT(lenses, testing::ElementsAre(0, 1, 0, 0, 1, 0, 1, 0, 0, 1, 0, 0));
}

TEST(Lenses, AreThreeWhereThreeCamerasBearOneName) {
  std::vector<double> focals;
  for (int k = 0; k < 4; ++k) focals.insert(focals.end(), {1600, 2100, 2900});
  const std::vector<int> lenses = told(focals);
  for (std::size_t k = 3; k < lenses.size(); ++k) EXPECT_EQ(lenses[k], lenses[k % 3]);
  EXPECT_NE(lenses[0], lenses[1]);
  EXPECT_NE(lenses[1], lenses[2]);
  EXPECT_NE(lenses[0], lenses[2]);
}

TEST(Lenses, StayOneThatBreathesWithItsFocus) {
  std::vector<double> focals;
  for (int k = 0; k < 12; ++k) focals.push_back(2000 * (1 + 0.02 * std::sin(1.7 * k)));
  EXPECT_THAT(told(focals), testing::Each(0));
}

TEST(Lenses, StayOneWhereTwoPhotographsAloneWereZoomed) {
  std::vector<double> focals(12, 2000);
  focals[3] = focals[8] = 3000;  // a calibration of two would say nothing
  EXPECT_THAT(told(focals), testing::Each(0));
}

}  // namespace
}  // namespace ostraka::calibration
