#include "paper/markup.h"

#include <gtest/gtest.h>

namespace ostraka {
namespace {

TEST(Markup, EscapesWhatWouldEndATextOrAnAttribute) {
  EXPECT_EQ(markupText("a<b> & \"c\"\n'd'"), "a&lt;b&gt; &amp; &quot;c&quot; 'd'");
}

TEST(Markup, WritesNothingThatXmlForbids) {
  EXPECT_EQ(markupText("a\x01"
                       "b\uFFFE"
                       "c\uFFFF<\xED\xA0\x80>é\uFFFD"),
            "a b c &lt; &gt;é\uFFFD");
}

// As file names may be: a lone byte, '/' in two bytes, two of the three bytes of a euro sign.
TEST(Markup, WritesAReplacementForEachByteOfNoCharacter) {
  EXPECT_EQ(markupText("a\xff<"), "a\uFFFD&lt;");
  EXPECT_EQ(markupText("\xc0\xaf"), "\uFFFD\uFFFD");
  EXPECT_EQ(markupText("\xe2\x82<"), "\uFFFD\uFFFD&lt;");
  EXPECT_EQ(markupText("\xe2\x82"), "\uFFFD\uFFFD");
  EXPECT_EQ(markupText("é€\U0001F3FA"), "é€\U0001F3FA");
}

// The vectors of RFC 4648, section 10.
TEST(Markup, WritesBase64AsTheStandardDoes) {
  const char* vectors[][2] = {{"", ""},
                              {"f", "Zg=="},
                              {"fo", "Zm8="},
                              {"foo", "Zm9v"},
                              {"foob", "Zm9vYg=="},
                              {"fooba", "Zm9vYmE="},
                              {"foobar", "Zm9vYmFy"}};
  for (const auto& [plain, coded] : vectors) EXPECT_EQ(base64(plain), coded);
  EXPECT_EQ(base64(std::string("\xff\x00\xfe", 3)), "/wD+");
}

}  // namespace
}  // namespace ostraka
