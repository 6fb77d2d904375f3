#include "ground/bare_rows.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ostraka::ground {
namespace {

constexpr Tolerance kTolerance{0.2F, 0.1F};

TEST(BareRows, WeightFallsWithBrightnessAndWithColourByTheirOwnTolerances) {
  EXPECT_FLOAT_EQ(bareWeight({0, 0, 0}, kTolerance), 1);
  // One tolerance of brightness: exp(-1/2).
  EXPECT_NEAR(bareWeight({0.2F, 0.2F, 0.2F}, kTolerance), 0.60653, 1e-5);
  // Colour alone, length 0.1: exp(-1/2) again.
  const float side = 0.1F / std::sqrt(2.F);
  EXPECT_NEAR(bareWeight({side, 0, -side}, kTolerance), 0.60653, 1e-5);
  EXPECT_EQ(bareWeight({0.9F, 0.9F, 0.9F}, kTolerance), 0);
}

TEST(BareRows, SumValuesWithoutTheirLight) {
  const cv::Vec3f before[] = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}},
                  values[] = {{1, 1, 1}, {1.2F, 1.2F, 1.2F}, {-1000, -1000, -1000}},
                  lights[] = {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}};
  ColourRow value(3), light(3);
  value.read(values);
  light.read(lights);
  BareRow row(3);
  row.start(before, before);
  row.add(value, light, -1000, kTolerance, {1e3F, 1e3F});
  row.add(value, light, -1000, kTolerance, {1e3F, 1e3F});
  cv::Vec3f sum[3];
  float weight[3], trusted[3];
  row.write(sum, weight, trusted);
  EXPECT_FLOAT_EQ(weight[0], 2);
  EXPECT_FLOAT_EQ(trusted[0], 2);
  EXPECT_NEAR(weight[1], 2 * 0.60653, 1e-5);
  EXPECT_NEAR(sum[1][2], 2 * 0.60653 * 0.2, 1e-5);
  EXPECT_NEAR(trusted[1], 2 * 0.36788, 1e-5);
  EXPECT_EQ(weight[2], 0) << "nothing was seen there";
  EXPECT_EQ(sum[2][0], 0);
  row.addCertain(value, light, -1000, 4);
  row.write(sum, weight, trusted);
  EXPECT_FLOAT_EQ(weight[0], 6);
  EXPECT_EQ(weight[2], 0);
}

TEST(BareRows, TheAnchorHoldsWhatTheLastRoundWouldAccept) {
  const cv::Vec3f anchor[] = {{1, 1, 1}}, before[] = {{0, 0, 0}}, values[] = {{0, 0, 0}};
  ColourRow value(1), light(1);
  value.read(values);
  BareRow row(1);
  row.start(before, anchor);
  row.add(value, light, -1000, kTolerance, kTolerance);
  cv::Vec3f sum;
  float weight = 1, trusted = 1;
  row.write(&sum, &weight, &trusted);
  EXPECT_EQ(weight, 0);
}

}  // namespace
}  // namespace ostraka::ground
