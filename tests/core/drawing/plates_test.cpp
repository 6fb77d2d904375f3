#include <gtest/gtest.h>

#include "drawing/drawing.h"

namespace ostraka::drawing {
namespace {

TEST(Plates, HoldAllDrawingsInTheirOrderWithoutOverlap) {
  SherdDrawing one;
  one.box = Eigen::AlignedBox2d(Eigen::Vector2d(-5, -10), Eigen::Vector2d(75, 50));
  SheetOptions options;
  options.layout = SheetOptions::Layout::Plates;
  // 80 x 60 on A4 with 186 x 251 mm of room: two in a row, three rows.
  const std::vector<Page> pages = layOut(std::vector<SherdDrawing>(7, one), 1, options);
  ASSERT_EQ(pages.size(), 2U);
  ASSERT_EQ(pages[0].layers.size(), 7U);  // the foot and six
  ASSERT_EQ(pages[1].layers.size(), 2U);
  EXPECT_EQ(pages[0].layers[2].at - pages[0].layers[1].at, Eigen::Vector2d(88, 0));
  EXPECT_EQ(pages[0].layers[3].at - pages[0].layers[1].at, Eigen::Vector2d(0, 68));
}

TEST(Plates, GiveLargeDrawingsTheRoomTheyNeed) {
  SherdDrawing large;
  large.box = Eigen::AlignedBox2d(Eigen::Vector2d(0, 0), Eigen::Vector2d(390, 100));
  const std::vector<Page> a3 = layOut({large}, 1, {});
  EXPECT_EQ(a3[0].width_mm, 420);
  large.box = Eigen::AlignedBox2d(Eigen::Vector2d(0, 0), Eigen::Vector2d(600, 100));
  EXPECT_GT(layOut({large}, 1, {})[0].width_mm, 600);
}

TEST(Plates, OfTheLargestGoOnBehindThem) {
  SherdDrawing small, large;
  small.box = Eigen::AlignedBox2d(Eigen::Vector2d(0, 0), Eigen::Vector2d(40, 30));
  large.box = Eigen::AlignedBox2d(Eigen::Vector2d(0, 0), Eigen::Vector2d(600, 100));
  SheetOptions options;
  options.layout = SheetOptions::Layout::Plates;
  const std::vector<Page> pages = layOut({small, small, large, small}, 1, options);
  ASSERT_EQ(pages.size(), 3u);
  EXPECT_EQ(pages[0].layers.size(), 3u);  // the foot and two
  EXPECT_EQ(pages[1].width_mm, 624) << "12 mm on both sides";
  EXPECT_EQ(pages[2].width_mm, 210);
  EXPECT_EQ(pages[2].layers.back().at, Eigen::Vector2d(12, 12));
}

TEST(Plates, OfOneDrawingHaveItInTheMiddleOfTheSmallestPaper) {
  SherdDrawing one;
  one.box = Eigen::AlignedBox2d(Eigen::Vector2d(-5, -10), Eigen::Vector2d(75, 50));
  const std::vector<Page> pages = layOut({one, one}, 1, {});
  ASSERT_EQ(pages.size(), 2u);
  EXPECT_EQ(pages[0].width_mm, 210);
  // 65 mm are free on both sides of 80 mm; 20 mm above.
  EXPECT_EQ(pages[0].layers[0].at, Eigen::Vector2d(65 + 5, 20 + 10));
  one.box.extend(Eigen::Vector2d(245, 50));  // 250 mm wide: only across
  EXPECT_EQ(layOut({one}, 1, {})[0].width_mm, 297);
  EXPECT_EQ(layOut({one}, 1, {})[0].height_mm, 210);
}

TEST(Plates, HaveABarOfFiveCentimetresAtTheirScale) {
  SherdDrawing one;
  one.box = Eigen::AlignedBox2d(Eigen::Vector2d(0, 0), Eigen::Vector2d(40, 30));
  SheetOptions options;
  options.title = "Trench 3";
  for (const auto& [scale, ratio] : {std::pair(0.5, "1 : 2"), {1.0, "1 : 1"}, {2.0, "2 : 1"}}) {
    const std::vector<Layer> layers = layOut({one}, scale, options)[0].layers;
    ASSERT_EQ(layers.size(), 3u);  // the drawing, the bar, the title
    Eigen::AlignedBox2d bar;
    std::vector<std::string> words;
    for (const auto& item : layers[1].sheet.items) {
      if (const auto* text = std::get_if<Text>(&item)) words.push_back(text->text);
      if (const auto* field = std::get_if<Shape>(&item))
        for (const Eigen::Vector2d& corner : field->lines[0]) bar.extend(corner);
    }
    EXPECT_EQ(bar.sizes(), Eigen::Vector2d(50 * scale, 2));
    EXPECT_EQ(words, (std::vector<std::string>{"0", "5 cm", ratio}));
    EXPECT_EQ(std::get<Text>(layers[2].sheet.items[0]).text, "Trench 3");
  }
}

}  // namespace
}  // namespace ostraka::drawing
