#include "store/values.h"

#include <gmock/gmock.h>

#include <chrono>
#include <clocale>
#include <map>

#include "base/limits.h"

namespace ostraka::store {
namespace {

TEST(Values, TextsThatNoDocumentCanHoldAreRefused) {
  EXPECT_EQ(*checkedText(" two\nlines\tand \u202Emore "), "two\nlines\tand \u202Emore");
  for (const char* text : {"a\x01"
                           "b",
                           "a\v", "\x1B[2J", "x\uFFFEy", "\uFFFF"})
    EXPECT_EQ(
        checkedText(text).error().what,
        "The text contains control characters, which documents cannot contain; type it again.");
}

TEST(Values, DaysThatDoNotExistAreRefused) {
  for (const char* day : {"2026-07-14", "2024-02-29", "2000-02-29", "1999-12-31"})
    EXPECT_TRUE(checkedDay(day)) << day;
  for (const char* day : {"14.7.2026", "2026-7-14", "2026-02-29", "1900-02-29", "2026-13-01",
                          "2026-00-10", "2026-04-31", "2026-07-14T10", "07/14/2026"})
    EXPECT_FALSE(checkedDay(day)) << day;
  EXPECT_EQ(*checkedDay("  "), "");
}

TEST(Values, AnUncertaintyStandsBehindAnyOfThreeSigns) {
  using Parts = std::pair<std::string, std::optional<std::string>>;
  for (const char* text : {"12,5 ± 0,4", "12,5+-0,4", " 12,5 +/- 0,4 "})
    EXPECT_EQ(splitPlusMinus(text), Parts("12,5", "0,4")) << text;
  EXPECT_EQ(splitPlusMinus(" -12,5 "), Parts("-12,5", std::nullopt));
}

TEST(Values, WhatIsTooLongForAColourIsNone) {
  EXPECT_FALSE(checkedMunsell(std::string(limits::kValueBytes.most, '5')));
}

TEST(Values, ANumberWithACommaBeforeThreeDigitsCanBeReadInTwoWays) {
  EXPECT_EQ(readsOneWay("1.250", '.').error().sentence(),
            "'1.250' can be read as 1250 or as 1,2500; write one of the two.");
  EXPECT_TRUE(readsOneWay("1.2500", '.')) << "what is offered is read in one way";
  EXPECT_TRUE(readsOneWay("1.250")) << "the comma stands between thousands";
  EXPECT_TRUE(readsOneWay("1250,125", '.'));
  EXPECT_EQ(readsOneWay("1,250").error().sentence(),
            "'1,250' can be read as 1250 or as 1.2500; write one of the two.");
  for (const char* two : {"+12,500", "100,000", "1,250 ± 3", "2 ± 1,250", "12,5 +- 1,250"})
    EXPECT_FALSE(readsOneWay(two)) << two;
  for (const char* one : {"", ",", ",250", "1,25", "12,5", "0,125", "1250,125", "1 250,125",
                          "1.250", "1,250,000", "1,2505", "wide, 1"})
    EXPECT_TRUE(readsOneWay(one)) << one;
}

TEST(Values, ANumberIsMeantToHalfAUnitOfItsLastDigit) {
  const std::map<std::string, double> steps = {{"12", 0.5},         {"12,5", 0.05},
                                               {" 2.973 ", 0.0005}, {"1.204,5", 0.05},
                                               {"1e3", 500},        {"1.5E-2", 0.0005}};
  for (const auto& [number, step] : steps) EXPECT_DOUBLE_EQ(halfStep(number), step) << number;
}

TEST(Values, AncientDatesAreWrittenInEdtf) {
  for (const char* date :
       {"-0599/-0549~", "-1149/-0799~", "-0599", "0350", "1999?", "19XX", "../-0300", "0350/..",
        "0350/", "/0350", "2026-07", "2026-21", "2026-07-14%", "-0500-XX", "Y-12000", "2026-XX-05"})
    EXPECT_TRUE(checkedEdtf(date)) << date;
  for (const char* date : {"600 BC", "-599", "..", "/", "../..", "0350//0400", "X999", "19X9",
                           "2026-13", "2026-02-30", "2026-7", "Y1999", "0350-", "~"})
    EXPECT_FALSE(checkedEdtf(date)) << date;
}

TEST(Values, AnIntervalOfDatesDoesNotEndBeforeItBegins) {
  for (const char* interval :
       {"-0300/-0100", "-0100/0100", "0300/0300", "9999/..", "../-0300", "9999/", "19XX/1905",
        "1995/19XX", "-0550/-05XX", "-05XX/-0595", "2026-07-14/2026-07", "2026-07/2026-07-14",
        "2026-XX-05/2026-01", "2026-24/2026-21", "2026-09/2026-21", "Y-12000~/-9999", "Y-12000/.."})
    EXPECT_TRUE(checkedEdtf(interval)) << interval;
  for (const char* interval : {"-0100/-0300", "0400~/0300?", "0100/-0100", "1950/18XX",
                               "-04XX/-0501", "2026-07-14/2026-06", "2026-07-14/2026-07-13",
                               "2026-21/2025-24", "-9999/Y-12000", "Y12000/9999%"})
    EXPECT_FALSE(checkedEdtf(interval)) << interval;
  EXPECT_EQ(checkedEdtf("0400~/0300?").error().sentence(),
            "The interval ends before it begins: 0300? is earlier than 0400~; write the earlier "
            "date first, and years BC with a minus sign.");
}

TEST(Values, MunsellColoursHaveHueValueAndChroma) {
  for (const char* colour : {"10YR 3/1", "7.5YR 5.5/4", "N 4/", "N 4/0", "5PB 3/2", "2.5Y 8/2"})
    EXPECT_TRUE(checkedMunsell(colour)) << colour;
  for (const char* colour :
       {"10YR3/1", "10YR", "YR 3/1", "10XX 3/1", "brown", "10YR 3", "10YR /1", "N4/ "})
    EXPECT_FALSE(checkedMunsell(colour)) << colour;
  EXPECT_EQ(*checkedMunsell("2.5yr 5/6"), "2.5YR 5/6");
}

TEST(Values, NumbersAreReadWithPointOrCommaInEveryLocale) {
  EXPECT_DOUBLE_EQ(*parsedNumber("12.5"), 12.5);
  EXPECT_DOUBLE_EQ(*parsedNumber(" 12,5 "), 12.5);
  EXPECT_DOUBLE_EQ(*parsedNumber("+3"), 3);
  EXPECT_DOUBLE_EQ(*parsedNumber("1e3"), 1000);
  for (const char* text : {"1 234,5", "1\u00A0234.5", "1\u202F234,5", "1\u2019234,5", "1.234,5",
                           "1,234.5", "+1.234,50"})
    EXPECT_DOUBLE_EQ(*parsedNumber(text), 1234.5) << text;
  EXPECT_DOUBLE_EQ(*parsedNumber("1 234 567"), 1234567);
  EXPECT_DOUBLE_EQ(*parsedNumber("-12.345.678,9"), -12345678.9);
  EXPECT_DOUBLE_EQ(*parsedNumber("1.204"), 1.204) << "one mark alone is the decimal one";
  for (const char* text : {"1.23,5", "1.2345,6", "1234.567,8", "0.204,5", ".204,5", "1,2.345,6",
                           "1.234,5.6", "1.2x4,5"})
    EXPECT_FALSE(parsedNumber(text)) << text;
  for (const char* text : {"12 34", "1 2345", "1 23,5", "1  234", "1 234 mm"})
    EXPECT_FALSE(parsedNumber(text)) << text;
  for (const char* text : {"", "12.5 mm", "1,2,3", "nan", "inf", "0x10", "1e999", "--1"})
    EXPECT_FALSE(parsedNumber(text)) << text;
}

TEST(Values, ANumbersTextReadsBackAsTheSameNumber) {
  for (const double value : {0.1, 61.42, 1.0 / 3, 500.0, 1e-7, 123456789.125})
    EXPECT_EQ(*parsedNumber(numberText(value)), value) << numberText(value);
  EXPECT_EQ(numberText(500), "500");
}

TEST(Values, TermsAreSplitAtSemicolonsWithoutDoubles) {
  EXPECT_THAT(splitTerms(" rim;neck ; rim;; "), testing::ElementsAre("rim", "neck"));
  EXPECT_EQ(joinTerms({"rim", "neck"}), "rim; neck");
  EXPECT_THAT(termsFromJson(termsJson({"a\"b", "é"})), testing::ElementsAre("a\"b", "é"));
  EXPECT_TRUE(termsFromJson("{not json").empty());
}

TEST(Values, AsManyTermsAsAFieldHoldsAreSplitInASecond) {
  std::string text;
  for (int i = 0; i < 200'000; ++i) text += std::to_string(i) + "; ";
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_EQ(splitTerms(text).size(), 200'000u);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(5))
      << "compared with each other they take minutes";
}

TEST(Values, ABatchesNumberNamesAFolderOnAnySystem) {
  for (const std::string& number :
       {std::string("B0001"), std::string("B999999999"), std::string("2026-07-14"),
        std::string("CONE"), std::string(64, 'x')})
    EXPECT_TRUE(checkedBatchNumber(number)) << number;
  for (const std::string& number :
       {std::string(), std::string("../x"), std::string("CON"), std::string("nul"),
        std::string("com1.txt"), std::string("LPT9"), std::string("B1."), std::string("B1 "),
        std::string("B\u202E1"), std::string(65, 'x'), std::string("B1234567890"),
        std::string("B9223372036854775807")})
    EXPECT_FALSE(checkedBatchNumber(number)) << number;
}

TEST(Values, PathsThatLeaveTheProjectAreRefused) {
  EXPECT_EQ(*checkedPath("batches/B0001/front/cam0.jpg"), "batches/B0001/front/cam0.jpg");
  EXPECT_EQ(*checkedPath("a/E\xCC\x81.ply"), "a/E\xCC\x81.ply") << "as the disk has it";
  for (const char* path : {"", "/etc/passwd", "../x", "a/../b", "a//b", "./a", "a/.", "C:/x",
                           "a\\b", "a\nb", "a/\xFF"})
    EXPECT_FALSE(checkedPath(path)) << path;
}

}  // namespace
}  // namespace ostraka::store
