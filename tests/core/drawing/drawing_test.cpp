#include "drawing/drawing.h"

#include <gmock/gmock.h>

#include "true_rim.h"

namespace ostraka::drawing {
namespace {

using testing::HasSubstr;
using vessels::SherdPart;

const TrueSherdOfVessel& wallSherd() {
  static const TrueSherdOfVessel sherd = trueSherd(SherdPart::Wall, 41, 0);
  return sherd;
}

TEST(Drawing, OfAWallSherdIsInTrueScale) {
  DrawingOptions options;
  options.rim = RimChoice::No;
  for (const double scale : {1.0, 0.5}) {
    options.scale = scale;
    const auto drawing = drawSherd(wallSherd().sherd.mesh, "ARM1-7", options);
    ASSERT_TRUE(drawing.has_value()) << drawing.error().sentence();
    // The outer view's outline is as tall as the sherd along its longest axis.
    const auto* picture = std::get_if<Picture>(&drawing->sheet.items[2]);
    const auto* outline = std::get_if<Shape>(&drawing->sheet.items[3]);
    ASSERT_TRUE(picture != nullptr && outline != nullptr);
    Eigen::AlignedBox2d box;
    for (const auto& line : outline->lines)
      for (const Eigen::Vector2d& p : line) box.extend(p);
    const Walls walls = findWalls(wallSherd().sherd.mesh);
    double low = 1e9, high = -1e9;
    for (const Eigen::Vector3f& v : wallSherd().sherd.mesh.vertices) {
      low = std::min(low, v.cast<double>().dot(walls.axes.col(0)));
      high = std::max(high, v.cast<double>().dot(walls.axes.col(0)));
    }
    EXPECT_NEAR(box.sizes().y(), scale * (high - low), 0.15);  // two pixels of 1/24 mm and the line
  }
}

TEST(Drawing, SaysTheNumberAndTheMeasures) {
  DrawingOptions options;
  const auto drawing = drawSherd(wallSherd().sherd.mesh, "ARM1-7", options);
  ASSERT_TRUE(drawing.has_value());
  const std::string svg = formatSvg(layOut({*drawing}, 1, {})[0], "x");
  EXPECT_THAT(svg, HasSubstr(">ARM1-7</text>"));
  EXPECT_THAT(svg, HasSubstr(", wall "));
  EXPECT_THAT(svg, HasSubstr(">1 : 1</text>"));
}

TEST(Drawing, HasNoWarningOnItsSheet) {
  DrawingOptions options;
  options.rim = RimChoice::No;
  options.remarks = {"The size is in doubt."};
  auto drawing = drawSherd(wallSherd().sherd.mesh, "ARM1-7", options);
  ASSERT_TRUE(drawing.has_value());
  drawing->hints.push_back("Draw it again.");
  const std::string svg = formatSvg(layOut({*drawing}, 1, {})[0], "x");
  EXPECT_THAT(drawing->remarks, testing::ElementsAre("The size is in doubt."));
  EXPECT_THAT(svg, testing::Not(HasSubstr("The size is in doubt.")));
  EXPECT_THAT(svg, testing::Not(HasSubstr("Draw it again.")));
}

TEST(Drawing, OfARimSaysDiameterIntervalAndWhatIsKept) {
  const TrueSherdOfVessel rim = trueSherd(SherdPart::Rim, 500, 0);
  DrawingOptions options;
  options.rim = RimChoice::Yes;
  const auto drawing = drawSherd(rim.sherd.mesh, "R", options);
  ASSERT_TRUE(drawing.has_value()) << drawing.error().sentence();
  EXPECT_TRUE(drawing->drawn_as_rim);
  const std::string svg = formatSvg(layOut({*drawing}, 1, {})[0], "x");
  EXPECT_THAT(svg, HasSubstr("\xC3\x98 "));
  EXPECT_THAT(svg, HasSubstr("95 %: "));
  EXPECT_THAT(svg, HasSubstr("% of the rim preserved"));
}

// A person says that they are rims: of 317 a break is taken for the lip, of 528 there is too
// little.
TEST(Drawing, OfARimWithoutAKnownDiameterSaysWhyAndPrintsNone) {
  for (const auto& [seed, why] : {std::pair(317, "barely resembles one"),
                                  std::pair(558, "too short or too straight for a diameter")}) {
    const TrueSherdOfVessel rim =
        trueSherd(SherdPart::Rim, static_cast<std::uint64_t>(seed), seed == 558 ? 0.05 : 0);
    DrawingOptions options;
    options.rim = RimChoice::Yes;
    const auto drawing = drawSherd(rim.sherd.mesh, "R", options);
    ASSERT_TRUE(drawing.has_value()) << drawing.error().sentence();
    EXPECT_TRUE(drawing->drawn_as_rim);
    EXPECT_THAT(drawing->remarks, testing::ElementsAre(HasSubstr(why)));
    const std::string svg = formatSvg(layOut({*drawing}, 1, {})[0], "x");
    EXPECT_THAT(svg, testing::Not(HasSubstr(why)));
    for (const char* no : {"\xC3\x98", "95 %", "rim kept", "above"})
      EXPECT_THAT(svg, testing::Not(HasSubstr(no)));
    EXPECT_LT(drawing->box.sizes().maxCoeff(), 300) << "no axis far away";
  }
}

// Its true diameter is 201 mm, and 78 is found on a stretch that may as well be a break.
TEST(Drawing, OfARimWithAWeakLipDoubtsItsDiameter) {
  const TrueSherdOfVessel rim = trueSherd(SherdPart::Rim, 521, 0.05);
  DrawingOptions options;
  options.rim = RimChoice::Yes;
  const auto drawing = drawSherd(rim.sherd.mesh, "R", options);
  ASSERT_TRUE(drawing.has_value()) << drawing.error().sentence();
  EXPECT_THAT(drawing->remarks, testing::ElementsAre(HasSubstr("may be a fracture")));
  options.by_hand["rim_diameter"] = {200, {}};
  EXPECT_TRUE(drawSherd(rim.sherd.mesh, "R", options)->remarks.empty());
}

// Measured with a rim chart: the mouth is drawn that wide, whatever the short arc says.
TEST(Drawing, OfARimWithADiameterByHandIsDrawnThatWide) {
  const TrueSherdOfVessel rim = trueSherd(SherdPart::Rim, 558, 0.05);
  DrawingOptions options;
  options.rim = RimChoice::Yes;
  options.by_hand["rim_diameter"] = {230, {}};
  const auto drawing = drawSherd(rim.sherd.mesh, "R", options);
  ASSERT_TRUE(drawing.has_value()) << drawing.error().sentence();
  EXPECT_TRUE(drawing->remarks.empty());
  ASSERT_TRUE(drawing->mouth && drawing->mouth->kept_pct);
  EXPECT_NEAR(drawing->mouth->kept_pct->value, 100 * rim.kept, 0.5);  // truth: 233 mm, 3.4 %
  // The section's lip stands 115 mm left of the axis, where the rim's line ends.
  EXPECT_NEAR(drawing->box.min().x(), -115, 4);
  const std::string svg = formatSvg(layOut({*drawing}, 1, {})[0], "x");
  EXPECT_THAT(svg, HasSubstr("\u00D8 23.0 cm, 3 % of the rim preserved<"));
}

TEST(Drawing, SaysItsTextsInTheLanguageAndWithItsDecimalSign) {
  DrawingOptions options;
  options.rim = RimChoice::No;
  options.wording.translated = [](const Message& words) { return "[" + words.english() + "]"; };
  options.wording.decimal = ",";
  options.scale = 0.4;
  options.remarks = {"The size is in doubt."};
  const auto drawing = drawSherd(wallSherd().sherd.mesh, "ARM1.7", options);
  ASSERT_TRUE(drawing.has_value());
  EXPECT_THAT(drawing->remarks, testing::ElementsAre("The size is in doubt."));
  SheetOptions sheet;
  sheet.wording = options.wording;
  sheet.title = "Dig no. 1.5";
  const std::string svg = formatSvg(layOut({*drawing}, options.scale, sheet)[0], "x");
  EXPECT_THAT(
      svg, testing::ContainsRegex(">[0-9]+,[0-9] \u00D7 [0-9]+,[0-9] mm, \\[wall [0-9]+,[0-9] mm"));
  EXPECT_THAT(svg, HasSubstr(">1 : 2,5</text>"));
  EXPECT_THAT(svg, HasSubstr(">[ARM1.7]</text>"));
  EXPECT_THAT(svg, HasSubstr(">Dig no. 1.5</text>"));
}

TEST(Drawing, RefusesAnOpenModel) {
  TriangleMesh open = wallSherd().sherd.mesh;
  open.triangles.pop_back();
  const auto drawing = drawSherd(open, "open", {});
  ASSERT_FALSE(drawing.has_value());
  EXPECT_EQ(drawing.error().code, ErrorCode::UnusableInput);
  EXPECT_THAT(drawing.error().sentence(), HasSubstr("closed model"));
}

// Its picture at 300 dots per inch would have 14,000 million pixels.
TEST(Drawing, RefusesAModelInAnotherUnit) {
  TriangleMesh micrometres = wallSherd().sherd.mesh;
  for (Eigen::Vector3f& v : micrometres.vertices) v *= 1000;
  const auto drawing = drawSherd(micrometres, "ARM1-7", {});
  ASSERT_FALSE(drawing.has_value());
  EXPECT_EQ(drawing.error().code, ErrorCode::UnusableInput);
  EXPECT_THAT(drawing.error().sentence(), HasSubstr("export it in mm"));
}

TEST(Drawing, AsAnOrthophotoNeedsPhotographsOrColours) {
  DrawingOptions options;
  options.rim = RimChoice::No;
  options.surface = Surface::Orthophoto;
  TriangleMesh mesh = wallSherd().sherd.mesh;
  mesh.colors.clear();
  const auto refused = drawSherd(mesh, "ARM1-7", options);
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, ErrorCode::UnusableInput);
  EXPECT_THAT(refused.error().what, HasSubstr("neither photographs nor colours"));
  mesh.colors.assign(mesh.vertices.size(), Color{170, 110, 60});
  const auto drawing = drawSherd(mesh, "ARM1-7", options);
  ASSERT_TRUE(drawing.has_value()) << drawing.error().sentence();
  EXPECT_THAT(drawing->remarks, testing::Contains(HasSubstr("colours of its vertices")));
  EXPECT_THAT(formatSvg(layOut({*drawing}, 1, {})[0], "x"), HasSubstr(">5 cm</text>"));
}

TEST(Drawing, ShowsBothViewsBesideEachOtherInAPictureOfTheirOwn) {
  DrawingOptions options;
  options.rim = RimChoice::No;
  options.surface = Surface::Orthophoto;
  options.scale = 0.5;
  TriangleMesh mesh = wallSherd().sherd.mesh;
  const Color clay{170, 110, 60};
  mesh.colors.assign(mesh.vertices.size(), clay);
  const auto drawing = drawSherd(mesh, "ARM1-7", options);
  ASSERT_TRUE(drawing.has_value()) << drawing.error().sentence();
  const ViewPicture both = pictureOf(mesh, *drawing, options);
  Eigen::AlignedBox2d seen;  // of the outer view, on paper
  for (const Eigen::Vector3f& v : mesh.vertices) {
    const Eigen::Vector3d p = drawing->outer_from_model * v.cast<double>();
    seen.extend(0.5 * Eigen::Vector2d(p.y(), p.z()));
  }
  const cv::Mat3b pixels = both.pixels;
  const auto isDrawn = [&](int column) {
    for (int row = 0; row < pixels.rows; ++row)
      if (pixels(row, column) != cv::Vec3b::all(255)) return true;
    return false;
  };
  std::vector<int> widths;  // of what is drawn, from the left
  for (int column = 1; column < pixels.cols; ++column) {
    if (!isDrawn(column)) continue;
    if (!isDrawn(column - 1)) widths.push_back(0);
    ++widths.back();
  }
  ASSERT_EQ(widths.size(), 2u);
  for (const int width : widths)
    EXPECT_NEAR(width * 25.4 / both.dpi, seen.sizes().x(), 2 * 25.4 / both.dpi);
  EXPECT_NEAR(both.size_mm().y(), seen.sizes().y() + 2, 2 * 25.4 / both.dpi);  // 1 mm around
}

}  // namespace
}  // namespace ostraka::drawing
