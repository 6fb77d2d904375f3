#include "paper/sheet.h"

#include <gmock/gmock.h>

#include "paper/sheet_text.h"
#include "tests/core/paper/one_page.h"

namespace ostraka {
namespace {

TEST(CodePoints, AreThoseOfLettersOfOneToFourBytes) {
  EXPECT_THAT(codePoints("a\u00e9\u20ac\U0001f3fa"),
              testing::ElementsAre(0x61, 0xE9, 0x20AC, 0x1F3FA));
  EXPECT_EQ(winAnsi("a\u00e9\u20ac\U0001f3fa"), "a\xE9\x80?");
}

TEST(Sheet, StatesThePagesSizeInMillimetres) {
  const std::string svg = formatSvg(pageWith({}), "plate");
  EXPECT_THAT(svg, testing::HasSubstr("width=\"100mm\" height=\"50mm\" viewBox=\"0 0 100 50\""));
  // 100 mm = 283.4646 pt, 50 mm = 141.7323 pt.
  EXPECT_THAT(formatPdf({pageWith({})}, "plate"),
              testing::HasSubstr("/MediaBox [0 0 283.4646 141.7323]"));
}

TEST(Sheet, KeepsMarkupOfTextsFromBecomingMarkup) {
  Sheet sheet;
  sheet.text({1, 2}, 3, "a<b & (c)\\");
  EXPECT_THAT(formatSvg(pageWith(sheet), ""), testing::HasSubstr(">a&lt;b &amp; (c)\\</text>"));
}

TEST(Sheet, MeasuresTextsByTheirLetters) {
  const auto width = [](const char* text) {
    return textWidth({{0, 0}, 10, text, Anchor::Left, Weight::Plain});
  };
  EXPECT_NEAR(width("Hill"), width("H") + width("i") + 2 * width("l"), 1e-9);
  // Of sans-serif fonts H takes 0.65 to 0.8 of the letters' size, i 0.2 to 0.35.
  EXPECT_NEAR(width("H"), 7.25, 0.75);
  EXPECT_NEAR(width("i"), 2.75, 0.75);
}

TEST(Sheet, PutsAllItemsOfAnotherSheetWhereItIsTold) {
  Sheet inner, outer;
  inner.line({1, 1}, {2, 1}, 0.2);
  inner.text({3, 3}, 2, "x");
  outer.add(inner, {10, 20});
  ASSERT_EQ(outer.items.size(), 2U);
  EXPECT_EQ(std::get<Shape>(outer.items[0]).lines[0][1], Eigen::Vector2d(12, 21));
  EXPECT_EQ(std::get<Text>(outer.items[1]).at, Eigen::Vector2d(13, 23));
}

TEST(Sheet, EncodesPicturesOfAnyLength) {
  for (const auto& [bytes, encoded] : std::vector<std::pair<std::string, std::string>>{
           {"M", "TQ=="}, {"Ma", "TWE="}, {"Man", "TWFu"}, {"Mane", "TWFuZQ=="}}) {
    Sheet sheet;
    sheet.items.push_back(Picture{{0, 0}, {1, 1}, bytes, 1, 1});
    EXPECT_THAT(formatSvg(pageWith(sheet), ""), testing::HasSubstr("base64," + encoded + "\""));
  }
}

}  // namespace
}  // namespace ostraka
