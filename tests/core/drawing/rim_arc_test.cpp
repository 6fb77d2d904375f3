#include "drawing/rim_arc.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/core/drawing/wall_piece.h"

namespace ostraka::drawing {
namespace {

TEST(RimArcs, TheLongestIsTheLip) {
  const std::vector<RimArc> arcs = findRimArcs(findWalls(wallPiece(false)));
  ASSERT_FALSE(arcs.empty());
  const RimArc& lip = arcs.front();
  // A radian at the middle of the wall, whose ends round off.
  EXPECT_NEAR(lip.length_mm, 57, 7);
  EXPECT_NEAR(lip.radius_mm, 57, 2);
  EXPECT_GT(lip.elsewhere_mm, 0.3) << "breaks";
  double length_mm = 0;
  for (std::size_t k = 0; k < lip.points.size(); ++k) {
    EXPECT_NEAR(lip.points[k].z(), 39, 2) << k;
    EXPECT_EQ(lip.points[k], lip.edge[(lip.start + k) % lip.edge.size()]);
    if (k > 0) length_mm += (lip.points[k] - lip.points[k - 1]).norm();
  }
  EXPECT_NEAR(lip.length_mm, length_mm, 1e-9);
}

TEST(RimArcs, OfBreaksAreShort) {
  double longest_mm = 0;
  for (const RimArc& arc : findRimArcs(findWalls(wallPiece(true))))
    longest_mm = std::max(longest_mm, arc.length_mm);
  EXPECT_LT(longest_mm, 25);
}

TEST(RimArcs, OfASherdWithoutWallsAreNone) {
  EXPECT_TRUE(findRimArcs(Walls()).empty());
}

}  // namespace
}  // namespace ostraka::drawing
