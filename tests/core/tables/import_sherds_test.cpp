// Sherds of a table, each row whole or not at all.
#include <gmock/gmock.h>

#include <map>
#include <utility>

#include "catalogue/batches.h"
#include "catalogue/history.h"
#include "exchange/export_folder.h"
#include "records/sherd.h"
#include "sherds/measurements.h"
#include "sherds/sherd_fields.h"
#include "sherds/sherds.h"
#include "tests/core/tables/import_fixture.h"

namespace ostraka::tables {
namespace {

using namespace catalogue;

TEST_F(Import, OfSherdsMakesThemWithAllTheirValues) {
  const ImportReport report = import(kTwo);
  EXPECT_EQ(report.fresh, 2);
  EXPECT_EQ(report.refused, 0);
  const records::SherdRecord sherd =
      *sherds::Sherds(catalogue()).get(*sherds::Sherds(catalogue()).byNumber("ARM1-T3-0012-0001"));
  EXPECT_EQ(sherd.bag, bag4);
  EXPECT_EQ(sherds::textOf(sherd, "part"), "rim; neck");
  EXPECT_EQ(sherd.measures.at("weight"), 23.4);
  EXPECT_EQ(sherd.note, "=1+1") << "the guard against formulas is taken off";
  EXPECT_EQ(History(catalogue()).of(sherd.row)->front().source, "test");
}

TEST_F(Import, BlankKeepsAndClearDeletes) {
  import(kTwo);
  const ImportReport report =
      import("number,part,note,weight_g\nARM1-T3-0012-0001,,<clear>,<clear>\n");
  EXPECT_EQ(report.changed, 1);
  const records::SherdRecord sherd =
      *sherds::Sherds(catalogue()).get(*sherds::Sherds(catalogue()).byNumber("ARM1-T3-0012-0001"));
  EXPECT_EQ(sherds::textOf(sherd, "part"), "rim; neck");
  EXPECT_EQ(sherd.note, "");
  EXPECT_TRUE(sherd.measures.empty());
}

TEST_F(Import, UnknownPlacesAreMadeWhenAskedFor) {
  const std::string table = "number,site,trench,context,bag\nNEW-1,TB,A,1,7\nNEW-2,TB,A,1,7\n";
  EXPECT_EQ(import(table).refused, 2);
  const ImportReport report = import(table, ImportMode::Enter, UnknownPlaces::Make);
  EXPECT_EQ(report.fresh, 2);
  const records::SherdRecord sherd =
      *sherds::Sherds(catalogue()).get(*sherds::Sherds(catalogue()).byNumber("NEW-2"));
  EXPECT_EQ(sherd.site + sherd.trench + sherd.context_number + sherd.bag_number, "TBA17");
  EXPECT_EQ(catalogue::Places(catalogue()).sites()->size(), 2u);
}

TEST_F(Import, PlacesAsPeopleWriteThem) {
  context("K15");
  const std::string table =
      "number,context,bag\nX-1,0012,4\nX-2,ARM1-T3-0012-5,\nX-3,K 15,\nX-4,ARM1-K15,\n"
      "X-5,K 16,\n";
  const ImportReport report = import(table);
  EXPECT_EQ(report.fresh, 4);
  ASSERT_EQ(report.refusals.size(), 1u);
  EXPECT_EQ(report.refusals[0].reason.english(),
            "There is no context K 16 in ARM1 T3; add it first.");
  EXPECT_EQ(import(table, ImportMode::Enter, UnknownPlaces::Make).fresh, 1);
  const auto placeOf = [&](const char* number) {
    const auto sherd =
        *sherds::Sherds(catalogue()).get(*sherds::Sherds(catalogue()).byNumber(number));
    return sherd.site + "|" + sherd.trench + "|" + sherd.context_number + "|" + sherd.bag_number;
  };
  EXPECT_EQ(placeOf("X-1"), "ARM1|T3|0012|4");
  EXPECT_EQ(placeOf("X-2"), "ARM1|T3|0012|5");
  EXPECT_EQ(placeOf("X-3"), "ARM1|T3|K15|");
  EXPECT_EQ(placeOf("X-4"), "ARM1|T3|K15|");
  EXPECT_EQ(placeOf("X-5"), "ARM1|T3|K 16|");
}

TEST_F(Import, TakesMeasuresOfTheProgramRoundedInATableForTheSame) {
  import(kTwo);
  const std::vector<store::SherdRow> rows = *sherds::Sherds(catalogue()).rows(sherds::Filter(), {});
  for (const auto& [kind, value] :
       {std::pair("length", 32.833193793898516), std::pair("area", 15201.000499)}) {
    records::Measurement m;  // the program's
    m.sherd = rows[0];
    m.kind = kind;
    m.value = value;
    ASSERT_TRUE(sherds::Measurements(catalogue()).add(m, {}));
  }
  ASSERT_TRUE(set(rows[0], "width_mm", "21.0625"));
  const Result<std::string> text =
      exchange::sherdsCsv(catalogue(), rows, exchange::ByteOrderMark::With);
  ASSERT_TRUE(text) << text.error().sentence();
  EXPECT_THAT(*text, testing::HasSubstr(",32.833,21.063,"));
  EXPECT_THAT(*text, testing::HasSubstr(",15201,"));
  EXPECT_THAT(*text, testing::HasSubstr(",measured_by_hand,"));
  EXPECT_THAT(*text, testing::HasSubstr(",\"weight_g; width_mm\","));
  std::string with_commas = *text;  // as a French spreadsheet saves it
  with_commas.replace(with_commas.find(",32.833,"), 8, ",\"32,833\",");
  for (const std::string& table : {*text, with_commas}) {
    const ImportReport report = import(table);
    EXPECT_EQ(report.same, 2);
    EXPECT_EQ(report.changed, 0);
    EXPECT_TRUE(report.warnings.empty());
  }
  EXPECT_DOUBLE_EQ(sherds::Sherds(catalogue()).get(rows[0])->measures.at("length"),
                   32.833193793898516);
  const auto by_hand = sherds::Measurements(catalogue()).byHand(rows);
  ASSERT_TRUE(by_hand);
  EXPECT_THAT(*by_hand,
              testing::UnorderedElementsAre(testing::Field(&records::Measurement::kind, "weight"),
                                            testing::Field(&records::Measurement::kind, "width")));
  std::string other = *text;  // by a person, who measured it again
  other.replace(other.find(",32.833,"), 8, ",32.834,");
  EXPECT_EQ(import(other).asked, 1) << "the computed value does not give way unasked";
  ImportOptions confirmed;
  confirmed.mode = ImportMode::Enter;
  confirmed.asked_rows = AskedRows::Enter;
  EXPECT_EQ(importTable(catalogue(), other, "t.csv", confirmed, anna, quiet, {})->changed, 1);
  EXPECT_EQ(sherds::Measurements(catalogue()).byHand(rows)->size(), 3u);
}

TEST_F(Import, OfATableOfBeforeAComputationLeavesTheProgramsMeasures) {
  import(kTwo);
  const std::vector<store::SherdRow> rows = *sherds::Sherds(catalogue()).rows(sherds::Filter(), {});
  records::Measurement m;
  m.sherd = rows[0];
  m.kind = "length";
  m.value = 60.1;
  m.model_sha256 = "first";
  ASSERT_TRUE(sherds::Measurements(catalogue()).add(m, {}));
  const Result<std::string> before =
      exchange::sherdsCsv(catalogue(), rows, exchange::ByteOrderMark::With);
  ASSERT_TRUE(before);
  m.value = 60.4;
  m.model_sha256 = "second";
  ASSERT_TRUE(sherds::Measurements(catalogue()).add(m, {}));
  EXPECT_EQ(import(*before).same, 2);
  EXPECT_DOUBLE_EQ(sherds::Sherds(catalogue()).get(rows[0])->measures.at("length"), 60.4);
  EXPECT_EQ(sherds::Measurements(catalogue()).byHand(rows)->size(), 1u) << "its weight alone";
}

TEST_F(Import, OfANewSherdKeepsWhatAProgramMeasuredForThePrograms) {
  const std::string table =
      "number,site,trench,context,length_mm,width_mm,rim_pct,measured_by_hand\n"
      "X-1,ARM1,T3,0012,52.125,30,12,width_mm\nX-2,ARM1,T3,0012,1001,30,12,\n";
  const ImportReport report = import(table);
  EXPECT_EQ(report.fresh, 1);
  ASSERT_EQ(report.refusals.size(), 1u);
  EXPECT_THAT(report.refusals[0].reason, testing::HasSubstr("1000 mm")) << "as strict as ever";
  const store::SherdRow row = *sherds::Sherds(catalogue()).byNumber("X-1");
  std::map<std::string, std::string> methods;
  for (const records::Measurement& m : valueIn(sherds::Measurements(catalogue()).of(row)))
    methods[m.kind] = m.method;
  EXPECT_THAT(methods, testing::ElementsAre(testing::Pair("length", "program"),
                                            testing::Pair("rim_pct", "program"),
                                            testing::Pair("width", "imported")));
  EXPECT_EQ(import(table).same, 1);
  import("number,site,trench,context,length_mm\nX-3,ARM1,T3,0012,52\n");
  EXPECT_EQ(sherds::Measurements(catalogue())
                .of(*sherds::Sherds(catalogue()).byNumber("X-3"))
                ->front()
                .method,
            "imported")
      << "nobody here knows whether it was a calliper";
  EXPECT_EQ(History(catalogue()).of(*sherds::Sherds(catalogue()).byNumber("X-3"))->front().why,
            "t.csv");
}

// Each laptop begins with B0001.
TEST_F(Import, OfASherdDoesNotTakeABatchByItsNumber) {
  ASSERT_EQ(Batches(catalogue()).get(newBatch({bag4}))->number, "B0001");
  ASSERT_EQ(import("number,site,trench,context,batch\nX-1,ARM1,T3,0012,B0001\n").fresh, 1);
  EXPECT_FALSE(
      sherds::Sherds(catalogue()).get(*sherds::Sherds(catalogue()).byNumber("X-1"))->batch);
}

}  // namespace
}  // namespace ostraka::tables
