#include "pairing/common_scale.h"

#include <gtest/gtest.h>

#include "synthetic_sherd.h"

namespace ostraka::pairing {
namespace {

TEST(CommonScale, IsFoundForSidesInDifferentUnits) {
  std::vector<scan::Scan> fronts, backs;
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const test::SlabSherd sherd(seed, 14 + 3 * seed);
    fronts.push_back(scaled(test::laid(sherd, 1, seed, 40.0 * seed, 0).scan, 0.01));
    backs.push_back(scaled(test::laid(sherd, -1, 2.0 * seed, 0, 50.0 * seed).scan, 25));
  }
  QuietProgress quiet;
  const Result<double> scale = commonScale(fronts, backs, {}, quiet, {});
  ASSERT_TRUE(scale.has_value()) << scale.error().what;
  EXPECT_NEAR(*scale / (0.01 / 25), 1, 0.005);  // 0.1 mm over 20 mm
}

TEST(CommonScale, IsRefusedWhenNoTwoOutlinesAreAlike) {
  const std::vector<scan::Scan> front = {test::laid(test::SlabSherd(1), 1, 0, 0, 0).scan};
  const std::vector<scan::Scan> back = {test::laid(test::SlabSherd(2), -1, 0, 0, 0).scan};
  QuietProgress quiet;
  const Result<double> scale = commonScale(front, back, {}, quiet, {});
  ASSERT_FALSE(scale.has_value());
  EXPECT_EQ(scale.error().code, ErrorCode::NotEnough);
}

TEST(CommonScale, OfOneSideAloneIsItsOwn) {
  const std::vector<scan::Scan> front = {test::laid(test::SlabSherd(1), 1, 0, 0, 0).scan};
  QuietProgress quiet;
  const Result<double> scale = commonScale(front, {}, {}, quiet, {});
  ASSERT_TRUE(scale.has_value()) << scale.error().what;
  EXPECT_EQ(*scale, 1.0);
}

}  // namespace
}  // namespace ostraka::pairing
