#include "texture/light.h"

#include <gtest/gtest.h>

#include <functional>

#include "texture/bake.h"
#include "turned_light.h"

namespace ostraka::texture {
namespace {

using batch::Side;
using Eigen::Vector3d;

// Of a sphere's points of unlike albedo, eight stops of both sides, two cameras.
struct Sphere {
  std::vector<LitPoint> points;
  std::vector<double> albedos;
};

template <class Seen>
Sphere sphere(const Light& light, Seen seen) {
  Sphere made;
  for (int i = 0; i < 400; ++i) {
    const double z = 1 - (2 * i + 1) / 400.0, around = 2.399963 * i;  // a spiral of even density
    const Vector3d normal(std::sqrt(1 - z * z) * std::cos(around),
                          std::sqrt(1 - z * z) * std::sin(around), z);
    made.albedos.push_back(0.3 * (1 + 0.5 * std::sin(3 * normal.x()) + 0.3 * z));
    made.points.push_back({i % 4, {}});
    int photograph = -1;
    for (const Side side : {Side::Front, Side::Back})
      for (const double elevation : {0.5, 1.0})
        for (int stop = 0; stop < 8; ++stop) {
          ++photograph;
          const Vector3d turned = lightFromMesh(side, stop * M_PI / 4) * normal;
          const double cosine = turned.dot(Vector3d(std::cos(elevation), 0, std::sin(elevation)));
          if (cosine < 0.3) continue;
          const double level =
              made.albedos.back() * light.on(turned)[0] * seen(i, photograph, side);
          made.points.back().samples.push_back(
              {photograph, turned, Vector3d::Constant(level), cosine});
        }
  }
  return made;
}

double plainly(int, int, Side) {
  return 1;
}

// The largest relative difference of the samples, without their light, from the albedos.
double worstAlbedo(const Sphere& of, const Light& light) {
  double worst = 0;
  for (std::size_t i = 0; i < of.points.size(); ++i)
    for (const LitPoint::Sample& s : of.points[i].samples)
      worst = std::max(worst, std::abs(s.light[0] / light.on(s.normal)[0] / of.albedos[i] - 1));
  return worst;
}

TEST(LightOverSherds, IsToldFromTheirColoursWhereAPlateTurnsBelowIt) {
  const Sphere of = sphere(lamp(), plainly);
  Light even;
  even.coefficients.row(0).setOnes();
  ASSERT_GT(worstAlbedo(of, even), 0.3) << "the light is far from even";
  const Result<LightFit> found = lightOf(of.points);
  ASSERT_TRUE(found.has_value()) << found.error().sentence();
  EXPECT_LT(worstAlbedo(of, found->light), 0.01);
  EXPECT_NEAR(found->light.on(Vector3d::UnitZ())[1], 1, 1e-9) << "brightness stays as it is";
  EXPECT_LT(found->uncertainty, 0.01);
}

TEST(LightOverSherds, LeavesBothSidesTheSameColour) {
  const Sphere of = sphere(lamp(), plainly);
  const Result<LightFit> found = lightOf(of.points);
  ASSERT_TRUE(found.has_value());
  // Of each point that both show: the mean logarithm in front of that in back.
  double lit = 0, even = 0;
  for (const LitPoint& point : of.points) {
    double as_lit[2] = {0, 0}, without[2] = {0, 0}, count[2] = {0, 0};
    for (const LitPoint::Sample& s : point.samples) {
      const std::size_t side = s.photograph < 16 ? 0 : 1;
      as_lit[side] += std::log(s.light[0]);
      without[side] += std::log(s.light[0] / found->light.on(s.normal)[0]);
      ++count[side];
    }
    if (count[0] * count[1] == 0) continue;
    lit = std::max(lit, std::abs(as_lit[0] / count[0] - as_lit[1] / count[1]));
    even = std::max(even, std::abs(without[0] / count[0] - without[1] / count[1]));
  }
  EXPECT_GT(lit, 0.1);
  EXPECT_LT(even, 0.01);
}

TEST(LightOverSherds, IsNotMistakenForExposuresHighlightsOrShadows) {
  const Sphere of = sphere(lamp(), [](int point, int photograph, Side side) {
    const int chance = (point * 31 + photograph * 17) % 20;
    return (side == Side::Back ? 1.3 : 1.0) * (chance == 0 ? 2.0 : chance == 1 ? 0.5 : 1.0);
  });
  const Result<LightFit> found = lightOf(of.points);
  ASSERT_TRUE(found.has_value()) << found.error().sentence();
  for (const LitPoint& point : of.points)
    for (const LitPoint::Sample& s : point.samples)
      EXPECT_NEAR(found->light.on(s.normal)[0] / lamp().on(s.normal)[0], 1, 0.05);
}

TEST(LightOverSherds, IsRefusedWhereNothingTurnsBelowIt) {
  EXPECT_EQ(lightOf({}).error().code, ErrorCode::NotEnough);
  // Each point keeps its normal: it may be dark itself, or stand in the dark.
  Sphere still = sphere(lamp(), plainly);
  for (LitPoint& point : still.points)
    for (LitPoint::Sample& s : point.samples) {
      s.normal = point.samples.front().normal;
      s.light = point.samples.front().light;
    }
  EXPECT_EQ(lightOf(still.points).error().code, ErrorCode::NotEnough);
}

TEST(LightOverSherds, IsTakenFromALevelInLinearLight) {
  Light light;
  light.coefficients.row(0).setConstant(0.75);
  light.coefficients.row(3).setConstant(0.25);  // 1 from above, 0.5 from below
  const Eigen::Vector3f level(137, 137, 137);   // a quarter of the light: 136.96
  EXPECT_NEAR(light.without(level, Vector3d::UnitZ())[0], 137, 0.01);
  EXPECT_NEAR(light.without(level, -Vector3d::UnitZ())[2], 187.5, 0.2) << "half of it";
  light.coefficients.row(3).setConstant(0.75);
  EXPECT_EQ(light.on(-Vector3d::UnitZ())[0], 0.2) << "no more than five times as bright";
}

double spreadOf(const Texture& texture, const std::function<bool(int, int)>& wanted, double level) {
  double sum = 0, count = 0;
  for (int y = 0; y < texture.picture.rows; ++y)
    for (int x = 0; x < texture.picture.cols; ++x)
      if (texture.seen(y, x) != 0 && wanted(x, y)) {
        sum += std::pow(texture.picture(y, x)[1] - level, 2);
        ++count;
      }
  return std::sqrt(sum / count);
}

TEST(LightOverSherds, LeavesAGreySherdGreyAllAround) {
  const TriangleMesh mesh = ellipsoid();
  const std::vector<View> views = turnedBelow(lamp());
  const std::vector<LitPoint> points = litPoints(mesh, views, 0, 400, 2);
  ASSERT_GT(points.size(), 200u);
  const Result<LightFit> found = lightOf(points);
  ASSERT_TRUE(found.has_value()) << found.error().sentence();

  const std::vector<Chart> charts = chartsOf(mesh, 0.4);
  const Atlas atlas = packed(charts, 0.4);
  const Texels texels = texelsOf(charts, atlas);
  QuietProgress quiet;
  const Texture albedo = *bake(mesh, charts, atlas, views, found->light, 2, quiet, {}),
                photo = *bake(mesh, charts, atlas, views, {}, 2, quiet, {});
  const auto everywhere = [](int, int) { return true; };
  const double grey = 169.6;  // 0.4 of the light
  EXPECT_LT(spreadOf(albedo, everywhere, grey), 2.5);
  EXPECT_LT(2 * spreadOf(albedo, everywhere, grey), spreadOf(photo, everywhere, grey))
      << "as photographed it is darker towards the edge";
  for (const bool above : {false, true}) {
    const auto half = [&](int x, int y) { return (pointOf(mesh, texels, x, y).z() > 0) == above; };
    EXPECT_LT(spreadOf(albedo, half, grey), 2.5) << (above ? "front" : "back");
  }
}

}  // namespace
}  // namespace ostraka::texture
