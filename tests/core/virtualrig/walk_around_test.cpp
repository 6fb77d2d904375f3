#include "virtualrig/walk_around.h"

#include <gtest/gtest.h>

namespace ostraka::virtualrig {
namespace {

TEST(WalkAround, EveryKindOfLightReachesTheSheet) {
  for (const rendering::LightKind kind :
       {rendering::LightKind::Window, rendering::LightKind::Lamp, rendering::LightKind::Flash,
        rendering::LightKind::Overcast, rendering::LightKind::Sun})
    for (int seed = 0; seed < 20; ++seed) {
      vessels::Random random(static_cast<std::uint64_t>(seed));
      const rendering::Lighting lighting = makeLighting(kind, random);
      const Eigen::Vector3f light =
          lighting.sky + rendering::directLight(lighting, Eigen::Vector3f::Zero(),
                                                Eigen::Vector3f::UnitZ(), {1, 1, 1});
      EXPECT_GT(light.minCoeff(), 0.25f);
      EXPECT_LT(light.maxCoeff(), 1.2f);
      // White balance has something to do, and not too much: lamps are warmest.
      EXPECT_LT(light.maxCoeff(), 1.25f * light.minCoeff());
    }
}

TEST(WalkAround, AFlashGoesWithTheCamera) {
  vessels::Random random(1);
  const rendering::Lighting lighting = makeLighting(rendering::LightKind::Flash, random);
  rendering::HandHeldOptions hand;
  hand.photographs = 3;
  const CameraModel model = cameraModel(rendering::CameraKind::Phone, random);
  for (const FreeShot& shot : walkAround(hand, model, 640, random)) {
    const Eigen::Vector3d eye = shot.camera_from_plate.inverse().translation();
    EXPECT_NEAR((withFlash(lighting, shot.camera_from_plate).lights[0].centre - eye).norm(), 15,
                0.1);
  }
}

}  // namespace
}  // namespace ostraka::virtualrig
