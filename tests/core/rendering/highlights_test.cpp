#include "rendering/highlights.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "vessels/clay.h"

namespace ostraka::rendering {
namespace {

Lighting oneLamp(double half_width) {
  Lighting lighting;
  for (Light& light : lighting.lights)
    light = softbox(0, 1, 500, half_width, half_width, Eigen::Vector3f::Zero());
  lighting.lights[0].strength = Eigen::Vector3f::Constant(0.6f);
  lighting.sky = Eigen::Vector3f::Zero();
  return lighting;
}

// Light that comes to an eye at this elevation, opposite of the lamp, which stands at one radian.
float seen(const Lighting& lighting, double elevation, float roughness) {
  const Eigen::Vector3f eye(static_cast<float>(-std::cos(elevation)), 0,
                            static_cast<float>(std::sin(elevation)));
  return highlights(lighting, Eigen::Vector3f::Zero(), Eigen::Vector3f::UnitZ(), eye, {1, 1, 1},
                    {1, roughness})
      .y();
}

TEST(Gloss, ALampIsMirroredWhereItsRayLeavesAndFadesBesideIt) {
  const Lighting lighting = oneLamp(20);
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
                1.01 * std::numbers::pi * 0.6 / solid * vessels::fresnel(std::sin(1.f)))
          << half_width << " " << roughness;
    }
}

}  // namespace
}  // namespace ostraka::rendering
