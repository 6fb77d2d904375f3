#include "base/text.h"

#include <gtest/gtest.h>

#include <clocale>
#include <limits>
#include <regex>
#include <vector>

#include "base/limits.h"

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

TEST(Text, BadUtf8IsSeen) {
  for (const char* text : {"", "Tell Brak, Գառնի, \U0001F3FA", "\xC2\x80", "\xE0\xA0\x80",
                           "\xED\x9F\xBF", "\xF0\x90\x80\x80", "\xF4\x8F\xBF\xBF"})
    EXPECT_TRUE(isUtf8(text)) << text;
  EXPECT_FALSE(isUtf8(std::string_view("a\0b", 3)));
  EXPECT_FALSE(isUtf8("\xC3"));              // broken off
  EXPECT_FALSE(isUtf8("\xF0\x9F\x8F"));      // broken off
  EXPECT_FALSE(isUtf8("\xE2\x82x"));         // another character within
  EXPECT_FALSE(isUtf8("\x80"));              // begins in the middle
  EXPECT_FALSE(isUtf8("\xC0\x80"));          // zero, overlong
  EXPECT_FALSE(isUtf8("\xE0\x80\x80"));      // overlong
  EXPECT_FALSE(isUtf8("\xF0\x8F\xBF\xBF"));  // overlong
  EXPECT_FALSE(isUtf8("\xED\xA0\x80"));      // half a surrogate pair
  EXPECT_FALSE(isUtf8("\xF4\x90\x80\x80"));  // beyond Unicode
  EXPECT_FALSE(isUtf8("\xFF"));
}

TEST(Text, ThatNoDocumentCanHoldIsRefused) {
  const std::string longest(limits::kValueBytes.most, 'x');
  for (const std::string& text : {std::string("two\nlines\tand \u202Emore"), longest})
    EXPECT_TRUE(checkText(text)) << text.substr(0, 40);
  EXPECT_EQ(checkText(longest + "x").error().what, "The text is longer than 1 MB.");
  EXPECT_EQ(checkText(std::string("a\0b", 3)).error().what,
            "The text is not valid UTF-8 or contains a zero byte.");
  EXPECT_EQ(checkText("\x1B[2J").error().what,
            "The text contains control characters, which documents cannot contain; type it again.");
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

TEST(Text, AShareIsRoundedDown) {
  EXPECT_EQ(wholePercent(0.9996), 99);
  EXPECT_EQ(wholePercent(0.29), 29) << "though 0.29 * 100 is a little less";
  EXPECT_EQ(wholePercent(1), 100);
  EXPECT_EQ(wholePercent(1.0000001), 100);
}

}  // namespace
}  // namespace ostraka
