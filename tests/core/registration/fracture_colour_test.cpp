#include "registration/fracture_colour.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "registration/register_sides.h"
#include "simulated_sherd.h"

namespace ostraka::registration {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

// Stains of 2 to 4 mm through the whole clay; `pattern` makes another clay.
Color clayAt(const Vector3d& p, double pattern) {
  const auto wave = [&](double x, double y, double z, double phase) {
    return std::sin(x * p.x() + y * p.y() + z * p.z() + phase * pattern);
  };
  const double light = wave(1.9, 0.7, 1.3, 1) + wave(-0.8, 2.1, -1.1, 2) + wave(1.2, -1.4, 1.9, 3);
  const double red = wave(-1.5, 1.6, 0.9, 4) + wave(0.6, 1.3, -2.0, 5) + wave(2.2, 0.4, 0.8, 6);
  const auto byte = [](double x) { return static_cast<std::uint8_t>(std::lround(x)); };
  return {byte(150 + 12 * light + 12 * red), byte(120 + 12 * light), byte(90 + 10 * light)};
}

// raised_mm: how far light from above moves the detail towards each shot's viewer.
void paint(SimulatedSherd& sherd, double front_pattern, double back_pattern, double raised_mm = 0) {
  const Vector3d up = raised_mm * Vector3d::UnitZ();
  for (const Eigen::Vector3f& p : sherd.front.cloud.points)
    sherd.front.cloud.colors.push_back(clayAt(p.cast<double>() - up, front_pattern));
  for (const Eigen::Vector3f& p : sherd.back.cloud.points)
    sherd.back.cloud.colors.push_back(clayAt(sherd.truth * p.cast<double>() + up, back_pattern));
}

Isometry3d turned(const SimulatedSherd& sherd, double rad) {
  return Eigen::AngleAxisd(rad, Vector3d::UnitZ()) * sherd.truth;
}

Result<Registration> run(const SimulatedSherd& sherd, const std::vector<Isometry3d>& starts) {
  QuietProgress quiet;
  Constraints plates;
  plates.front_support = plates.back_support = rig::SheetBend{};
  return registerSides(*prepareStrip(sherd.front, {}), *prepareStrip(sherd.back, {}), starts,
                       plates, {}, quiet, {});
}

TEST(FractureColour, HoldsASmoothRoundSherdAlongItsContour) {
  SimulatedSherd sherd = simulatedSherd({.relief = 0});
  const Isometry3d start = turned(sherd, 0.02);  // 0.4 mm along the contour
  const auto slipOf = [&](const Result<Registration>& found) {
    const Vector3d edge(0, 20, 2.5);
    const Vector3d off = found->front_from_back * (sherd.truth.inverse() * edge) - edge;
    return std::abs(off.x() -
                    (found->front_from_back * (sherd.truth.inverse() * Vector3d(0, 0, 2.5))).x());
  };
  const auto plain = run(sherd, {start});
  ASSERT_TRUE(plain.has_value());
  EXPECT_TRUE(plain->check_failed);  // the shape does not tell where it belongs

  paint(sherd, 0, 0);
  const auto painted = run(sherd, {start});
  ASSERT_TRUE(painted.has_value());
  // A quarter of the points' spacing of 0.4 mm; by shape alone it stays about where it began.
  EXPECT_LT(slipOf(painted), 0.1);
  EXPECT_GT(slipOf(plain), 2 * slipOf(painted));
}

// Lumps of 1 to 4 mm in the wall of a disc, no two stretches of it alike.
void paintLumps(SimulatedSherd& sherd) {
  struct Lump {
    Vector3d at;
    double radius, red, light;
  };
  std::mt19937 random(7);
  const auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0; };
  std::vector<Lump> lumps;
  for (int k = 0; k < 150; ++k) {
    const double phi = 6.283185307 * uniform();
    lumps.push_back({Vector3d(20 * std::cos(phi), 20 * std::sin(phi), 5 * uniform()),
                     1 + 3 * uniform(), 60 * uniform() - 30, 60 * uniform() - 30});
  }
  const auto colourAt = [&](const Vector3d& p) {
    double red = 0, light = 0;
    for (const Lump& lump : lumps) {
      const double w = std::exp(-2 * (p - lump.at).squaredNorm() / (lump.radius * lump.radius));
      red += w * lump.red;
      light += w * lump.light;
    }
    const auto byte = [](double x) {
      return static_cast<std::uint8_t>(std::lround(std::clamp(x, 20.0, 250.0)));
    };
    return Color{byte(140 + light + red), byte(115 + light), byte(90 + light)};
  };
  for (const Eigen::Vector3f& p : sherd.front.cloud.points)
    sherd.front.cloud.colors.push_back(colourAt(p.cast<double>()));
  for (const Eigen::Vector3f& p : sherd.back.cloud.points)
    sherd.back.cloud.colors.push_back(colourAt(sherd.truth * p.cast<double>()));
}

