#include "sherds/filter.h"

#include <gmock/gmock.h>

#include "catalogue/settings.h"
#include "records/sherd.h"
#include "sherds/numbers.h"
#include "sherds/sherd_fields.h"
#include "sherds/sherds.h"
#include "store/names.h"
#include "tests/core/catalogue/small_project.h"

namespace ostraka::sherds {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class Filters : public catalogue::SmallProject {
 protected:
  Filters() {
    add(context12, bag4,
        {{"part", "rim"},
         {"ware", "grey"},
         {"thickness_mean_mm", "6.5"},
         {"surface_out", "burnished"},
         {"note", "primary fill"}});
    add(context12, bag5,
        {{"part", "rim; neck"},
         {"ware", "Red slipped"},
         {"thickness_mean_mm", "5"},
         {"weight_g", "20"}});
    add(context13, bag1,
        {{"part", "base"},
         {"ware", "grey"},
         {"thickness_mean_mm", "12,5"},
         {"condition", "burnt"}});
    add(context13, {}, {{"part", "body"}});
  }
  void add(store::ContextRow in, store::BagRow of,
           const std::map<std::string, std::string>& fields) {
    const store::SherdRow row = draft(in, of);
    EXPECT_TRUE(Numbers(catalogue()).assign(std::span(&row, 1), anna));
    for (const auto& [field, value] : fields) EXPECT_TRUE(set(row, field, value)) << field;
  }
  /// What a label carries of the identifier of the sherd with this number.
  std::string labelEnd(const std::string& number) {
    const std::string id = valueOf(*Sherds(catalogue()).byNumber(number), "uuid");
    return id.substr(id.size() - 8);
  }
  /// Last letters of the numbers: 12-0001 is "a", 12-0002 "b", 13-0001 "c", 13-0002 "d".
  std::string letters(const std::string& line, const records::SherdOrder& order = {}) {
    std::string out;
    for (const std::string& number : found(line, order))
      out += number == "ARM1-T3-0012-0001"   ? 'a'
             : number == "ARM1-T3-0012-0002" ? 'b'
             : number == "ARM1-T3-0013-0001" ? 'c'
             : number == "ARM1-T3-0013-0002" ? 'd'
                                             : '?';
    return out;
  }
};

TEST_F(Filters, WordsAreLookedForInAllTextsAndAllMustBeThere) {
  EXPECT_EQ(letters(""), "abcd");
  EXPECT_EQ(letters("rim"), "ab") << "also inside 'primary', which is sherd a again";
  EXPECT_EQ(letters("GREY"), "ac");
  EXPECT_EQ(letters("grey rim"), "a");
  EXPECT_EQ(letters("slip"), "b");
  EXPECT_EQ(letters("\"red slipped\""), "b");
  EXPECT_EQ(letters("0013"), "cd");
  EXPECT_EQ(letters("unicorn"), "");
}

TEST_F(Filters, TheLineOfTheHandbookWorks) {
  EXPECT_EQ(letters("rim T3 thickness>6"), "a");
}

TEST_F(Filters, AnyIFindsAnyOtherAsInTurkish) {
  const store::SherdRow row = *Sherds(catalogue()).byNumber("ARM1-T3-0013-0002");
  ASSERT_TRUE(set(row, "note", "İZNİK IŞIK, kırmızı"));
  for (const char* word : {"iznik", "İznik", "İZNİK", "IZNIK", "ışık", "IŞIK", "işik", "KIRMIZI",
                           "kırmızı", "kirmizi"})
    EXPECT_EQ(letters(word), "d") << word;
}

TEST_F(Filters, ShortWordsAreWholePlacesOrBags) {
  EXPECT_EQ(letters("T3"), "abcd");
  EXPECT_EQ(letters("T4"), "");
  EXPECT_EQ(letters("4"), "a") << "bag 4";
}

TEST_F(Filters, NumbersAreCompared) {
  EXPECT_EQ(letters("thickness>6"), "ac");
  EXPECT_EQ(letters("thickness>=6.5"), "ac");
  EXPECT_EQ(letters("thickness>6,5"), "c");
  EXPECT_EQ(letters("thickness_mean_mm<6"), "b");
  EXPECT_EQ(letters("thickness<=5"), "b");
  EXPECT_EQ(letters("thickness:12.5"), "c");
  EXPECT_EQ(letters("weight:*"), "b");
  EXPECT_EQ(letters("weight:\"\""), "acd");
  const Result<Filter> two_ways = parseFilter("rim weight>1,250");
  ASSERT_FALSE(two_ways);
  EXPECT_EQ(two_ways.error().what,
            "'1,250' can be read as 1250 or as 1.2500; write one of the two.");
  EXPECT_EQ(two_ways.error().where, "weight>1,250");
  EXPECT_TRUE(parseFilter("weight>1.250")) << "as tables are written";
}

TEST_F(Filters, ANumberIsEqualAsFarAsItsDigitsAreTyped) {
  ASSERT_TRUE(
      set(*Sherds(catalogue()).byNumber("ARM1-T3-0013-0002"), "thickness_mean_mm", "2.97296"));
  for (const char* line : {"thickness=2.973", "thickness:2,97", "thickness=3.0", "thickness=3"})
    EXPECT_EQ(letters(line), "d") << line;
  for (const char* line : {"thickness=2.972", "thickness=2.9", "thickness=2.97300", "thickness=2"})
    EXPECT_EQ(letters(line), "") << line;
  EXPECT_EQ(letters("-thickness=3"), "abc");
}

TEST_F(Filters, DaysMonthsAndYearsAreCompared) {
  records::ContextRecord c = *catalogue::Places(catalogue()).context(context13);
  c.excavated_on = "2025-07-31";
  ASSERT_TRUE(catalogue::Places(catalogue()).save(c, anna));
  EXPECT_EQ(letters("excavated:2025-07-31"), "cd");
  EXPECT_EQ(letters("excavated:2025-07"), "cd");
  EXPECT_EQ(letters("excavated:2025"), "cd");
  EXPECT_EQ(letters("excavated>=2025-07-01 excavated<=2025-07-31"), "cd");
  EXPECT_EQ(letters("excavated>2025-07"), "") << "not in that month";
  EXPECT_EQ(letters("excavated<2026"), "cd") << "not those that have no day";
  EXPECT_EQ(letters("-excavated:2025"), "ab");
  EXPECT_EQ(letters("excavated:\"\""), "ab");
  EXPECT_EQ(letters("excavated:*"), "cd");
  // 21 September 2026, in some places of the Earth a day more or less.
  EXPECT_EQ(letters("entered:2026-09"), "abcd");
  EXPECT_EQ(letters("entered>=2026-09-20 entered<=2026-09-22"), "abcd");
  EXPECT_EQ(letters("entered<2026-09-20"), "");
  EXPECT_EQ(letters("entered>2026-09-22"), "");
  for (const char* line : {"entered:1.7.2026", "entered>July", "entered>=2026-13", "entered>26"})
    EXPECT_FALSE(parseFilter(line)) << line;
}

TEST_F(Filters, ATextFieldIsFoundByAWordInIt) {
  const store::SherdRow row = *Sherds(catalogue()).byNumber("ARM1-T3-0013-0002");
  ASSERT_TRUE(set(row, "fabric", "shell tempered, Ähren, 2 mm"));
  ASSERT_TRUE(set(row, "vessel", "pot 12"));
  for (const char* line : {"fabric:shell", "fabric:TEMPER", "fabric:ähren", "fabric:mm", "fabric:2",
                           "vessel:12", "fabric:\"shell tempered, Ähren, 2 mm\""})
    EXPECT_EQ(letters(line), "d") << line;
  EXPECT_EQ(letters("-fabric:shell"), "abc");
  EXPECT_EQ(letters("fabric:\"shell\""), "") << "in quotation marks the whole field is meant";
  EXPECT_EQ(letters("vessel:1"), "") << "a number is not a part of another";
  EXPECT_EQ(letters("fabric:sh"), "") << "nor a short word of a longer one";
  EXPECT_EQ(letters("ware:gre"), "ac");
  EXPECT_EQ(letters("ware:slipped"), "b");
}

TEST_F(Filters, CustomFieldsAreSearchedLikeTexts) {
  const store::SherdRow row = *Sherds(catalogue()).byNumber("ARM1-T3-0013-0002");
  ASSERT_TRUE(set(row, "extra.Drawn by", "Méline K."));
  ASSERT_TRUE(set(row, "extra.shelf", "12"));
  for (const char* line :
       {"méline", "extra.shelf:12", "extra.SHELF:*", "\"Drawn by\":MÉLINE",
        "extra.\"drawn by\":méline", "\"Drawn by\":\"méline k.\"", "extra.shelf:\"12\""})
    EXPECT_EQ(letters(line), "d") << line;
  EXPECT_EQ(letters("-\"Drawn by\":méline"), "abc");
  EXPECT_EQ(letters("extra.shelf:\"\""), "abc");
  EXPECT_EQ(letters("extra.shelf:1"), "");
  EXPECT_EQ(letters("\"Drawn by\":\"méline\""), "");
  EXPECT_EQ(letters("extra.nothing:12"), "");
  EXPECT_FALSE(parseFilter("extra.shelf>5"));
  ASSERT_TRUE(set(row, "extra.Drawn by", ""));
  EXPECT_EQ(letters("méline"), "");
}

TEST_F(Filters, OtherFieldsAreComparedWhole) {
  EXPECT_EQ(letters("part:rim"), "ab");
  EXPECT_EQ(letters("part:neck"), "b");
  EXPECT_EQ(letters("ware:grey"), "ac");
  EXPECT_EQ(letters("ware:GREY"), "ac");
  EXPECT_EQ(letters("part:ri"), "");
  EXPECT_EQ(letters("context:0013"), "cd");
  EXPECT_EQ(letters("trench:t3 bag:5"), "b");
  EXPECT_EQ(letters("site:ARM1 bag:\"\""), "d");
  EXPECT_EQ(letters("state:draft"), "");
  EXPECT_EQ(letters("surface_out:*"), "a");
}

TEST_F(Filters, ANumberIsFoundByPartsOfIt) {
  EXPECT_EQ(letters("number:arm1-t3-13-2"), "d") << "the whole number";
  EXPECT_EQ(letters("number:t3-0012"), "ab");
  EXPECT_EQ(letters("number:T3/12"), "ab");
  EXPECT_EQ(letters("number:0012-0002"), "b");
  EXPECT_EQ(letters("number:2 context:0013"), "d");
  EXPECT_EQ(letters("-number:12"), "cd");
  for (const char* no_part : {"number:3-0012", "number:t3-001", "number:0012-t3", "number:arm"})
    EXPECT_EQ(letters(no_part), "") << no_part;
  EXPECT_EQ(letters("number:\"t3-0012\""), "") << "exactly this";
  EXPECT_EQ(letters("number:\"arm1-t3-0012-1\""), "a");
}

TEST_F(Filters, TermsAreFoundHoweverTheVocabularySpellsThem) {
  std::vector<records::Term> wares = *catalogue::Settings(catalogue()).vocabulary("part");
  wares.push_back({"Terra Sigillata", {{"de", "Glanztonware"}}, {}});
  wares.push_back({"TS", {}, {}});
  ASSERT_TRUE(catalogue::Settings(catalogue()).setVocabulary("part", wares, anna));
  add(context13, bag1, {{"part", "Terra Sigillata"}});
  add(context13, bag1, {{"part", "TS"}});
  EXPECT_EQ(letters("part:\"Terra Sigillata\""), "?");
  EXPECT_EQ(letters("part:\"terra sigillata\""), "?");
  EXPECT_EQ(letters("part:glanztonware"), "?");
  EXPECT_EQ(letters("part:terra"), "");
  EXPECT_EQ(letters("ts"), "?");
  EXPECT_EQ(letters("-part:ts part:\"terra sigillata\""), "?");
}

TEST_F(Filters, AWordOfAnotherLanguageFindsTheTermThatItMeans) {
  EXPECT_FALSE(found("rim").empty());
  EXPECT_EQ(found("bord"), found("rim"));
  EXPECT_EQ(found("part:Rand"), found("part:rim"));
  EXPECT_EQ(found("-χείλος").size() + found("χείλος").size(), found("").size());
}

TEST_F(Filters, TheCodeOfAPrintedLabelFindsItsSherd) {
  const std::string b = "ARM1-T3-0012-0002:" + labelEnd("ARM1-T3-0012-0002");
  EXPECT_EQ(letters("OST1:S:" + b), "b");
  EXPECT_EQ(letters("ost1:s:" + store::uniqueKey(b)), "b") << "a reader set to small letters";
  const Result<Filter> filter = parseFilter("OST1:S:" + b);
  ASSERT_TRUE(filter);
  EXPECT_EQ(filter->text(), "label:OST1:S:" + b);
  EXPECT_EQ(letters(filter->text()), "b") << "the chip's words give the filter again";
  EXPECT_EQ(letters("-label:OST1:S:" + b), "acd");
  EXPECT_EQ(letters("OST1:S:ARM1-T3-0012-0002:00000000"), "") << "a label of another project";
  EXPECT_FALSE(parseFilter("OST1:S:ARM1")) << "half a code";
  EXPECT_FALSE(parseFilter("OST1:S:ARM1-T3-0012-0002:9F3A")) << "half a code";
}

TEST_F(Filters, ALabelFindsItsSherdWhateverItsNumberIs) {
  for (const char* number : {"12:7", "box 3: 7"}) {
    const store::SherdRow row = numbered(context13);
    ASSERT_TRUE(set(row, "number", number));
    const std::string code = std::string("OST1:S:") + number + ":" + labelEnd(number);
    EXPECT_THAT(found(code), ElementsAre(number));
    EXPECT_THAT(found(parseFilter(code)->text()), ElementsAre(number));
    ASSERT_TRUE(set(row, "number", std::string("N") + number));
    EXPECT_THAT(found(code), ElementsAre(std::string("N") + number)) << "numbered anew";
  }
}

TEST_F(Filters, ALabelWithAPlaceOnThePlateFindsTheSherdThatLayThere) {
  const store::BatchRow batch = newBatch({bag4});
  const store::ScanRow front = scan(batch, batch::Side::Front, 1);
  const store::ScanRow back = scan(batch, batch::Side::Back, 1);
  records::SherdRecord sherd;
  sherd.context = context12;
  sherd.batch = batch;
  sherd.front = front;
  sherd.back = back;
  const auto row = Sherds(catalogue()).add(sherd, anna);
  ASSERT_TRUE(row) << row.error().sentence();
  EXPECT_EQ(Sherds(catalogue()).rows(*parseFilter("OST1:S:B0001-01"), {})->size(), 1u);
  EXPECT_EQ(Sherds(catalogue()).rows(*parseFilter("ost1:s:b0001-01"), {})->at(0), *row);
  EXPECT_THAT(found("OST1:S:B0001-02"), IsEmpty());
  ASSERT_TRUE(Numbers(catalogue()).assign(std::span(&*row, 1), anna));
  EXPECT_THAT(found("OST1:S:B0001-01"), ElementsAre("ARM1-T3-0012-0003"));
}

TEST_F(Filters, AMinusTurnsAConditionRound) {
  EXPECT_EQ(letters("-grey"), "bd");
  EXPECT_EQ(letters("-part:rim"), "cd");
  EXPECT_EQ(letters("-bag:1"), "abd") << "also what has no bag";
  EXPECT_EQ(letters("-thickness>6"), "bd") << "also what has no thickness";
}

TEST_F(Filters, TheOrderPutsWhatIsNotRecordedLast) {
  EXPECT_EQ(letters("", {"thickness_mean_mm", false}), "bacd");
  EXPECT_EQ(letters("", {"thickness_mean_mm", true}), "cabd");
  EXPECT_EQ(letters("", {"number", true}), "dcba");
  EXPECT_EQ(letters("", {"ware", false}), "bacd") << "R before g, as bytes; none last";
  EXPECT_EQ(letters("", {"bag", false}), "cabd");
  EXPECT_EQ(letters("", {"context", true}), "cdab");
  for (const records::SherdField& field : sherds::sherdFields())
    if (std::string(field.name) != "joins") {
      EXPECT_EQ(letters("", {field.name, false}).size(), 4u) << field.name;
    }
  EXPECT_EQ(letters("rim", {"updated", true}), "ba");
}

TEST_F(Filters, WhatIsNotUnderstoodIsNamed) {
  const auto why = [](const char* line) {
    const Result<Filter> filter = parseFilter(line);
    return filter ? std::string("accepted") : filter.error().sentence().english();
  };
  EXPECT_NE(why("rim colour:red").find("colour:red: The filter has no field 'colour'"),
            std::string::npos);
  EXPECT_NE(why("ware>5").find("Only measurements"), std::string::npos);
  EXPECT_NE(why("thickness>thick").find("'thick' is not a number"), std::string::npos);
  EXPECT_NE(why("\"open").find("quotation mark"), std::string::npos);
  EXPECT_EQ(why("\"a:b\" - -- \"\" :"), "accepted");
  EXPECT_NE(why("rim' OR 1=1").find("no field '1'"), std::string::npos);
}

TEST_F(Filters, SignsOfTheSearchEngineAreOnlyLetters) {
  for (const char* line : {"a*b AND", "NEAR(x y)", "\"say \"\"hi\"\"\"", "rim^2", "100%", "(((",
                           "'; DROP TABLE sherd", "{words}"})
    EXPECT_EQ(letters(line), "") << line;
  EXPECT_EQ(letters("\"rim\""), "ab");
}

TEST_F(Filters, TheChipsGiveTheLineAgain) {
  const char* line = "rim -part:lid thickness>6 \"red slip\"";
  const Filter filter = *parseFilter(line);
  EXPECT_EQ(filter.text(), line);
  ASSERT_EQ(filter.conditions.size(), 4u);
  EXPECT_EQ(filter.conditions[1].text, "-part:lid");
  EXPECT_TRUE(filter.conditions[1].negated);
  EXPECT_EQ(filter.conditions[2].field, "thickness_mean_mm");
  EXPECT_EQ(filter.conditions[3].value, "red slip");
}

TEST_F(Filters, FindPlacesWhoseNamesHaveBlanks) {
  add(context("K 12"), {}, {});
  for (const char* line : {"K 12", "K12", "k12", "context:K 12", "context:k12", "context:\"K 12\"",
                           "context:K 12 site:ARM1", "\"K 12\""})
    EXPECT_EQ(letters(line), "?") << line;
  EXPECT_EQ(letters("-K12"), "abcd");
  EXPECT_EQ(letters("T3 0012"), "ab") << "two places, not one";
}

}  // namespace
}  // namespace ostraka::sherds
