// What strangers named is shown; the terminal does not act on it.
#include "app/shown.h"

#include <gtest/gtest.h>

namespace ostraka::app {
namespace {

TEST(Shown, LeavesTextsOfAllLanguagesAsTheyAre) {
  for (const char* text : {"", "ARM1-T3-0012-0001\n", "column\tvalue",
                           "Գառնի, Ψωφίδα, Höyük, 12 °C", "\xff is no UTF-8", "\xe2\x80"})
    EXPECT_EQ(shown(text), text);
}

TEST(Shown, SpellsWhatATerminalWouldActOn) {
  EXPECT_EQ(shown("a\x1b[2Jb"), "a\\x1b[2Jb");
  EXPECT_EQ(shown(std::string_view("\0\r\x7f", 3)), "\\x00\\x0d\\x7f");
  EXPECT_EQ(shown("\xc2\x9b"
                  "2J"),
            "\\xc2\\x9b2J")
      << "the control sequence introducer as one character";
  EXPECT_EQ(shown("\xe2\x80\xae"
                  "gpj.exe"),
            "\\xe2\\x80\\xaegpj.exe");
  EXPECT_EQ(shown("\xe2\x81\xa6"), "\\xe2\\x81\\xa6");
}

TEST(Shown, KeepsANameInItsLine) {
  EXPECT_EQ(shownName("a\nb\tc\x1b"), "a\\x0ab\\x09c\\x1b");
  EXPECT_EQ(shownName("Höyük 1"), "Höyük 1");
}

}  // namespace
}  // namespace ostraka::app
