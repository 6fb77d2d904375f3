#include "rendering/lighting.h"

#include <gtest/gtest.h>

#include "rendering/plate_surface.h"
#include "virtualrig/layout.h"
#include "virtualrig/setup.h"

namespace ostraka::rendering {
namespace {

// Light that comes off a sherd must have fallen on it first: below a sherd hardly any does. With
// surfaces that shone whether lit or not, the plate there had a tenth of the open light, in clay's
// colour.
TEST(Lighting, ThePlateUnderASherdIsDark) {
  virtualrig::SimulateOptions options;
  options.seed = 5;
  options.sherds = 1;
  const auto sherds = virtualrig::makeSherds(options);
  ASSERT_TRUE(sherds.has_value());
  vessels::Random random(2);
  const auto layout = virtualrig::layOut(*sherds, options, random);
  ASSERT_TRUE(layout.has_value());
  const Scene scene(*sherds, layout->front);
  const Lighting lighting = makeLighting(random);
  const PlateSurface plate(PlateColor::Grey, 3);
  const AmbientField ambient = gatherAmbient(scene, lighting, plate, 1, {.threads = 2});
  Eigen::Vector3f middle = Eigen::Vector3f::Zero();
  for (const Eigen::Vector3f& p : scene.vertices(0)) middle += p;
  middle /= static_cast<float>(scene.vertices(0).size());
  LightField lit;
  lit.plate.assign(ambient.plate.size(), {1, 1, 1});
  LightField::Shares shares;
  Eigen::Vector3f below, open;
  plateLight(lit, ambient, middle.head<2>(), shares, below);
  plateLight(lit, ambient, -middle.head<2>().normalized() * 120, shares, open);
  EXPECT_LT(below.maxCoeff(), 0.15 * open.minCoeff());
  EXPECT_GE(below.minCoeff(), 0);
}

}  // namespace
}  // namespace ostraka::rendering
