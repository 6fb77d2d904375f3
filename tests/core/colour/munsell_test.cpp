#include "colour/munsell.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace ostraka::colour {
namespace {

const MunsellChip* chipOf(const std::string& notation) {
  const auto& chips = munsellChips();
  const auto found = std::find_if(chips.begin(), chips.end(), [&](const MunsellChip& chip) {
    return chip.notation == notation;
  });
  return found == chips.end() ? nullptr : &*found;
}

// Worked out by hand from x, y of 1943 and ASTM D1535: 5YR 5/6 is (0.4420, 0.3808), Y 19.272.
TEST(Munsell, ChipsHaveTheColoursOfTheRenotation) {
  const struct {
    const char* notation;
    Lab lab;
  } known[] = {{"N 5/", {51.004, 0, 0}},
               {"5YR 5/6", {51.373, 19.631, 31.231}},
               {"10YR 3/2", {30.526, 4.763, 12.234}},
               {"10R 4/6", {41.058, 26.101, 22.009}},
               {"5PB 4/6", {40.331, -1.330, -25.424}}};
  for (const auto& [notation, lab] : known) {
    const MunsellChip* chip = chipOf(notation);
    ASSERT_NE(chip, nullptr) << notation;
    EXPECT_LT((chip->lab - lab).norm(), 0.01) << notation << ": " << chip->lab.transpose();
  }
}

TEST(Munsell, HasWhatSoilColourBooksAddAndNothingElseBetween) {
  for (const char* notation : {"5YR 4/1", "7.5YR 7/3", "5YR 2.5/1", "N 2.5/", "10YR 2/1"})
    EXPECT_NE(chipOf(notation), nullptr) << notation;
  EXPECT_LT((chipOf("5YR 4/1")->lab - Lab(40.813, 4.116, 5.214)).norm(), 0.01);
  EXPECT_LT((chipOf("5YR 2.5/1")->lab - Lab(25.326, 4.342, 4.642)).norm(), 0.01);
  for (const char* notation : {"5G 4/1", "10YR 2.5/1", "5YR 5/5", "5YR 1/2", "7.5PB 2/30"})
    EXPECT_EQ(chipOf(notation), nullptr) << notation;
}

// What the table has twice, mistyped or cut off would break a row's order.
TEST(Munsell, GetsLighterWithTheValueAndStrongerWithTheChroma) {
  const auto chroma = [](const MunsellChip& chip) { return chip.lab.tail<2>().norm(); };
  for (const char* hue : {"10R", "2.5YR", "5YR", "7.5YR", "10YR", "2.5Y", "5Y", "5B", "5RP"})
    for (int value = 2; value < 9; ++value) {
      const std::string row = std::string(hue) + ' ' + std::to_string(value) + '/';
      for (int step = 2; const MunsellChip* next = chipOf(row + std::to_string(step + 2));
           step += 2)
        EXPECT_GT(chroma(*next), chroma(*chipOf(row + std::to_string(step))) + 2) << next->notation;
      EXPECT_GT(chipOf(std::string(hue) + ' ' + std::to_string(value + 1) + "/2")->lab[0],
                chipOf(row + '2')->lab[0] + 8);
    }
}

TEST(Munsell, FindsTheNearestChipAndTheNext) {
  for (const MunsellChip& chip : {*chipOf("7.5YR 5/4"), *chipOf("N 8/"), *chipOf("2.5YR 4/8")}) {
    const MunsellMatch match = nearestMunsell(chip.lab);
    EXPECT_EQ(match.notation, chip.notation);
    EXPECT_NEAR(match.difference, 0, 1e-9);
    EXPECT_GT(match.second_difference, 0.5);
  }
  const MunsellMatch match = nearestMunsell({51.35, 12.46, 23.30});  // sRGB 152, 114, 83
  EXPECT_EQ(match.notation, "7.5YR 5/4");
  EXPECT_NEAR(match.difference, 0.87, 0.02);
  EXPECT_EQ(match.second, "5YR 5/4");
  EXPECT_NEAR(match.second_difference, 2.19, 0.02);
}

}  // namespace
}  // namespace ostraka::colour
