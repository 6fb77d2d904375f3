#include "texture/light.h"

#include <gtest/gtest.h>

#include <functional>
#include <random>

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
    made.points.push_back({i % 4, {}, 20 * normal});
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

// Sherds below a light of chance: ellipsoids whose clay is rougher than their models, so that all
// samples of a point share its normal's error, and neighbours some of it; shadows, noise. Some
// lights leave sides so dark that nine terms do not hold.
struct Scene {
  Light light;
  std::vector<LitPoint> points;
};

Scene sceneOf(unsigned seed) {
  std::mt19937 random(seed);
  const auto even = [&random] { return static_cast<double>(random()) / 4294967296.0; };
  const auto about = [&even](double spread) {
    return spread * (even() + even() + even() + even() - 2) * std::sqrt(3.0);
  };
  Scene scene;
  Light::Terms terms;
  terms << 1, about(0.2), about(0.2), 0.15 + 0.3 * even(), about(0.06), about(0.06), about(0.06),
      about(0.06), about(0.06);
  scene.light.coefficients.colwise() = terms / terms.dot(Light::terms(Vector3d::UnitZ()));
  const int sherds = 1 + static_cast<int>(seed % 8);
  std::vector<double> exposures;
  for (int i = 0; i < 32; ++i) exposures.push_back(std::exp(about(0.1)));
  for (int i = 0; i < 320; ++i) {
    const int sherd = i % sherds;
    const double flat = 6 + 3 * (sherd % 3), lean = 0.7 * sherd;
    const double z = 1 - (2 * (i / sherds) + 1) / std::ceil(320.0 / sherds), around = 2.399963 * i;
    const double r = std::sqrt(std::max(0.0, 1 - z * z));
    const Vector3d at(20 * r * std::cos(around), 15 * r * std::sin(around), flat * z);
    const Vector3d smooth = Vector3d(at.x() / 400, at.y() / 225, at.z() / (flat * flat));
    const Vector3d rough(std::sin(1.3 * at.y() + lean), std::sin(1.1 * at.x() + 2 * lean), 0);
    const Vector3d model = smooth.normalized(),
                   truth = (model + 0.05 * rough + 0.02 * Vector3d(about(1), about(1), about(1)))
                               .normalized();
    const double albedo = 0.2 + 0.2 * even();
    const bool is_shaded = even() < 0.05;
    scene.points.push_back({sherd, {}, at});
    int photograph = -1;
    for (const Side side : {Side::Front, Side::Back})
      for (const double elevation : {0.5, 1.0})
        for (int stop = 0; stop < 8; ++stop) {
          ++photograph;
          const Eigen::Matrix3d turn =
              lightFromMesh(side, stop * M_PI / 4) *
              Eigen::AngleAxisd(lean, Vector3d::UnitZ()).toRotationMatrix();
          const double cosine =
              (turn * model).dot(Vector3d(std::cos(elevation), 0, std::sin(elevation)));
          if (cosine < 0.3) continue;
          const double level = albedo * exposures[static_cast<std::size_t>(photograph)] *
                               scene.light.on(turn * truth)[0] * std::exp(about(0.03)) *
                               (is_shaded && stop < 3 ? 0.7 : 1.0);
          scene.points.back().samples.push_back(
              {photograph, turn * model, Vector3d::Constant(level), cosine});
        }
  }
  return scene;
}

TEST(LightOverSherds, IsAsUncertainAsItSays) {
  double within = 0, count = 0, errors = 0, stated = 0;
  int known = 0;
  for (unsigned seed = 1; seed <= 24; ++seed) {
    const Scene scene = sceneOf(seed);
    const Result<LightFit> found = lightOf(scene.points);
    if (!found) continue;
    ++known;
    double squares = 0, samples = 0;
    for (const LitPoint& point : scene.points)
      for (const LitPoint::Sample& s : point.samples) {
        const double off =
            std::abs(std::log(found->light.on(s.normal)[0] / scene.light.on(s.normal)[0]));
        within += off < 2 * found->uncertainty ? 1 : 0;
        squares += off * off;
        ++samples;
      }
    count += samples;
    errors += squares / samples;
    stated += found->uncertainty * found->uncertainty;
  }
  EXPECT_GE(known, 16);
  EXPECT_GE(within / count, 0.85) << "of 95 %";
  EXPECT_LT(std::sqrt(stated / errors), 2) << "nor far more uncertain than it is";
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
