#include "tables/import_table.h"

#include <gmock/gmock.h>

#include <atomic>
#include <functional>
#include <map>
#include <thread>
#include <utility>

#include "catalogue/batches.h"
#include "catalogue/history.h"
#include "catalogue/places.h"
#include "catalogue/settings.h"
#include "exchange/export_folder.h"
#include "records/records.h"
#include "records/sherd.h"
#include "sherds/measurements.h"
#include "sherds/sherd_fields.h"
#include "sherds/sherds.h"
#include "tables/column_names.h"
#include "tables/csv.h"
#include "tests/core/catalogue/small_project.h"
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

TEST_F(Import, TwiceGivesOnce) {
  import(kTwo);
  const std::int64_t history = History(catalogue()).length();
  const ImportReport again = import(kTwo);
  EXPECT_EQ(again.fresh, 0);
  EXPECT_EQ(again.same, 2);
  EXPECT_EQ(again.changed, 0);
  EXPECT_EQ(History(catalogue()).length(), history);
}

TEST_F(Import, APreviewCountsTheSameAndChangesNothing) {
  const std::int64_t history = History(catalogue()).length();
  const ImportReport preview = import(kTwo, ImportMode::Preview);
  EXPECT_EQ(preview.fresh, 2);
  EXPECT_EQ(History(catalogue()).length(), history);
  EXPECT_FALSE(*sherds::Sherds(catalogue()).byNumber("ARM1-T3-0012-0001"));
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

TEST_F(Import, UnknownColumnsBecomeFieldsOfOnesOwnWithAWarning) {
  const ImportReport report = import("number,site,trench,context,drawer\nX-1,ARM1,T3,0012,7\n");
  ASSERT_EQ(report.warnings.size(), 1u);
  EXPECT_NE(report.warnings[0].english().find("'drawer'"), std::string::npos);
  EXPECT_EQ(
      sherds::textOf(*sherds::Sherds(catalogue()).get(*sherds::Sherds(catalogue()).byNumber("X-1")),
                     "extra.drawer"),
      "7");
}

TEST_F(Import, OfContextsMakesAndChangesThem) {
  const std::string table =
      "site;trench;context;kind;excavated_on;closed;bag;weight_g\n"
      "ARM1;T3;0012;layer;2026-07-14;yes;;\n"
      "ARM1;T4;0001;cut;;no;1;12,5\n"
      "ARM1;T3;0013;hole;;;;\n"
      "ARM1;T3;0013;;14.7.2026;;;\n";
  const ImportReport report = import(table);
  EXPECT_EQ(report.fresh, 1);
  EXPECT_EQ(report.changed, 1);
  EXPECT_EQ(report.refused, 2);
  EXPECT_EQ(report.refusals[0].line, 4);
  EXPECT_NE(report.refusals[1].reason.english().find("2026-07-14"), std::string::npos);
  const records::ContextRecord c = *catalogue::Places(catalogue()).context(context12);
  EXPECT_EQ(c.kind, "layer");
  EXPECT_EQ(c.closed, true);
  EXPECT_EQ(catalogue::Places(catalogue())
                .bags(*catalogue::Places(catalogue()).contextByPlace("ARM1", "T4", "0001"))
                ->front()
                .weight_g,
            12.5);
  const ImportReport again = import(table);
  EXPECT_EQ(again.same, 2);
  EXPECT_EQ(again.fresh + again.changed, 0);
}

TEST_F(Import, OfContextsNamesTheSitesThatItMakesAndTheKindsThatThereAre) {
  const ImportReport report =
      import("site,trench,context,kind\nNOPE,T1,0010,layer\nNOPE,T1,0011,pit\nNIX,T1,0012,hole\n");
  EXPECT_EQ(report.fresh, 1);
  ASSERT_EQ(report.refusals.size(), 2u);
  EXPECT_EQ(
      report.refusals[0].reason,
      "'pit' is not a kind of context; use layer, cut, fill, structure, surface or unstratified.");
  ASSERT_EQ(report.warnings.size(), 1u);
  EXPECT_EQ(report.warnings[0], "New sites and trenches: NOPE, NOPE T1; check for typos.");
}

TEST_F(Import, OfContextsKeepsColumnsThatItDoesNotKnow) {
  const ImportReport report =
      import("site;trench;context;description;Öffner\nARM1;T3;0012;dark fill;LT\n");
  EXPECT_EQ(report.warnings.size(), 2u);
  const auto own = [&](store::ContextRow row) {
    return catalogue::Places(catalogue()).context(row)->extra_json;
  };
  EXPECT_EQ(own(context12), "{\"description\":\"dark fill\",\"Öffner\":\"LT\"}");
  EXPECT_EQ(import("site;trench;context;description\nARM1;T3;0012;\n").same, 1);
  EXPECT_EQ(import("site;trench;context;description\nARM1;T3;0012;<clear>\n").changed, 1);
  EXPECT_EQ(own(context12), "{\"Öffner\":\"LT\"}");
}

TEST_F(Import, ATableOfSomethingElseIsRefusedWhole) {
  const ImportReport nothing = import("a,b\n1,2\n");
  EXPECT_TRUE(nothing.rows.empty());
  EXPECT_THAT(nothing.mapping.missing.english(), testing::HasSubstr("needs a column for the"));
  EXPECT_TRUE(nothing.mapping.kind.empty());
  for (const char* text : {"number,number\n1,2\n", "number,,x\n1,2,3\n", ""})
    EXPECT_FALSE(importTable(catalogue(), text, "t.csv", {}, anna, quiet, {})) << text;
}

TEST_F(Import, TakesBackItsOwnExportUnchangedInAnyLocale) {
  import(kTwo);
  ASSERT_TRUE(set(*sherds::Sherds(catalogue()).byNumber("ARM1-T3-0013-0001"), "joins",
                  "ARM1-T3-0012-0001"));
  const std::vector<store::SherdRow> rows = *sherds::Sherds(catalogue()).rows(sherds::Filter{}, {});
  for (const char* locale : {"C", "de_DE.UTF-8", "pl_PL.UTF-8", "pt_BR.UTF-8"}) {
    std::setlocale(LC_ALL, locale);
    const Result<std::string> text =
        exchange::sherdsCsv(catalogue(), rows, exchange::ByteOrderMark::With);
    ASSERT_TRUE(text);
    EXPECT_NE(text->find("23.4"), std::string::npos);
    const ImportReport report = import(*text);
    EXPECT_EQ(report.same, 2);
    EXPECT_TRUE(report.warnings.empty());
  }
  std::setlocale(LC_ALL, "C");
}

// As a spreadsheet in a German window has them.
TEST_F(Import, ReadsAnExportsHeadingsInThePersonsWords) {
  import(kTwo);
  const std::vector<store::SherdRow> rows = *sherds::Sherds(catalogue()).rows(sherds::Filter{}, {});
  const std::string text =
      *exchange::sherdsCsv(catalogue(), rows, exchange::ByteOrderMark::Without);
  const std::map<std::string, std::string> german = {{"number", "Nummer"},
                                                     {"uuid", "Kennung"},
                                                     {"state", "Zustand"},
                                                     {"context", "Befund"},
                                                     {"length_mm", "Länge, mm"},
                                                     {"area_mm2", "Fläche, mm²"},
                                                     {"weight_g", "Gewicht, g"},
                                                     {"batch", "Durchgang"},
                                                     {"licence", "Lizenz"},
                                                     {"model_file", "Modelldatei"},
                                                     {"measured_by_hand", "von Hand gemessen"},
                                                     {"mass_centre_x_mm", "Schwerpunkt x, mm"}};
  CsvTable table = *parseCsv(text, "sherds.csv");
  for (std::string& column : table.columns)
    if (const auto words = german.find(column); words != german.end())
      column = headingOf(column, words->second, false);
  const std::string headed = csvLine(table.columns) + text.substr(text.find("\r\n") + 2);
  EXPECT_THAT(headed, testing::HasSubstr("\"Fläche, mm²\""));
  const ImportReport report = import(headed);
  EXPECT_EQ(report.same, 2);
  EXPECT_TRUE(report.warnings.empty());
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

TEST_F(Import, CanBeStoppedAndThenEntersNothing) {
  std::stop_source stop;
  stop.request_stop();
  const Result<ImportReport> report =
      importTable(catalogue(), kTwo, "t.csv", {ImportMode::Enter, UnknownPlaces::Refuse}, anna,
                  quiet, stop.get_token());
  ASSERT_FALSE(report);
  EXPECT_EQ(report.error().code, ErrorCode::Cancelled);
  EXPECT_FALSE(*sherds::Sherds(catalogue()).byNumber("ARM1-T3-0012-0001"));
}

std::string manyRows(int count) {
  std::string text = "number,site,trench,context,ware\r\n";
  for (int i = 1; i <= count; ++i)
    text += "ARM1-T3-0012-" + std::to_string(10'000 + i) + ",ARM1,T3,0012,grey\r\n";
  return text;
}

// Calls for something as soon as so many rows were read.
class At final : public Progress {
 public:
  At(std::int64_t row, std::function<void()> provenance)
      : row_(row), provenance_(std::move(provenance)) {}
  void report(std::int64_t done, std::int64_t) override {
    if (done >= row_ && provenance_) std::exchange(provenance_, nullptr)();
  }
  void note(NoteLevel, const Message&) override {}

 private:
  std::int64_t row_;
  std::function<void()> provenance_;
};

TEST_F(Import, ThatIsStoppedKeepsWholeRowsSaysSoAndGoesOn) {
  std::stop_source stop;
  At progress(64, [&] { stop.request_stop(); });
  const Result<ImportReport> part =
      importTable(catalogue(), manyRows(200), "bags.csv",
                  {ImportMode::Enter, UnknownPlaces::Refuse}, anna, progress, stop.get_token());
  ASSERT_TRUE(part) << part.error().sentence();
  EXPECT_GE(part->fresh, 64);
  EXPECT_EQ(part->not_reached, 200 - part->fresh);
  EXPECT_EQ(sherds::Sherds(catalogue()).rows({}, {})->size(),
            static_cast<std::size_t>(part->fresh));
  const auto left = unfinishedImports(catalogue());
  ASSERT_EQ(left.size(), 1u);
  EXPECT_EQ(left[0].source, "bags.csv");
  EXPECT_EQ(left[0].entered, part->fresh);
  EXPECT_EQ(left[0].of, 200);

  import(kTwo);
  EXPECT_EQ(unfinishedImports(catalogue()).size(), 1u) << "of another table nothing is known";
  const ImportReport rest =
      import(manyRows(200), ImportMode::Enter, UnknownPlaces::Refuse, "bags.csv");
  EXPECT_EQ(rest.same, part->fresh);
  EXPECT_EQ(rest.fresh, part->not_reached);
  EXPECT_TRUE(unfinishedImports(catalogue()).empty());
  EXPECT_TRUE(catalogue().checkIntegrity());
}

TEST_F(Import, OfTwoTablesThatBrokeOffKeepsBothInMind) {
  for (const char* file : {"a.csv", "b.csv"}) {
    std::stop_source stop;
    At progress(64, [&] { stop.request_stop(); });
    ASSERT_TRUE(importTable(catalogue(), manyRows(200), file,
                            {ImportMode::Enter, UnknownPlaces::Refuse}, anna, progress,
                            stop.get_token()));
  }
  ASSERT_EQ(unfinishedImports(catalogue()).size(), 2u);
  import(manyRows(200), ImportMode::Enter, UnknownPlaces::Refuse, "b.csv");
  ASSERT_EQ(unfinishedImports(catalogue()).size(), 1u);
  EXPECT_EQ(unfinishedImports(catalogue())[0].source, "a.csv");
  ASSERT_TRUE(forgetUnfinishedImports(catalogue()));
  EXPECT_TRUE(unfinishedImports(catalogue()).empty());
}

std::string manyContexts(int count) {
  std::string text = "site,trench,context,bag\r\n";
  for (int i = 1; i <= count; ++i) text += "ARM1,T9," + std::to_string(i) + ",1\r\n";
  return text;
}

TEST_F(Import, OfContextsThatIsStoppedKeepsWholeRowsSaysSoAndGoesOn) {
  std::stop_source stop;
  At progress(64, [&] { stop.request_stop(); });
  const Result<ImportReport> part =
      importTable(catalogue(), manyContexts(200), "contexts.csv",
                  {ImportMode::Enter, UnknownPlaces::Refuse}, anna, progress, stop.get_token());
  ASSERT_TRUE(part) << part.error().sentence();
  EXPECT_GE(part->fresh, 64);
  EXPECT_EQ(part->not_reached, 200 - part->fresh);
  ASSERT_EQ(unfinishedImports(catalogue()).size(), 1u);
  EXPECT_EQ(unfinishedImports(catalogue())[0].entered, part->fresh);

  const ImportReport rest =
      import(manyContexts(200), ImportMode::Enter, UnknownPlaces::Refuse, "contexts.csv");
  EXPECT_EQ(rest.same, part->fresh);
  EXPECT_EQ(rest.fresh, part->not_reached);
  EXPECT_TRUE(unfinishedImports(catalogue()).empty());
}

// Somebody else's decision is written while the table is entered, not after it.
bool othersWriteDuring(const std::filesystem::path& project,
                       const std::function<void(Progress&)>& work) {
  std::atomic<bool> over = false, began = false, meanwhile = false;
  std::thread other([&] {
    while (!began) std::this_thread::yield();
    Result<Catalogue> second = upkeep::Project::connect(project);
    const bool written = second && Settings(*second).setValue("a.window", "decides");
    meanwhile = written && !over;
  });
  At progress(64, [&] { began = true; });
  work(progress);
  over = true;
  began = true;
  other.join();
  return meanwhile;
}

TEST_F(Import, LetsOthersWriteMeanwhile) {
  for (const std::string& table : {manyRows(2000), manyContexts(1000)})
    EXPECT_TRUE(othersWriteDuring(project_->folder(), [&](Progress& progress) {
      const auto report =
          importTable(catalogue(), table, "t.csv", {ImportMode::Enter, UnknownPlaces::Refuse}, anna,
                      progress, {});
      ASSERT_TRUE(report);
      EXPECT_GE(report->fresh, 1000);
    }));
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

TEST_F(Import, ContextsNeedNoColumnOfTheOnlySite) {
  const ImportReport report = import("context,kind\n00 12,layer\nK 16,cut\n");
  EXPECT_EQ(report.changed, 1);
  EXPECT_EQ(report.fresh, 1);
  EXPECT_TRUE(*catalogue::Places(catalogue()).contextByPlace("ARM1", "T3", "K16"));
  records::SiteRecord other;
  other.code = "KT26";
  ASSERT_TRUE(catalogue::Places(catalogue()).save(other, anna));
  EXPECT_NE(why("context,kind\nK 17,cut\n").find("2 context K 17: This project has 2 sites"),
            std::string::npos);
}

}  // namespace
}  // namespace ostraka::tables
