#include <gtest/gtest.h>

#include <numbers>

#include "rendering/highlights.h"
#include "rendering/plate_surface.h"
#include "vessels/clay.h"
#include "virtualrig/walk_around.h"

namespace ostraka::vessels {
namespace {

rendering::Lighting oneLamp(double half_width) {
  rendering::Lighting lighting;
  for (rendering::Light& light : lighting.lights)
    light = rendering::softbox(0, 1, 500, half_width, half_width, Eigen::Vector3f::Zero());
  lighting.lights[0].strength = Eigen::Vector3f::Constant(0.6f);
  lighting.sky = Eigen::Vector3f::Zero();
  return lighting;
}

// Light that comes to an eye at this elevation, opposite of the lamp, which stands at one radian.
float seen(const rendering::Lighting& lighting, double elevation, float roughness) {
  const Eigen::Vector3f eye(static_cast<float>(-std::cos(elevation)), 0,
                            static_cast<float>(std::sin(elevation)));
  return rendering::highlights(lighting, Eigen::Vector3f::Zero(), Eigen::Vector3f::UnitZ(), eye,
                               {1, 1, 1}, {1, roughness})
      .y();
}

TEST(Gloss, ALampIsMirroredWhereItsRayLeavesAndFadesBesideIt) {
  const rendering::Lighting lighting = oneLamp(20);
  const float peak = seen(lighting, 1, 0.15f);
  EXPECT_GT(peak, 5 * seen(lighting, 0.4, 0.15f));
  EXPECT_GT(peak, 5 * seen(lighting, 1.5, 0.15f));
  EXPECT_GT(peak, 3 * seen(lighting, 1, 0.4f)) << "rougher layers spread it";
}

// A mirror shows the lamp as bright as it is: pi E / solid angle, times what glass reflects.
TEST(Gloss, NoHighlightIsBrighterThanTheLampInGlass) {
  for (const double half_width : {5.0, 50.0, 300.0})
    for (const float roughness : {0.01f, 0.1f, 0.3f}) {
      const double solid = 4 * half_width * half_width / (500.0 * 500.0);
      EXPECT_LE(seen(oneLamp(half_width), 1, roughness),
                1.01 * std::numbers::pi * 0.6 / solid * fresnel(std::sin(1.f)))
          << half_width << " " << roughness;
    }
}

TEST(Gloss, GlassReflectsFourPercentAtRightAnglesAndAllAtGrazingOnes) {
  EXPECT_NEAR(fresnel(1), 0.04, 1e-6);
  EXPECT_NEAR(fresnel(0), 1, 1e-6);
}

TEST(Clay, WidenedOnesAreShinyAsOftenAsAskedAndOftenNeutral) {
  Random random(8);
  int shiny = 0, neutral = 0, black = 0, white = 0;
  for (int i = 0; i < 1000; ++i) {
    Clay clay = makeClay(false, random);
    widen(clay, 0.4, random);
    shiny += clay.shine.weight > 0;
    neutral += clay.body.maxCoeff() < 1.1f * clay.body.minCoeff();
    black += clay.body.maxCoeff() < 0.05f;
    white += clay.body.minCoeff() > 0.45f;
  }
  // Binomial: SD of 1000 draws of 0.4 is 15.
  EXPECT_NEAR(shiny, 400, 50);
  EXPECT_GT(neutral, 350);
  EXPECT_GT(black, 40);
  EXPECT_GT(white, 40);
}

TEST(rendering::PlateSurface, IsOfFourColoursFromDarkToWhite) {
  float last = 0;
  for (const rendering::PlateColor color :
       {rendering::PlateColor::Dark, rendering::PlateColor::Grey, rendering::PlateColor::Light,
        rendering::PlateColor::White}) {
    const float felt = rendering::PlateSurface(color, 1).felt().y();
    EXPECT_GT(felt, 1.5f * last);
    EXPECT_LT(felt, 0.72f);  // marker paper's
    last = felt;
  }
}

TEST(rendering::Lighting, EveryKindOfLightReachesTheSheet) {
  for (const rendering::LightKind kind :
       {rendering::LightKind::Window, rendering::LightKind::Lamp, rendering::LightKind::Flash,
        rendering::LightKind::Overcast, rendering::LightKind::Sun})
    for (int seed = 0; seed < 20; ++seed) {
      Random random(static_cast<std::uint64_t>(seed));
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

TEST(rendering::Lighting, AFlashGoesWithTheCamera) {
  Random random(1);
  const rendering::Lighting lighting = makeLighting(rendering::LightKind::Flash, random);
  rendering::HandHeldOptions hand;
  hand.photographs = 3;
  const virtualrig::CameraModel model =
      virtualrig::cameraModel(rendering::CameraKind::Phone, random);
  for (const virtualrig::FreeShot& shot : virtualrig::walkAround(hand, model, 640, random)) {
    const Eigen::Vector3d eye = shot.camera_from_plate.inverse().translation();
    EXPECT_NEAR(
        (virtualrig::withFlash(lighting, shot.camera_from_plate).lights[0].centre - eye).norm(), 15,
        0.1);
  }
}

}  // namespace
}  // namespace ostraka::vessels
