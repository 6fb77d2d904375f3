#include "rig/sheet_bend.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace ostraka::rig {
namespace {

// z = 3 x y / 100^2 + x^4 / 100^4, a saddle whose sides rise.
SheetBend saddle() {
  SheetBend bend;
  bend.reach_mm = 100;
  bend.coefficients_mm[1] = 3;
  bend.coefficients_mm[7] = 1;
  return bend;
}

TEST(SheetBend, RisesFromItsLowestPlaceWithinAnySheet) {
  // Asked in steps of 14.425 mm: lowest at (28.85, -43.275) and (-28.85, 43.275).
  const double lowest = -3 * 0.2885 * 0.43275 + std::pow(0.2885, 4);
  EXPECT_NEAR(saddle().rise(0, 0), -lowest, 1e-12);
  EXPECT_NEAR(saddle().rise(50, 50), 0.75 + 0.0625 - lowest, 1e-12);
  EXPECT_EQ(saddle().rise(70, -70), 0) << "lower than any place that every sheet has";
  EXPECT_EQ(SheetBend{}.rise(30, 40), 0);
}

TEST(SheetBend, ComesBackFromJson) {
  const std::optional<SheetBend> back =
      sheetBendFrom(nlohmann::json::parse(toJson(saddle()).dump()));
  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(back->reach_mm, 100);
  EXPECT_EQ(back->coefficients_mm, saddle().coefficients_mm);
}

TEST(SheetBend, ForeignJsonIsRefused) {
  const nlohmann::json good = toJson(saddle());
  EXPECT_TRUE(sheetBendFrom(good).has_value());
  const auto refused = [&](const char* key, const nlohmann::json& value) {
    nlohmann::json bad = good;
    bad[key] = value;
    return !sheetBendFrom(bad).has_value();
  };
  EXPECT_TRUE(refused("reach", 0));
  EXPECT_TRUE(refused("reach", -100));
  EXPECT_TRUE(refused("reach", "100"));
  EXPECT_TRUE(refused("reach", 1e300));
  EXPECT_FALSE(refused("reach", 1500)) << "markers may lie as far from the middle";
  EXPECT_TRUE(refused("coefficients", 3));
  EXPECT_TRUE(refused("coefficients", std::vector<double>(11, 0)));
  EXPECT_TRUE(refused("coefficients", std::vector<double>(13, 0)));
  EXPECT_TRUE(refused("coefficients", std::vector<double>(12, -1e300)));
  EXPECT_FALSE(sheetBendFrom(nlohmann::json()).has_value());
  EXPECT_FALSE(sheetBendFrom(nlohmann::json::array({1})).has_value());
}

}  // namespace
}  // namespace ostraka::rig
