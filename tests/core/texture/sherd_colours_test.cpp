#include "texture/sherd_colours.h"

#include <gtest/gtest.h>

#include "block.h"

namespace ostraka::texture {
namespace {

constexpr Color kUp = {200, 150, 100}, kDown = {90, 80, 70}, kBroken = {60, 50, 40};

// A tile whose top, underside and edges have a colour each; `bulge` lifts its middle, mm.
TexturedMesh tile(float bulge) {
  const TriangleMesh mesh = block({40, 30, 6}, 1, [&](const Eigen::Vector3f& p) {
    return Eigen::Vector3f(p.x(), p.y(), p.z() - bulge * p.head<2>().squaredNorm() / 400);
  });
  const std::vector<Chart> charts = chartsOf(mesh, 0.2);
  const Atlas atlas = packed(charts, 0.2);
  const Texels texels = texelsOf(charts, atlas);
  const UnwrappedMesh flat = unwrapped(mesh, charts, atlas);
  const SherdParts parts = partsOf(mesh);
  TexturedMesh model{flat.mesh, flat.uv, {}, atlas.texel_mm};
  model.texture.picture = cv::Mat3b(atlas.height, atlas.width, cv::Vec3b(255, 0, 255));
  model.texture.seen = cv::Mat1b(atlas.height, atlas.width, uchar{0});
  for (int y = 0; y < atlas.height; ++y)
    for (int x = 0; x < atlas.width; ++x) {
      if (texels.face(y, x) < 0) continue;
      const Part part = parts.of_face[static_cast<std::size_t>(texels.face(y, x))];
      const Color c = part == Part::Front ? kUp : part == Part::Back ? kDown : kBroken;
      model.texture.picture(y, x) = {c[2], c[1], c[0]};
      model.texture.seen(y, x) = 255;
    }
  return model;
}

TEST(SherdColours, AreThoseOfTheFacesAndTheFracture) {
  const SherdColours colours = coloursOf(tile(2));
  EXPECT_TRUE(colours.front_is_outer);
  EXPECT_EQ(colours.outer, kUp);
  EXPECT_EQ(colours.inner, kDown);
  EXPECT_EQ(colours.fracture, kBroken);
}

TEST(SherdColours, OfAHollowFrontHaveTheBackOutside) {
  const SherdColours colours = coloursOf(tile(-2));
  EXPECT_FALSE(colours.front_is_outer);
  EXPECT_EQ(colours.outer, kDown);
  EXPECT_EQ(colours.inner, kUp);
}

TEST(SherdColours, AreOfWhatPhotographsShowOnly) {
  TexturedMesh model = tile(2);
  // Highlights on less than half of the front; a back that was filled in.
  int at = 0;
  for (int y = 0; y < model.texture.picture.rows; ++y)
    for (int x = 0; x < model.texture.picture.cols; ++x) {
      const cv::Vec3b bgr = model.texture.picture(y, x);
      if (bgr == cv::Vec3b(kUp[2], kUp[1], kUp[0]) && ++at % 3 == 0)
        model.texture.picture(y, x) = {255, 255, 255};
      if (bgr == cv::Vec3b(kDown[2], kDown[1], kDown[0])) model.texture.seen(y, x) = 0;
    }
  const SherdColours colours = coloursOf(model);
  EXPECT_EQ(colours.outer, kUp) << "a median, not a mean";
  EXPECT_FALSE(colours.inner);
  EXPECT_EQ(colours.fracture, kBroken);
}

}  // namespace
}  // namespace ostraka::texture