TEST(FractureColour, FindsHowFarARoundSherdIsTurned) {
  SimulatedSherd sherd = simulatedSherd({.relief = 0});
  paintLumps(sherd);
  const auto found = run(sherd, {turned(sherd, 2.0)});
  ASSERT_TRUE(found.has_value());
  EXPECT_LT(rms_mm(found->front_from_back, sherd.truth, sherd.back), 0.2);  // half their spacing
  EXPECT_FALSE(found->check_failed) << found->reason;
}

TEST(FractureColour, ChooseBetweenStartsThatFitAlike) {
  SimulatedSherd sherd = simulatedSherd({.relief = 0});
  paint(sherd, 0, 0);
  const auto found = run(sherd, {turned(sherd, 1.0), turned(sherd, 0.01)});
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->start, 1);
  EXPECT_LT(rms_mm(found->front_from_back, sherd.truth, sherd.back), 0.2);
}

TEST(FractureColour, OfAnotherClayFindsNoTurn) {
  SimulatedSherd sherd = simulatedSherd({.relief = 0});
  paint(sherd, 0, 1.7);
  const auto found = run(sherd, {turned(sherd, 2.0)});
  ASSERT_TRUE(found.has_value());
  EXPECT_TRUE(found->check_failed);
}

TEST(FractureColour, IsLikelierAtTheTruePoseThanBesideIt) {
  SimulatedSherd sherd = simulatedSherd({});
  paint(sherd, 0, 0);
  const auto front = prepareStrip(sherd.front, {}), back = prepareStrip(sherd.back, {});
  const auto likelihoodAt = [&](double rad) {
    return correlateColours(front->fine, back->fine, turned(sherd, rad), {}).log_likelihood;
  };
  EXPECT_GT(likelihoodAt(0), 20);
  EXPECT_LT(likelihoodAt(0.06), 0.2 * likelihoodAt(0));  // 1.2 mm along the contour
}

TEST(FractureColour, OfAnotherClayLeavesASmoothSherdUncertain) {
  SimulatedSherd sherd = simulatedSherd({.relief = 0});
  paint(sherd, 0, 1.7);
  const auto found = run(sherd, {turned(sherd, 0.02)});
  ASSERT_TRUE(found.has_value());
  EXPECT_TRUE(found->check_failed);
}

TEST(FractureColour, MovedByLightFromAboveHardlyMovesTheHeight) {
  SimulatedSherd still = simulatedSherd({}), lit = still;
  paint(still, 0, 0);
  paint(lit, 0, 0, 0.08);  // 0.16 mm between the two shots
  const auto a = run(still, {still.truth}), b = run(lit, {lit.truth});
  ASSERT_TRUE(a.has_value() && b.has_value());
  // A quarter: clean strips and the plate hold the height four times as well as colours may.
  EXPECT_LT(rms_mm(a->front_from_back, b->front_from_back, lit.back), 0.04);
}

TEST(FractureColour, WithoutColoursOrLikenessIsSilent) {
  SimulatedSherd sherd = simulatedSherd({});
  const auto informationOf = [&](const SimulatedSherd& s) {
    const auto front = prepareStrip(s.front, {}), back = prepareStrip(s.back, {});
    return fitColours(front->fine, back->fine, s.truth, Vector3d::Zero(), {}).evidence.information;
  };
  EXPECT_EQ(informationOf(sherd).norm(), 0);
  SimulatedSherd negative = sherd;
  paint(negative, 0, 0);
  for (Color& c : negative.back.cloud.colors)
    for (std::uint8_t& v : c) v = static_cast<std::uint8_t>(12000 / std::max<int>(v, 50));
  EXPECT_EQ(informationOf(negative).norm(), 0);
}

}  // namespace
}  // namespace ostraka::registration
