#include "capture/shot_checks.h"

#include <gtest/gtest.h>

#include "tests/core/capture/looked_at.h"

namespace ostraka::capture {
namespace {

TEST(TurnBetween, IsTheTableTurnWithoutAnyCalibration) {
  const PlateInspection start = lookAt({}, 0, 10);
  for (const double turn : {0.0, 1.0, 45.0, 90.0, 170.0, -120.0}) {
    const auto seen = turnBetween_deg(start, lookAt({}, 0, 10 + turn));
    ASSERT_TRUE(seen.has_value());
    EXPECT_NEAR(*seen, turn, 0.1);  // corners to 0.1 pixels at 150 pixels from the middle
  }
}

TEST(Judge, TellsAPhotographOfAnotherStop) {
  CameraReference reference;
  learn(reference, lookAt({}, 0, 0), 0);
  const ShotCheck right = checkOf(lookAt({}, 0, 45), 45, reference);
  EXPECT_TRUE(right.good());
  EXPECT_NEAR(*right.angle_seen_deg, 45, 0.1);
  const ShotCheck round = checkOf(lookAt({}, 0, 45), 405, reference);
  EXPECT_TRUE(round.good());
  const ShotCheck wrong = checkOf(lookAt({}, 0, 45), 90, reference);
  EXPECT_TRUE(wrong.has(ShotProblem::WrongStop));
  EXPECT_FALSE(wrong.keepable());
}

TEST(Judge, TellsLightThatDoesNotSuffice) {
  PlateInspection inspection = lookAt({}, 0, 0);
  inspection.dark_share = 0.5;
  inspection.bright_share = 0.1;
  const ShotCheck check = checkOf(inspection, 0, {});
  EXPECT_TRUE(check.has(ShotProblem::TooDark));
  EXPECT_TRUE(check.has(ShotProblem::TooBright));
  EXPECT_TRUE(check.keepable());
  EXPECT_FALSE(check.again());
}

TEST(Judge, AsksAgainWhenMarkersAreHidden) {
  CameraReference reference;
  const PlateInspection open = lookAt({}, 0, 0);
  learn(reference, open, 0);
  PlateInspection hidden = open;
  hidden.markers_seen = 5;
  EXPECT_TRUE(checkOf(hidden, 0, reference).again());
  hidden.markers_seen = 6;
  EXPECT_FALSE(checkOf(hidden, 0, reference).again());
}

}  // namespace
}  // namespace ostraka::capture
