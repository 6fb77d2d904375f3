// What is said to a person: a template and its values, read in English and kept apart for others.
#include "base/message.h"

#include <gtest/gtest.h>

#include "base/result.h"

namespace ostraka {
namespace {

TEST(Message, ReadsInEnglishWithItsValuesInTheirPlaces) {
  const Message words = message("%2 of the %1 photographs of %3 lie %4 mm off.", 24, std::size_t{3},
                                std::filesystem::path("a/front"), decimal(0.125, 2));
  EXPECT_EQ(words, "3 of the 24 photographs of a/front lie 0.12 mm off.");
  EXPECT_EQ(words.templateWords(), "%2 of the %1 photographs of %3 lie %4 mm off.");
  ASSERT_EQ(words.values().size(), 4u);
  EXPECT_EQ(words.values()[0].kind, MessageValue::Kind::Count);
  EXPECT_EQ(words.values()[0].count, 24);
  EXPECT_EQ(words.values()[2].kind, MessageValue::Kind::Text);
  EXPECT_EQ(words.values()[3].kind, MessageValue::Kind::Decimal);
  EXPECT_EQ(words.values()[3].number.digits, 2);
}

// A name may look like a place; a share ends in a percent sign.
TEST(Message, ShowsNoDigitsThatSayNothing) {
  const auto said = [](double value, int most) {
    return message("%1", shortDecimal(value, most)).english();
  };
  EXPECT_EQ(said(49.471, 2), "49.47");
  EXPECT_EQ(said(120, 2), "120");
  EXPECT_EQ(said(51.5, 2), "51.5");
  EXPECT_EQ(said(0.001, 6), "0.001");
  EXPECT_EQ(said(0, 2), "0");
}

TEST(Message, LeavesValuesAndOtherPercentSignsAlone) {
  EXPECT_EQ(message("%1 % of %2 is seen (%1 %).", 12, "%1"), "12 % of %1 is seen (12 %).");
  EXPECT_EQ(message("100 % of it, at 9%."), "100 % of it, at 9%.");
}

TEST(Message, HoldsOtherMessages) {
  const Message inner = message("its pages are inconsistent");
  const Message words = message("The catalogue is damaged (%1).", inner);
  EXPECT_EQ(words, "The catalogue is damaged (its pages are inconsistent).");
  ASSERT_EQ(words.values()[0].kind, MessageValue::Kind::Message);
  EXPECT_EQ(words.values()[0].message->templateWords(), "its pages are inconsistent");
  EXPECT_EQ(inOne(inner, words).values()[1].message->templateWords(), words.templateWords());
}

// Words of another program, or of a person, are no template: nobody translates them.
TEST(Message, KeepsWordsWithoutATemplate) {
  const Message words = std::string("gphoto: 5 %1");
  EXPECT_EQ(words, "gphoto: 5 %1");
  EXPECT_TRUE(words.templateWords().empty());
  EXPECT_TRUE(Message().empty());
}

TEST(Message, OfATableIsTheSame) {
  constexpr Template<1> kWords = translatable<1>("Camera %1 is gone.");
  EXPECT_EQ(message(kWords, 'A'), "Camera A is gone.");
}

TEST(Message, OfAnErrorNamesWhereItIs) {
  const Error error = Error::unusable(message("It has %1 points.", 7), "scan.ply");
  EXPECT_EQ(error.sentence(), "scan.ply: It has 7 points.");
  EXPECT_EQ(error.sentence().values()[1].message->templateWords(), "It has %1 points.");
  EXPECT_EQ(linesOf({error.sentence(), error.what}),
            "scan.ply: It has 7 points.\nIt has 7 points.");
}

}  // namespace
}  // namespace ostraka
