#include "records/numbering.h"

#include <gtest/gtest.h>

namespace ostraka::records {
namespace {

const std::map<std::string, std::string> kPlace = {{"site", "ARM1"},    {"trench", "T3"},
                                                   {"context", "0012"}, {"bag", "4"},
                                                   {"yyyy", "2026"},    {"yy", "26"}};

TEST(Numbering, TheHousesOwnSchemeGivesTheHousesOwnNumber) {
  const Result<Numbering> scheme = Numbering::parse("{site}-{trench}-{context}-{n:04}");
  ASSERT_TRUE(scheme) << scheme.error().what;
  EXPECT_EQ(*scheme->number(kPlace, 7), "ARM1-T3-0012-0007");
  EXPECT_EQ(*scheme->counter(kPlace), "ARM1-T3-0012-{n}");
}

TEST(Numbering, AWidthIsALeastWidth) {
  const Result<Numbering> scheme = Numbering::parse("{n:03}/{bag:02}.{yy}");
  ASSERT_TRUE(scheme) << scheme.error().what;
  EXPECT_EQ(*scheme->number(kPlace, 7), "007/04.26");
  EXPECT_EQ(*scheme->number(kPlace, 12345), "12345/04.26");
}

TEST(Numbering, SchemesThatCannotWorkAreRefusedWithTheReason) {
  const auto why = [](const char* scheme) {
    const Result<Numbering> parsed = Numbering::parse(scheme);
    return parsed ? std::string("accepted") : parsed.error().what.english();
  };
  EXPECT_NE(why("{site}{n}").find("adjacent"), std::string::npos);
  EXPECT_NE(why("{site}-x").find("exactly once"), std::string::npos);
  EXPECT_NE(why("{n}-{n}").find("exactly once"), std::string::npos);
  EXPECT_NE(why("{area}-{n}").find("no token {area}"), std::string::npos);
  EXPECT_NE(why("{n").find("does not close"), std::string::npos);
  EXPECT_NE(why("a b-{n}").find("character ' '"), std::string::npos);
  EXPECT_NE(why("{n:4}").find(":04"), std::string::npos);
  EXPECT_NE(why("{n:099}").find(":04"), std::string::npos);
  EXPECT_EQ(why("{n}"), "accepted");
}

TEST(Numbering, APlaceThatIsNotRecordedIsNamed) {
  const Result<std::string> number = Numbering::parse("{batch}-{n}")->number(kPlace, 1);
  ASSERT_FALSE(number);
  EXPECT_NE(number.error().what.english().find("batch"), std::string::npos);
}

TEST(Numbering, APartThatThePlaceDoesNotHaveIsLeftOutWithItsSeparator) {
  const std::map<std::string, std::string> place = {
      {"site", "GRB"}, {"trench", ""}, {"context", "K12"}};
  const auto number = [&](const char* scheme) {
    return *Numbering::parse(scheme)->number(place, 7);
  };
  EXPECT_EQ(number("{site}-{trench}-{context}-{n:03}"), "GRB-K12-007");
  EXPECT_EQ(number("{trench}/{n}"), "7");
  EXPECT_EQ(number("{context}.{n}-{trench}"), "K12.7");
  EXPECT_EQ(*Numbering::parse("{site}-{trench}-{n}")->counter(place), "GRB-{n}");
}

TEST(NumberCount, KnowsItsNumbersWhateverTheSpellingOfThePlace) {
  const NumberCount count("ARM1-T3-K 12-{n}");
  EXPECT_EQ(count.of("ARM1-T3-K 12-0007"), 7);
  EXPECT_EQ(count.of("arm1-t3-k12-41"), 41);
  for (const char* other : {"ARM1-T3-K 12-", "ARM1-T3-K 12-7a", "ARM1-T3-K 1-0007", "0007",
                            "ARM1-T3-K 12-1234567890123"})
    EXPECT_FALSE(count.of(other)) << other;
  EXPECT_EQ(NumberCount("{n}/K12.26").of("008/k 12.26"), 8);
}

TEST(Numbering, AValueThatHoldsTheSignBesideItWarns) {
  const Numbering scheme = *Numbering::parse("{site}-{context}-{n}");
  EXPECT_EQ(scheme.warning(kPlace), "");
  EXPECT_NE(scheme.warning({{"site", "ARM1"}, {"context", "12-3"}}).english().find("12-3"),
            std::string::npos);
}

}  // namespace
}  // namespace ostraka::records
