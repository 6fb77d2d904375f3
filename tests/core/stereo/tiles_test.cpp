#include "stereo/tiles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "cloud/nearest.h"
#include "textured_ball.h"

namespace ostraka::stereo {
namespace {

// From 400 mm above: a coarsest picture of 400 x 400 pixels of 0.4 mm, 0.1 mm at full size.
Frame fromAbove() {
  Frame frame;
  frame.width = frame.height = 400;
  frame.fx = frame.fy = 1000;
  frame.cx = frame.cy = 199.5F;
  frame.rotation << 1, 0, 0, 0, -1, 0, 0, 0, -1;
  frame.translation = {0, 0, 400};
  frame.centre = {0, 0, 400};
  return frame;
}

// Cubes of 1 mm; two blocks of 30 x 20 x 4 mm, 6 mm apart.
Hull twoBlocks() {
  Hull hull;
  hull.size = {66, 20, 4};
  hull.origin = {-32.5F, -9.5F, 0.5F};
  hull.inside.assign(66 * 20 * 4, 1);
  for (std::size_t c = 0; c < hull.inside.size(); ++c)
    if (c % 66 >= 30 && c % 66 < 36) hull.inside[c] = 0;
  return hull;
}

std::vector<Tile> tilesOfBlocks(double most_pixels) {
  const Hull hull = twoBlocks();
  const Frame frame = fromAbove();
  const std::vector<const Frame*> frames(3, &frame);
  const std::vector<cv::Rect> wholes(3, cv::Rect(0, 0, 1600, 1600));
  return tilesOf(hull, frames, 4, wholes, most_pixels);
}

TEST(Tiles, OneHoldsAllWhereItsPixelsAreFewEnough) {
  const std::vector<Tile> tiles = tilesOfBlocks(1e9);
  ASSERT_EQ(tiles.size(), 1U);
  EXPECT_TRUE(tiles[0].owns({1e6F, -1e6F, 0}));
  ASSERT_EQ(tiles[0].parts.size(), 3U);
  const cv::Rect part = tiles[0].parts[0];
  // 66 x 20 mm at a tenth of a millimetre, the cubes' halves and what lies beside.
  EXPECT_NEAR(part.width, 660 + 52, 16);
  EXPECT_NEAR(part.height, 200 + 52, 16);
  EXPECT_EQ(part.x % 4, 0);
  EXPECT_EQ(part.y % 4, 0);
  EXPECT_NEAR(tiles[0].middle.x(), 0, 0.1);
}

TEST(Tiles, AreCutBetweenThings) {
  const std::vector<Tile> tiles = tilesOfBlocks(3 * 120'000.0);
  ASSERT_EQ(tiles.size(), 2U);
  for (const float x : {-32.0F, -3.5F}) EXPECT_TRUE(tiles[0].owns({x, 0, 2}));
  for (const float x : {3.5F, 32.0F}) EXPECT_TRUE(tiles[1].owns({x, 0, 2}));
  // 40 pixels' widths around, which are 4 mm.
  EXPECT_NEAR(tiles[0].reach.max().x(), -3.5 + 4 + 1, 0.6);
  for (const Tile& tile : tiles) EXPECT_LT(tile.parts[0].area(), 120'000);
}

TEST(Tiles, APlaceBelongsToOneOfThem) {
  const std::vector<Tile> tiles = tilesOfBlocks(3 * 60'000.0);
  ASSERT_GT(tiles.size(), 2U);
  for (float x = -40; x < 40; x += 0.7F)
    for (float y = -15; y < 15; y += 0.9F)
      EXPECT_EQ(1, std::count_if(tiles.begin(), tiles.end(),
                                 [&](const Tile& tile) { return tile.owns({x, y, 2}); }));
}

TEST(Tiles, NoneIsSmallerThanWhatLiesAroundIt) {
  // 4 mm around: lengths below 12 mm stay whole, whatever the memory.
  for (const Tile& tile : tilesOfBlocks(1)) {
    EXPECT_GT(tile.reach.sizes().x(), 2 * 4 + 5);
    EXPECT_GT(tile.reach.sizes().y(), 2 * 4 + 5);
  }
}

// Twelve photographs of 500 x 400 pixels, 0.09 mm each; a third of what they take at once.
TEST(Tiles, PartsTogetherAreTheWholeWithoutASeam) {
  const TexturedBall ball;
  const std::vector<View> views = ballViews(ball, 6, 0, 2.5);
  DenseOptions options;
  options.threads = 2;
  options.floor_z_mm = ball.centre.z();
  QuietProgress quiet;
  const Result<Reconstruction> whole = reconstruct(views, options, quiet, {});
  options.memory_mb = 25;
  const Result<Reconstruction> parts = reconstruct(views, options, quiet, {});
  ASSERT_TRUE(whole && parts);
  const auto n = static_cast<double>(whole->cloud.size());
  EXPECT_NEAR(static_cast<double>(parts->cloud.size()), n, 0.03 * n);
  EXPECT_NE(parts->cloud.size(), whole->cloud.size()) << "it was not divided";
  EXPECT_NEAR(parts->agreement.coveredShare(), whole->agreement.coveredShare(), 0.02);
  EXPECT_NEAR(parts->agreement.confirmedShare(), whole->agreement.confirmedShare(), 0.02);
  std::vector<double> off;
  for (const Eigen::Vector3f& p : parts->cloud.points)
    off.push_back(std::abs((p.cast<double>() - ball.centre).norm() - ball.radius_mm));
  std::sort(off.begin(), off.end());
  EXPECT_LT(off[off.size() * 9 / 10], 0.05);
  // Wherever the whole has a point, the parts have one no farther than two points' distance.
  const KdTree tree(parts->cloud.points);
  std::size_t missing = 0;
  std::vector<Neighbour> near;
  for (const Eigen::Vector3f& p : whole->cloud.points) {
    tree.within(p, 0.2F, near);
    missing += near.empty() ? 1 : 0;
  }
  EXPECT_LT(static_cast<double>(missing), 0.002 * n);
}

}  // namespace
}  // namespace ostraka::stereo
