#include "texture/atlas.h"

#include <gtest/gtest.h>

#include "block.h"

namespace ostraka::texture {
namespace {

TEST(Atlas, LaysChartsSideBySideWithAMargin) {
  const TriangleMesh tile = block({40, 30, 6}, 2);
  const std::vector<Chart> charts = chartsOf(tile, 0.25);
  const Atlas atlas = packed(charts, 0.25);
  EXPECT_DOUBLE_EQ(atlas.texel_mm, 0.25);
  for (std::size_t a = 0; a < charts.size(); ++a) {
    const Eigen::Vector2i low = atlas.places[a];
    const Eigen::Vector2i high = low + (charts[a].size / 0.25).cast<int>();
    EXPECT_GE(low.minCoeff(), 8);
    EXPECT_LE(high.x() + 8, atlas.width);
    EXPECT_LE(high.y() + 8, atlas.height);
    for (std::size_t b = a + 1; b < charts.size(); ++b) {
      const Eigen::Vector2i other_low = atlas.places[b];
      const Eigen::Vector2i other_high = other_low + (charts[b].size / 0.25).cast<int>();
      const bool are_apart = (other_low.array() > high.array() + 15).any() ||
                             (low.array() > other_high.array() + 15).any();
      EXPECT_TRUE(are_apart) << a << " " << b;
    }
  }
  // Two faces of 160 x 120 texels and 560 x 24 of fracture, at most half as much again with
  // margins.
  EXPECT_LT(atlas.width * atlas.height, 1.5 * 1.5 * (2 * 160 * 120 + 560 * 24));
}

TEST(Atlas, CoarsensTexelsRatherThanGrowBeyondItsLimit) {
  const TriangleMesh tile = block({40, 30, 6}, 2);
  const std::vector<Chart> charts = chartsOf(tile, 0.25);
  const Atlas atlas = packed(charts, 0.01, 1024);
  EXPECT_LE(std::max(atlas.width, atlas.height), 1024);
  EXPECT_GT(atlas.texel_mm, 0.04);
  EXPECT_LT(atlas.texel_mm, 0.15);
}

TEST(Atlas, KnowsTheFaceOfEachTexelAndWhereOnIt) {
  const TriangleMesh tile = block({40, 30, 6}, 2);
  const std::vector<Chart> charts = chartsOf(tile, 0.25);
  const Atlas atlas = packed(charts, 0.25);
  const Texels texels = texelsOf(charts, atlas);
  int of_front = 0;
  for (int y = 0; y < atlas.height; ++y)
    for (int x = 0; x < atlas.width; ++x) {
      if (texels.face(y, x) < 0) continue;
      const auto& t = tile.triangles[static_cast<std::size_t>(texels.face(y, x))];
      const Eigen::Vector3d p = pointOf(tile, texels, x, y);
      if (tile.normals[t[0]].z() < 0.99f || p.z() < 5.99) continue;
      ++of_front;
      // The front's chart is the view from above, its first texel the far left corner.
      EXPECT_NEAR(p.x(), (x - atlas.places[0].x()) * 0.25 - 20, 0.01);
      EXPECT_NEAR(p.y(), 15 - (y - atlas.places[0].y()) * 0.25, 0.01);
    }
  EXPECT_GT(of_front, 140 * 100);
}

TEST(Atlas, GivesEachVertexAPlaceThatItsTexelsConfirm) {
  const TriangleMesh tile = block({40, 30, 6}, 2);
  const std::vector<Chart> charts = chartsOf(tile, 0.25);
  const Atlas atlas = packed(charts, 0.25);
  const UnwrappedMesh unwrapped = texture::unwrapped(tile, charts, atlas);
  EXPECT_EQ(unwrapped.mesh.triangles.size(), tile.triangles.size());
  EXPECT_EQ(unwrapped.uv.size(), unwrapped.mesh.vertices.size());
  EXPECT_EQ(unwrapped.mesh.normals.size(), unwrapped.mesh.vertices.size());
  EXPECT_LT(unwrapped.mesh.vertices.size(), 1.4 * tile.vertices.size())
      << "only those on borders are there twice";
  const Texels texels = texelsOf(charts, atlas);
  for (const auto& t : unwrapped.mesh.triangles) {
    const Eigen::Vector2f middle =
        (unwrapped.uv[t[0]] + unwrapped.uv[t[1]] + unwrapped.uv[t[2]]) / 3;
    const int x = static_cast<int>(middle.x() * atlas.width),
              y = static_cast<int>(middle.y() * atlas.height);
    ASSERT_GE(texels.face(y, x), 0);
    const auto& there = tile.triangles[static_cast<std::size_t>(texels.face(y, x))];
    const Eigen::Vector3f a = (unwrapped.mesh.vertices[t[0]] + unwrapped.mesh.vertices[t[1]] +
                               unwrapped.mesh.vertices[t[2]]) /
                              3;
    const Eigen::Vector3f b =
        (tile.vertices[there[0]] + tile.vertices[there[1]] + tile.vertices[there[2]]) / 3;
    EXPECT_LT((a - b).norm(), 1.5f) << "the same face or one beside it";
  }
}

}  // namespace
}  // namespace ostraka::texture
