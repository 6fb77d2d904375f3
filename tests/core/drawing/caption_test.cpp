#include "drawing/caption.h"

#include <gmock/gmock.h>

namespace ostraka::drawing {
namespace {

using testing::ElementsAre;

SherdDrawing smallSherd() {
  SherdDrawing drawing;
  drawing.id = "ARM1-7";
  drawing.box = Eigen::AlignedBox2d(Eigen::Vector2d(-3, 0), Eigen::Vector2d(17, 30));
  drawing.measures.length_mm = 40.04;
  drawing.measures.width_mm = 30;
  return drawing;
}

std::vector<Text> captionOf(SherdDrawing& drawing) {
  addCaption(drawing, {});
  std::vector<Text> lines;
  for (const auto& item : drawing.sheet.items) lines.push_back(std::get<Text>(item));
  return lines;
}

std::vector<std::string> wordsOf(SherdDrawing drawing) {
  std::vector<std::string> words;
  for (const Text& line : captionOf(drawing)) words.push_back(line.text);
  return words;
}

TEST(Caption, NamesTheSherdAndWhatWasMeasured) {
  SherdDrawing drawing = smallSherd();
  EXPECT_THAT(wordsOf(drawing), ElementsAre("ARM1-7", "40.0 × 30.0 mm"));
  drawing.measures.thickness_mean_mm = 5.46;
  EXPECT_THAT(wordsOf(drawing), ElementsAre("ARM1-7", "40.0 × 30.0 mm, wall 5.5 mm"));
  drawing.measures.thickness_min_mm = 4;
  EXPECT_EQ(wordsOf(drawing).back(), "40.0 × 30.0 mm, wall 5.5 mm") << "one end is no range";
  drawing.measures.thickness_max_mm = 7.26;
  EXPECT_EQ(wordsOf(drawing).back(), "40.0 × 30.0 mm, wall 5.5 mm (4.0 to 7.3)");
}

TEST(Caption, TellsADiameterInCentimetresWithWhatIsKnownOfIt) {
  SherdDrawing drawing = smallSherd();
  drawing.mouth = Mouth{{233, {}}, {}, false};
  EXPECT_EQ(wordsOf(drawing).at(1), "Ø 23.3 cm");
  drawing.mouth->kept_pct = Estimate{12.4, {}};
  EXPECT_EQ(wordsOf(drawing).at(1), "Ø 23.3 cm, 12 % of the rim preserved");
  drawing.mouth->kept_pct.reset();
  drawing.mouth->diameter_mm.interval = std::pair(210.0, 261.0);
  EXPECT_EQ(wordsOf(drawing).at(1), "Ø 23.3 cm (95 %: 21.0 to 26.1)");
}

// Wider than the drawing, its neighbours on a plate would have to make room for words.
TEST(Caption, BreaksLongLinesAndTheBoxHoldsThem) {
  SherdDrawing drawing = smallSherd();
  drawing.mouth = Mouth{{233, std::pair(210.0, 261.0)}, Estimate{12, std::pair(10.0, 14.0)}, false};
  const std::vector<Text> lines = captionOf(drawing);
  ASSERT_GE(lines.size(), 4u);
  EXPECT_EQ(lines[0].weight, Weight::Bold);
  EXPECT_EQ(lines[0].at, Eigen::Vector2d(-3, 36));
  std::string mouth = lines[1].text;
  for (std::size_t k = 2; k + 1 < lines.size(); ++k) mouth += " " + lines[k].text;
  EXPECT_EQ(mouth, "Ø 23.3 cm (95 %: 21.0 to 26.1), 12 % of the rim preserved (10 to 14)");
  for (std::size_t k = 1; k < lines.size(); ++k) {
    EXPECT_LE(textWidth(lines[k]), 70) << lines[k].text;
    EXPECT_EQ(lines[k].at.x(), -3);
    EXPECT_NEAR(lines[k].at.y(), 36 + 1.45 * 4 + 1.45 * 3 * static_cast<double>(k - 1), 1e-9);
    EXPECT_GE(drawing.box.max().x(), -3 + textWidth(lines[k]));
  }
  EXPECT_NEAR(drawing.box.max().y(), lines.back().at.y() + 1, 1e-9);
  // A wide drawing has room for the same words in one line.
  SherdDrawing wide = smallSherd();
  wide.mouth = drawing.mouth;
  wide.box.extend(Eigen::Vector2d(197, 30));
  EXPECT_EQ(captionOf(wide).size(), 3u);
}

}  // namespace
}  // namespace ostraka::drawing
