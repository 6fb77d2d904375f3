#include "rig/view_pose.h"

#include <gtest/gtest.h>

#include "simulated_rig.h"

namespace ostraka::rig {
namespace {

std::vector<PlacedMarker> seenBy(const Eigen::Isometry3d& camera_from_plate, int markers) {
  std::vector<SeenMarker> seen;
  const batch::Plate plate = ring(12);
  for (int k = 0; k < markers; ++k) {
    SeenMarker marker{k, {}, 0.05};
    for (int c = 0; c < 4; ++c)
      marker.corners[c] = lens(2600).project(camera_from_plate * plate.markers[k].corners[c]);
    seen.push_back(marker);
  }
  return placed(seen, plate);
}

TEST(PoseFromMarkers, FindsThePose) {
  const Eigen::Isometry3d truth = lookingDown(0.5, 0.2);
  const auto found = poseFromMarkers(seenBy(truth, 12), lens(2600));
  ASSERT_TRUE(found.has_value());
  EXPECT_TRUE(found->camera_from_plate.isApprox(truth, 1e-6));
}

TEST(PoseFromMarkers, OutvotesAForeignPattern) {
  const Eigen::Isometry3d truth = lookingDown(0.5, 0.2);
  std::vector<PlacedMarker> markers = seenBy(truth, 12);
  for (Eigen::Vector2d& corner : markers[5].seen.corners) corner += Eigen::Vector2d(-200, 90);
  const auto found = poseFromMarkers(markers, lens(2600));
  ASSERT_TRUE(found.has_value());
  EXPECT_FALSE(found->agrees[5]);
  EXPECT_TRUE(found->agrees[4]);
  EXPECT_TRUE(found->camera_from_plate.isApprox(truth, 1e-6));
}

TEST(PoseFromMarkers, GivesNothingForOneMarker) {
  EXPECT_FALSE(poseFromMarkers(seenBy(lookingDown(0.5, 0), 1), lens(2600)).has_value());
}

}  // namespace
}  // namespace ostraka::rig
