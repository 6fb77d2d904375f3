#include "base/text.h"

#include <gtest/gtest.h>

#include <clocale>
#include <limits>
#include <regex>
#include <vector>

namespace ostraka {
namespace {

TEST(Text, NumbersHaveTheDigitsThatAreAskedFor) {
  EXPECT_EQ(fixed(1.0 / 3, 3), "0.333");
  EXPECT_EQ(fixed(-2.5, 0), "-2");  // ties go to the even number, as IEC 60559 has it
  EXPECT_EQ(fixed(0.30, 1), "0.3");
}

TEST(Text, TheLargestNumberIsNotCutOff) {
  EXPECT_EQ(fixed(std::numeric_limits<double>::max(), 2).size(), 309u + 3u);
}

// Locales that this computer lacks change nothing: then this asks for less.
TEST(Text, IsFormattedWithAPointInAnyLocale) {
  for (const char* locale : {"C", "de_DE.UTF-8", "fr_FR.UTF-8"}) {
    std::setlocale(LC_ALL, locale);
    EXPECT_EQ(formatted("%s: %.2f mm, %g %%", "a", 1.5, 0.25), "a: 1.50 mm, 0.25 %") << locale;
  }
  std::setlocale(LC_ALL, "C");
  EXPECT_EQ(formatted("%*s", 500, "").size(), 500u) << "of any length";
}

TEST(Text, OnlyLettersOfAsciiBecomeSmall) {
  EXPECT_EQ(lowerCase("CAM0_Pos01.JPG"), "cam0_pos01.jpg");
  EXPECT_EQ(lowerCase("\xC3\x84"), "\xC3\x84");  // Ä
}

TEST(Text, KnowsWhatXmlForbids) {
  for (const char* text :
       {"\x01", "\v", "\x1F", "\uFFFE", "\uFFFF", "\xED\xA0\x80", "\xED\xBF\xBF"})
    EXPECT_EQ(forbiddenInXml(text, 0), std::string_view(text).size()) << text;
  EXPECT_EQ(forbiddenInXml(std::string_view("\0", 1), 0), 1u);
  EXPECT_EQ(forbiddenInXml("\xED\xA0", 0), 2u) << "broken off";
  for (const char* text :
       {"\t", "\n", "\r", " ", "a", "\x7F", "\uFFFD", "\uD7FF", "\uE000", "\U0001F3FA", "\xEF"})
    EXPECT_EQ(forbiddenInXml(text, 0), 0u) << text;
}

TEST(Text, WordsAreJoinedWithSomethingBetweenThem) {
  EXPECT_EQ(joined(std::vector<std::string>{"a", "", "c"}, ", "), "a, , c");
  EXPECT_EQ(joined({}, ", "), "");
}

TEST(Text, MomentsAreInUtc) {
  EXPECT_EQ(utcDay(0), "1970-01-01");
  EXPECT_EQ(utcDay(951'782'399'999), "2000-02-28");  // the last millisecond before the 29th
  EXPECT_EQ(utcDay(951'782'400'000), "2000-02-29");
  const std::regex form("[0-9]{4}-[0-9]{2}-[0-9]{2}T[0-9]{2}:[0-9]{2}:[0-9]{2}Z");
  EXPECT_TRUE(std::regex_match(utcNow(), form)) << utcNow();
}

}  // namespace
}  // namespace ostraka
