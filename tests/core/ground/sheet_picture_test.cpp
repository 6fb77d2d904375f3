#include "ground/sheet_picture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

namespace ostraka::ground {
namespace {

// A sheet of 120 x 80 mm with one marker of 20 mm, its middle at (-40, 20).
batch::Plate smallSheet() {
  batch::Plate plate;
  plate.dictionary = "DICT_4X4_100";
  plate.sheet = Eigen::AlignedBox2d(Eigen::Vector2d(-60, -40), Eigen::Vector2d(60, 40));
  plate.diameter_mm = 160;
  plate.markers.push_back({7,
                           {Eigen::Vector3d(-50, 30, 0), Eigen::Vector3d(-30, 30, 0),
                            Eigen::Vector3d(-30, 10, 0), Eigen::Vector3d(-50, 10, 0)}});
  return plate;
}

PlateGrid sheetGrid() {
  return gridOver(smallSheet(), 0.5);
}

cv::Point cellOf(double x_mm, double y_mm) {
  const PlateGrid g = sheetGrid();
  return {cvRound(x_mm / g.pitch_mm + g.middle()), cvRound(y_mm / g.pitch_mm + g.middle())};
}

/// Log brightness of a place against white paper, by photograph.
using Covering = std::function<float(std::size_t photograph, double x_mm, double y_mm)>;

// Twelve photographs of the print times the covering, each with an exposure of its own, a light
// that falls off to the right by a third, and noise of 1 %.
std::vector<cv::Mat3b> sheetPhotographs(const cv::Mat1f& printed, const Covering& covering) {
  const PlateGrid g = sheetGrid();
  std::mt19937 random(5);
  std::normal_distribution<float> noise(0, 0.01F);
  std::vector<cv::Mat3b> samples;
  for (std::size_t i = 0; i < 12; ++i) {
    cv::Mat3b& sample = samples.emplace_back(printed.size(), cv::Vec3b(0, 0, 0));
    const float exposure = 0.02F * static_cast<float>(i);
    for (int row = 0; row < printed.rows; ++row)
      for (int column = 0; column < printed.cols; ++column) {
        if (printed(row, column) < 0) continue;
        const double x = g.pitch_mm * (column - g.middle()), y = g.pitch_mm * (row - g.middle());
        const float ink = std::log(printed(row, column) + (1 - printed(row, column)) * 0.2F);
        const float light = exposure - 0.0028F * static_cast<float>(x + 60);
        for (int c = 0; c < 3; ++c) {
          const float log = ink + light + covering(i, x, y) + noise(random);
          sample(row, column)[c] = cv::saturate_cast<uchar>(170 * std::exp(log) - 4);
        }
      }
  }
  return samples;
}

bool inPatch(double x, double y, double cx, double cy, double radius) {
  return std::hypot(x - cx, y - cy) < radius;
}

TEST(PrintedSheet, IsWhitePaperWithBlackMarkersAndNothingBeyondItsEdge) {
  const Result<cv::Mat1f> printed = printedSheet(smallSheet(), sheetGrid());
  ASSERT_TRUE(printed.has_value());
  EXPECT_FLOAT_EQ((*printed)(cellOf(20, 0)), 1);
  // The marker's border is a sixth of its side wide; its middle is 1.7 mm inside.
  EXPECT_FLOAT_EQ((*printed)(cellOf(-48.3, 20)), 0);
  EXPECT_FLOAT_EQ((*printed)(cellOf(-40, 28.3)), 0);
  EXPECT_FLOAT_EQ((*printed)(cellOf(-52, 20)), 1);
  EXPECT_LT((*printed)(cellOf(62, 0)), 0);
}

TEST(PrintedSheet, ShowsInkInFrontOfItsMarkersAlone) {
  const auto printed = printedSheet(smallSheet(), sheetGrid());
  ASSERT_TRUE(printed);
  const cv::Point corner = cellOf(-49, 29), paper = cellOf(20, 0);  // a marker's border is black
  const cv::Mat2f cells = (cv::Mat2f(1, 3) << cv::Vec2f(corner.x, corner.y),
                           cv::Vec2f(paper.x, paper.y), cv::Vec2f(-50, -50));
  const cv::Mat1b ink = inkBehind(*printed, cells);
  EXPECT_EQ(ink(0, 0), 255);
  EXPECT_EQ(ink(0, 1), 0);
  EXPECT_EQ(ink(0, 2), 0) << "beyond the sheet";
}

TEST(SheetPicture, KnowsLightAndExposureThoughSherdsCoverAThirdOfTheSheet) {
  const cv::Mat1f printed = *printedSheet(smallSheet(), sheetGrid());
  std::mt19937 random(1);
  std::uniform_real_distribution<float> grain(-1.2F, -0.3F);
  const auto samples = sheetPhotographs(printed, [&](std::size_t, double x, double y) {
    return inPatch(x, y, 15, 0, 30) ? grain(random) : 0.F;
  });
  const SheetPicture picture = buildSheetPicture(samples, printed);
  for (const std::size_t i : {0U, 11U})
    for (const double x : {-55.0, 0.0, 55.0}) {
      const PlateGrid g = sheetGrid();
      const auto u = static_cast<float>(x / (g.pitch_mm * g.middle()));
      const float expected =
          std::log(170.F) + 0.02F * static_cast<float>(i) - 0.0028F * static_cast<float>(x + 60);
      // Noise of 1 %, rounding of 0.6 %.
      EXPECT_NEAR(picture.tones[i].paperAt(u, 0)[1], expected, 0.02F) << i << " at " << x;
    }
  EXPECT_NEAR(picture.tones[3].ink[1], std::log(0.2F), 0.05F);
}

TEST(SheetPicture, TakesAShadowThatAllPhotographsSeeAlikeForBareSheetAndGrainyClayNot) {
  const cv::Mat1f printed = *printedSheet(smallSheet(), sheetGrid());
  std::mt19937 random(1);
  std::normal_distribution<float> grain(-0.5F, 0.12F);
  const auto samples = sheetPhotographs(printed, [&](std::size_t, double x, double y) {
    if (inPatch(x, y, 30, 0, 12)) return grain(random);  // clay: another grain to each photograph
    return inPatch(x, y, -5, -15, 12) ? -0.5F : 0.F;
  });
  const SheetPicture picture = buildSheetPicture(samples, printed);
  EXPECT_TRUE(picture.still_light);
  EXPECT_NE(picture.witnessed(cellOf(-5, -15)), 0);
  EXPECT_NE(picture.shade(cellOf(-5, -15)), 0);
  EXPECT_NEAR(picture.correction(cellOf(-5, -15))[1], -0.5F, 0.03F);
  EXPECT_EQ(picture.witnessed(cellOf(30, 0)), 0);
  EXPECT_NEAR(picture.correction(cellOf(30, 0))[1], 0, 0.12F);
  EXPECT_NE(picture.witnessed(cellOf(-10, 30)), 0);
  EXPECT_EQ(picture.shade(cellOf(-10, 30)), 0);
  // Clay of 24 x 24 mm stands on the sheet; photographs are compared over 5 mm around a place.
  EXPECT_NE(picture.standing(cellOf(30, 0)), 0);
  EXPECT_EQ(picture.standing(cellOf(30, 13)), 0) << "no wider than what stands there";
  EXPECT_EQ(picture.standing(cellOf(-5, -15)), 0) << "a shadow";
  EXPECT_EQ(picture.standing(cellOf(-40, 20)), 0) << "ink";
  const cv::Point clay = cellOf(30, 0), paper = cellOf(-10, 30);
  const cv::Mat2f cells =
      (cv::Mat2f(1, 3) << cv::Vec2f(clay.x, clay.y), cv::Vec2f(paper.x, paper.y), cv::Vec2f(-9, 0));
  const cv::Mat1b stands = somethingStands(picture, cells);
  EXPECT_EQ(stands(0, 0), 255);
  EXPECT_EQ(stands(0, 1), 0);
  EXPECT_EQ(stands(0, 2), 0) << "beyond the sheet";
}

TEST(SheetPicture, TellsEvenBlackClayFromAShadowByItsOutlineThatStandsAboveTheSheet) {
  const cv::Mat1f printed = *printedSheet(smallSheet(), sheetGrid());
  // A face 4 mm above the sheet, seen at 45 degrees from all around, and two shadows.
  const auto samples = sheetPhotographs(printed, [&](std::size_t i, double x, double y) {
    const double turn = 2 * M_PI * static_cast<double>(i) / 12;
    if (inPatch(x, y, 30 + 4 * std::cos(turn), 4 * std::sin(turn), 12)) return -1.5F;
    if (inPatch(x, y, -5, -25, 12)) return -0.3F;
    return inPatch(x, y, -5, 10, 12) ? -1.2F : 0.F;
  });
  const SheetPicture picture = buildSheetPicture(samples, printed);
  ASSERT_TRUE(picture.still_light);
  EXPECT_EQ(picture.witnessed(cellOf(32, 0)), 0);
  EXPECT_NEAR(picture.correction(cellOf(32, 0))[1], 0, 0.12F);
  EXPECT_NE(picture.shade(cellOf(-5, 10)), 0);
  EXPECT_NEAR(picture.correction(cellOf(-5, 10))[1], -1.2F, 0.05F);
}

// Even clay in the paper's plane, as a flash shows it, looks like a shadow from everywhere; a
// coarse reconstruction knows better. Who looks past it agrees with the others, who are too few.
TEST(SheetPicture, BelievesNoPhotographThatLooksAtSomethingBeforeTheSheet) {
  const cv::Mat1f printed = *printedSheet(smallSheet(), sheetGrid());
  auto samples = sheetPhotographs(printed, [](std::size_t, double x, double y) {
    if (inPatch(x, y, -5, 25, 12)) return -0.3F;
    return inPatch(x, y, 30, 0, 12) || inPatch(x, y, -5, -15, 12) ? -1.2F : 0.F;
  });
  const SheetPicture unaware = buildSheetPicture(samples, printed);
  ASSERT_TRUE(unaware.still_light);
  EXPECT_NE(unaware.witnessed(cellOf(30, 0)), 0);
  std::vector<cv::Mat1b> covered;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    covered.emplace_back(printed.size(), uchar{0});
    if (i < 5) continue;  // of 12: they see it otherwise, or do not know
    for (int row = 0; row < printed.rows; ++row)
      for (int column = 0; column < printed.cols; ++column) {
        const PlateGrid g = sheetGrid();
        const double x = g.pitch_mm * (column - g.middle()), y = g.pitch_mm * (row - g.middle());
        if (!inPatch(x, y, 30, 0, 12)) continue;
        covered[i](row, column) = 255;
        samples[i](row, column) = {0, 0, 0};
      }
  }
  const SheetPicture picture = buildSheetPicture(samples, printed, covered);
  ASSERT_TRUE(picture.still_light);
  EXPECT_EQ(picture.witnessed(cellOf(30, 0)), 0);
  EXPECT_NE(picture.shade(cellOf(-5, -15)), 0);
}

// Grainy clay that each photograph sees elsewhere says nothing of the light.
TEST(SheetPicture, KnowsTheSunByItsDeepShadowsAndAFlashByThoseThatFollowTheCamera) {
  const cv::Mat1f printed = *printedSheet(smallSheet(), sheetGrid());
  for (const bool flash : {false, true}) {
    std::mt19937 random(1);
    std::normal_distribution<float> grain(-0.4F, 0.3F);
    const auto samples = sheetPhotographs(printed, [&](std::size_t i, double x, double y) {
      const double turn = 2 * M_PI * static_cast<double>(i) / 12;
      if (inPatch(x, y, 6 * std::cos(turn), 6 * std::sin(turn), 15)) return grain(random);
      const double from_lamp = flash ? turn : 1.0;
      const double shadow_x = 14 * std::cos(from_lamp), shadow_y = 14 * std::sin(from_lamp);
      return inPatch(x, y, shadow_x, shadow_y, 12) ? -1.2F : 0.F;
    });
    EXPECT_EQ(buildSheetPicture(samples, printed).still_light, !flash);
  }
}

TEST(SheetPicture, NoticesThatTheLightTurnsOverTheSheet) {
  const cv::Mat1f printed = *printedSheet(smallSheet(), sheetGrid());
  const auto samples = sheetPhotographs(printed, [](std::size_t i, double x, double y) {
    const double turn = 2 * M_PI * static_cast<double>(i) / 12;
    return inPatch(x, y, 30 * std::cos(turn), 20 * std::sin(turn), 15) ? -0.3F : 0.F;
  });
  const SheetPicture picture = buildSheetPicture(samples, printed);
  EXPECT_FALSE(picture.still_light);
  EXPECT_TRUE(picture.witnessed.empty());
  EXPECT_EQ(somethingStands(picture, cv::Mat2f(1, 1, cv::Vec2f(90, 90)))(0, 0), 0);
}

}  // namespace
}  // namespace ostraka::ground
