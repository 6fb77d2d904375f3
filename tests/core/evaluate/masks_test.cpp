#include "evaluate/masks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

namespace ostraka::evaluate {
namespace {

MaskImage rectangle(int x0, int y0, int x1, int y1, std::uint8_t level) {
  MaskImage mask{60, 40, std::vector<std::uint8_t>(60 * 40, 0)};
  for (int y = y0; y < y1; ++y)
    for (int x = x0; x < x1; ++x) mask.levels[static_cast<std::size_t>(y) * 60 + x] = level;
  return mask;
}

TEST(EvaluateMask, FindsNothingWrongWithThePerfectMask) {
  const auto figures = evaluateMask(rectangle(10, 10, 40, 30, 255), rectangle(10, 10, 40, 30, 3));
  ASSERT_TRUE(figures.has_value());
  EXPECT_EQ(figures->intersectionOverUnion(), 1.0);
  EXPECT_EQ(figures->edgeBias_px(), 0.0);
  EXPECT_EQ(figures->edgeWithin95_px(), 0.0);
  EXPECT_EQ(figures->edge_px.size(), 2u * (30 + 20));
}

TEST(EvaluateMask, CountsTheUnionAndSignsTheEdgeOutwards) {
  const auto large = evaluateMask(rectangle(9, 9, 41, 31, 255), rectangle(10, 10, 40, 30, 1));
  ASSERT_TRUE(large.has_value());
  EXPECT_DOUBLE_EQ(large->intersectionOverUnion(), 30.0 * 20 / (32 * 22));
  EXPECT_FLOAT_EQ(static_cast<float>(large->edgeBias_px()), 1.0f);
  const auto small = evaluateMask(rectangle(12, 12, 38, 28, 255), rectangle(10, 10, 40, 30, 1));
  ASSERT_TRUE(small.has_value());
  EXPECT_FLOAT_EQ(static_cast<float>(small->edgeBias_px()), -2.0f);
}

TEST(EvaluateMask, ReadsASoftEdgeToAFractionOfAPixel) {
  // The outermost column is three quarters covered: with 255 inside, the level 127.5 lies at
  // 127.5 / 191.25 = 2/3 of the way out; the true outline at a half: 1/6 px too far.
  MaskImage soft = rectangle(10, 10, 40, 30, 255);
  for (int y = 10; y < 30; ++y) soft.levels[static_cast<std::size_t>(y) * 60 + 40] = 64;
  const MaskImage truth = rectangle(10, 10, 40, 30, 1);
  const auto figures = evaluateMask(soft, truth);
  ASSERT_TRUE(figures.has_value());
  const double out = (255 - 127.5) / (255 - 64.0) - 0.5;
  EXPECT_NEAR(*std::max_element(figures->edge_px.begin(), figures->edge_px.end()), out, 1e-5);
  EXPECT_EQ(figures->intersectionOverUnion(), 1.0);
}

TEST(EvaluateMask, LimitsTheDistanceOfACrumb) {
  MaskImage crumb = rectangle(2, 2, 4, 4, 255);
  const auto figures = evaluateMask(crumb, rectangle(50, 30, 58, 38, 1));
  ASSERT_TRUE(figures.has_value());
  EXPECT_EQ(figures->intersectionOverUnion(), 0.0);
  EXPECT_FLOAT_EQ(figures->edge_px.front(), 20.0f);
}

TEST(EvaluateMask, RefusesAMaskOfAnotherSize) {
  MaskImage other{10, 10, std::vector<std::uint8_t>(100, 0)};
  EXPECT_FALSE(evaluateMask(other, rectangle(0, 0, 5, 5, 1)).has_value());
}

TEST(MaskFigures, SumOverPhotographs) {
  MaskFigures sum{10, 20, {0.1f, -0.2f}};
  sum.add({10, 10, {0.3f}});
  EXPECT_DOUBLE_EQ(sum.intersectionOverUnion(), 20.0 / 30);
  EXPECT_NEAR(sum.edgeBias_px(), 0.1, 1e-6);
  EXPECT_NEAR(sum.edgeMean_px(), 0.2, 1e-6);
}

TEST(ReadMask, RefusesWhatIsNoImage) {
  const std::string path = testing::TempDir() + "no_mask.png";
  std::ofstream(path) << "no image";
  EXPECT_FALSE(readMask(path).has_value());
}

}  // namespace
}  // namespace ostraka::evaluate
