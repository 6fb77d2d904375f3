#include "store/names.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <set>
#include <vector>

namespace ostraka::store {
namespace {

TEST(Names, AFoldersNameLeadsNowhereElse) {
  for (const char* name : {"B0001", "B-1.2", "Գառնի", "CON"})
    EXPECT_TRUE(isFolderName(name)) << name;
  for (const char* name : {"", ".", "..", ".git", "/abs", "../x", "a/b", "a\\b", "a b", "a\n", "%",
                           "\xFF", "E\xCC\x81"})
    EXPECT_FALSE(isFolderName(name)) << name;
}

TEST(Names, LettersThatNobodySeesAreSeen) {
  for (const char* text :
       {"\u200B", "A\u200F1", "\u202A", "B\u202E1", "\u2066", "1\u2069", "\uFEFF1"})
    EXPECT_TRUE(hasInvisible(text)) << text;
  for (const char* text : {"", "B0001", "Գառնի", "\u2010", "É-1"})
    EXPECT_FALSE(hasInvisible(text)) << text;
}

TEST(Names, TheSameLettersHaveTheSameKeyHoweverTheyAreWritten) {
  EXPECT_EQ(uniqueKey("É-1"), uniqueKey("é-1"));
  EXPECT_EQ(uniqueKey("E\xCC\x81-1"), uniqueKey("é-1"));  // E and a combining accent
  EXPECT_EQ(uniqueKey("ARM1-T3"), "arm1-t3");
  EXPECT_EQ(uniqueKey("Straße"), uniqueKey("STRASSE"));
  EXPECT_NE(uniqueKey("0012"), uniqueKey("12"));
}

TEST(Names, NumbersAreOrderedByTheirValue) {
  std::vector<std::string> names = {"A10", "a9", "A100", "B1", "A009", "A9-10", "A9-2"};
  std::sort(names.begin(), names.end(),
            [](const auto& a, const auto& b) { return sortKey(a) < sortKey(b); });
  EXPECT_THAT(names,
              testing::ElementsAre(testing::AnyOf("a9", "A009"), testing::AnyOf("a9", "A009"),
                                   "A9-2", "A9-10", "A10", "A100", "B1"));
}

TEST(Names, WhatPeopleReadAsOneNumberHasOnePlaceInTheOrder) {
  EXPECT_EQ(sortKey("ARM-007"), sortKey("arm/0007"));
  EXPECT_EQ(sortKey("K 7"), sortKey("K \u2013 7"));
  EXPECT_EQ(sortKey("\u0533-7"), sortKey("\u0563.07"));
  EXPECT_NE(sortKey("1-12"), sortKey("11-2"));
  EXPECT_NE(sortKey("12"), sortKey("12a"));
  EXPECT_NE(sortKey("70"), sortKey("7"));
  EXPECT_NE(sortKey("0"), sortKey(""));
}

TEST(Names, AFileNameHoldsNothingThatAFileSystemOrAManifestCouldMisread) {
  EXPECT_EQ(slug("Ar/Ts.WSH.02.C.12"), "Ar_Ts.WSH.02.C.12");
  EXPECT_EQ(slug("../x"), "_._x");
  EXPECT_EQ(slug("a%b\nc d"), "a_b_c_d");
  EXPECT_EQ(slug(""), "_");
  EXPECT_EQ(slug("Գ-1"), "Գ-1");
}

TEST(Names, AFileNameIsOneThatWindowsCanHold) {
  EXPECT_EQ(slug("CON"), "CON_");
  EXPECT_EQ(slug("aux.2"), "aux_.2") << "an ending does not help";
  EXPECT_EQ(slug("Com1"), "Com1_");
  EXPECT_EQ(slug("LPT9..."), "LPT9_..._");
  EXPECT_EQ(slug("arm-4."), "arm-4._");
  for (const char* name : {"CONE", "CON_", "A.CON", "COM", "COM12", "arm-4.a"})
    EXPECT_EQ(slug(name), name);
}

}  // namespace
}  // namespace ostraka::store
