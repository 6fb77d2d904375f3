#include "paper/glyphs.h"

#include <gmock/gmock.h>

#include <set>
#include <sstream>

namespace ostraka {
namespace {

std::vector<Glyph> glyphsIn(const std::string& text, bool bold = false) {
  auto glyphs = glyphsOf(text, bold);
  EXPECT_TRUE(glyphs) << "a font belongs to the packages";
  return glyphs.value_or(std::vector<Glyph>());
}

// Lines of an outline, and the box of all its points.
struct Drawn {
  int begun = 0, closed = 0;
  Eigen::AlignedBox2d box;
};
Drawn drawnBy(const std::string& operators) {
  Drawn drawn;
  std::istringstream in(operators);
  std::vector<double> numbers;
  for (std::string word; in >> word;) {
    if (word.find_first_not_of("0123456789.-") == std::string::npos) {
      numbers.push_back(std::stod(word));
      continue;
    }
    const std::size_t wanted = word == "c" ? 6 : word == "h" ? 0 : 2;
    EXPECT_EQ(numbers.size(), wanted) << word;
    for (std::size_t i = 0; i + 1 < numbers.size(); i += 2)
      drawn.box.extend(Eigen::Vector2d(numbers[i], numbers[i + 1]));
    drawn.begun += word == "m" ? 1 : 0;
    drawn.closed += word == "h" ? 1 : 0;
    numbers.clear();
  }
  return drawn;
}

TEST(Glyphs, AreClosedOutlinesWithinTheirBoxes) {
  const std::vector<Glyph> glyphs = glyphsIn("Hio");
  ASSERT_EQ(glyphs.size(), 3u);
  for (const Glyph& glyph : glyphs) {
    const Drawn drawn = drawnBy(glyph.operators);
    EXPECT_EQ(drawn.begun, drawn.closed) << glyph.letter;
    EXPECT_EQ(drawn.begun, glyph.letter == "H" ? 1 : 2) << glyph.letter << ": a dot, a hole";
    Eigen::AlignedBox2d box = glyph.box;  // points have two decimals
    box.extend(glyph.box.min() - Eigen::Vector2d::Constant(0.01));
    box.extend(glyph.box.max() + Eigen::Vector2d::Constant(0.01));
    EXPECT_TRUE(box.contains(drawn.box)) << glyph.letter;
    // Thousandths of the size: letters stand on the line and rise to 0.65 to 0.8 of it.
    EXPECT_NEAR(glyph.box.min().y(), 0, 25) << glyph.letter;
    EXPECT_GT(glyph.advance, glyph.box.max().x() - 1) << glyph.letter;
  }
  EXPECT_NEAR(glyphs[0].box.max().y(), 725, 75);
}

TEST(Glyphs, OfABlankAreRoomAlone) {
  const std::vector<Glyph> glyphs = glyphsIn("a b");
  ASSERT_EQ(glyphs.size(), 3u);
  EXPECT_EQ(glyphs[1].letter, " ");
  EXPECT_EQ(glyphs[1].operators, "");
  EXPECT_TRUE(glyphs[1].box.isEmpty());
  EXPECT_GT(glyphs[1].advance, 100);
}

TEST(Glyphs, OfATextAreOfOneFontAndBoldOnesOfAnother) {
  std::set<std::string> fonts;
  for (const Glyph& glyph : glyphsIn("Garni, \u0533\u0561\u057C\u0576\u056B"))
    fonts.insert(glyph.font);
  EXPECT_EQ(fonts.size(), 1u) << "letters of two fonts have two heights";
  EXPECT_NE(glyphsIn("a")[0].font, glyphsIn("a", true)[0].font);
}

TEST(Glyphs, OfALetterThatNoFontHasIsAQuestionMark) {
  const std::vector<Glyph> glyphs = glyphsIn("a\xF3\xB0\x80\x80");  // U+F0000, for private use
  ASSERT_EQ(glyphs.size(), 2u);
  EXPECT_EQ(glyphs[0].letter, "a");
  EXPECT_EQ(glyphs[1].letter, "?");
  EXPECT_EQ(glyphs[1].operators, glyphsIn("?")[0].operators);
}

TEST(Glyphs, OfNothingAreNone) {
  EXPECT_TRUE(glyphsIn("").empty());
}

}  // namespace
}  // namespace ostraka
