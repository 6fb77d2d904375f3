#include "drawing/wording.h"

#include <gtest/gtest.h>

namespace ostraka::drawing {
namespace {

TEST(Wording, IsEnglishWithADecimalPointUnlessToldOtherwise) {
  const Wording plain;
  EXPECT_EQ(plain.said(message("Scale %1", "1:2")), "Scale 1:2");
  EXPECT_EQ(plain.number(12.34, 1), "12.3");
  EXPECT_EQ(plain.shortNumber(0.5), "0.5");
}

TEST(Wording, PutsTheReadersWordsAndDecimalSign) {
  Wording german;
  german.translated = [](const Message& words) {
    return words.templateWords() == "Scale %1" ? "Maßstab " + words.values()[0].english()
                                               : words.english();
  };
  german.decimal = ",";
  EXPECT_EQ(german.said(message("Scale %1", "1:2")), "Maßstab 1:2");
  EXPECT_EQ(german.number(12.34, 1), "12,3");
  EXPECT_EQ(german.number(12, 0), "12") << "nothing to replace";
  EXPECT_EQ(german.shortNumber(3.25), "3,25");
}

}  // namespace
}  // namespace ostraka::drawing
