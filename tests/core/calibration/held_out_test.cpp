#include "calibration/held_out.h"

#include <gtest/gtest.h>

#include "tests/core/rig/simulated_rig.h"

namespace ostraka::calibration {
namespace {

TEST(HeldOut, DistancesComeFromTheRaysAlone) {
  const RigState truth = rig::trueRig();
  const batch::Plate plate = rig::ring(24);
  const std::vector<PlateCorner> corners = rig::cornersSeen(truth, plate, 0);
  const std::vector<std::size_t> chosen = markersToHoldOut(plate, corners);
  ASSERT_EQ(chosen.size(), 4U);
  // plate.json says all is 1 % smaller than it was photographed.
  batch::Plate small = plate;
  for (batch::Marker& marker : small.markers)
    for (Eigen::Vector3d& corner : marker.corners) corner *= 0.99;
  const auto distances = heldOutDistances(small, chosen, truth, corners);
  ASSERT_EQ(distances.size(), 2U);
  for (const HeldOutDistance& d : distances) {
    EXPECT_NEAR(d.measured_mm, 290, 1e-4);  // opposite markers, 145 mm from the axis
    EXPECT_NEAR(d.error(), 1 / 0.99 - 1, 1e-6);
  }
}

TEST(HeldOut, MoveOfACameraIsToldByTheOther) {
  const RigState known = rig::trueRig();
  RigState now = known;
  now.cameras[1].camera_from_turntable =
      rig::rigid({0, 0.01, 0}, {0, 0, 0}) * now.cameras[1].camera_from_turntable;
  now.cameras[1].camera_from_turntable.translate(Eigen::Vector3d(0, 0, 2));  // the eye goes down
  // A turntable's frame of its own changes nothing.
  for (RigState::Camera& camera : now.cameras)
    camera.camera_from_turntable =
        camera.camera_from_turntable * rig::rigid({0, 0, 0.3}, {0, 0, 5});
  const Move move = moveAgainst(known, now, 1, 0);
  EXPECT_NEAR(move.moved_mm, 2, 1e-9);
  EXPECT_NEAR(move.turned_rad, 0.01, 1e-9);
}

// A ray alone has no nearest point: the marker is where two views agree.
TEST(HeldOut, AMarkerInSpaceNeedsTwoViewsOfEachOfItsCorners) {
  const RigState truth = rig::trueRig();
  const batch::Plate plate = rig::ring(24);
  std::vector<PlateCorner> own = ofMarker(rig::cornersSeen(truth, plate, 0), 5);
  ASSERT_GE(own.size(), 8u);
  const auto found = cornersInSpace(truth, own);
  ASSERT_TRUE(found);
  for (std::size_t k = 0; k < 4; ++k)
    EXPECT_LT(((*found)[k] - plate.markers[5].corners[k]).norm(), 1e-4);
  own.resize(8);
  EXPECT_TRUE(cornersInSpace(truth, own));
  own.resize(7);
  EXPECT_FALSE(cornersInSpace(truth, own));
}

TEST(HeldOut, MarkersLieAQuarterOfATurnApartAndAreNoneOfFewerThanEight) {
  const RigState truth = rig::trueRig();
  batch::Plate plate = rig::ring(8);
  const std::vector<PlateCorner> corners = rig::cornersSeen(truth, plate, 0);
  const std::vector<std::size_t> chosen = markersToHoldOut(plate, corners);
  ASSERT_EQ(chosen.size(), 4u);
  for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ((chosen[(k + 1) % 4] + 8 - chosen[k]) % 8, 2u) << k;
  std::vector<PlateCorner> seven = corners;
  std::erase_if(seven, [](const PlateCorner& corner) { return corner.plate_point / 4 == 3; });
  EXPECT_TRUE(markersToHoldOut(plate, seven).empty());
}

TEST(HeldOut, TheSentenceTellsBothLengthsTheErrorAndItsSign) {
  EXPECT_FALSE(scaleDoubt({3, 9, 200, 200.59}));  // 0.3 % are 0.6 mm
  const auto longer = scaleDoubt({3, 9, 200, 201}), shorter = scaleDoubt({3, 9, 200, 199});
  ASSERT_TRUE(longer && shorter);
  EXPECT_NE(longer->english().find("markers 3 and 9, held out of the fit, are 201.00 mm apart "
                                   "instead of 200.00 (+1.00 mm, +0.500 %)"),
            std::string::npos)
      << longer->english();
  EXPECT_NE(shorter->english().find("(-1.00 mm, -0.500 %)"), std::string::npos)
      << shorter->english();
}

}  // namespace
}  // namespace ostraka::calibration
