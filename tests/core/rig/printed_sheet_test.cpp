#include "rig/printed_sheet.h"

#include <gmock/gmock.h>

#include "batch/batch.h"

namespace ostraka::rig {
namespace {

using testing::HasSubstr;

// From the drawing itself: the ink of each marker lies where plate.json says.
TEST(PrintedSheet, IsDrawnInTrueScaleWhereItsFileSays) {
  for (const SheetSize size : {SheetSize::A4, SheetSize::A3, SheetSize::Letter}) {
    const auto print = printSheet({size});
    ASSERT_TRUE(print.has_value());
    ASSERT_EQ(print->pages.size(), 2u);
    const Page& page = print->pages[0];
    EXPECT_EQ(Eigen::Vector2d(page.width_mm, page.height_mm), sheetSize(size));
    ASSERT_EQ(page.layers.size(), 1u);
    const Layer& layer = page.layers[0];
    ASSERT_EQ(layer.sheet.items.size(), print->plate.markers.size());
    for (std::size_t i = 0; i < layer.sheet.items.size(); ++i) {
      Eigen::AlignedBox2d ink;
      for (const auto& line : std::get<Shape>(layer.sheet.items[i]).lines)
        for (const Eigen::Vector2d& p : line) ink.extend(layer.at + p);
      const auto& corners = print->plate.markers[i].corners;  // 0: upper left, y up
      EXPECT_LT(
          (ink.min() - page.layers[0].at - Eigen::Vector2d(corners[0].x(), -corners[0].y())).norm(),
          1e-9);
      EXPECT_NEAR(ink.sizes().x(), kSheetMarker_mm, 1e-9);
      EXPECT_NEAR(ink.sizes().y(), kSheetMarker_mm, 1e-9);
    }
  }
}

TEST(PrintedSheet, HasABarOfTheLengthThatItNames) {
  const auto print = printSheet({SheetSize::Letter});
  double longest = 0;
  std::string words;
  for (const auto& item : print->pages[1].layers[0].sheet.items) {
    if (const auto* shape = std::get_if<Shape>(&item))
      longest = std::max(longest, (shape->lines[0][1] - shape->lines[0][0]).norm());
    if (const auto* text = std::get_if<Text>(&item)) {
      words += text->text + "\n";
      EXPECT_LT(text->at.x() + textWidth(*text), print->pages[1].width_mm);
    }
  }
  EXPECT_NEAR(longest, print->bar_mm, 1e-9);
  EXPECT_THAT(words, HasSubstr("Print at 100 %"));
  EXPECT_THAT(words, HasSubstr("must measure 200 mm"));
  EXPECT_THAT(words, HasSubstr("choose Clear sheet"));
}

}  // namespace
}  // namespace ostraka::rig
