#include "tables/import_table.h"

#include <gmock/gmock.h>

#include <map>
#include <string>

#include "catalogue/history.h"
#include "exchange/export_folder.h"
#include "sherds/sherd_fields.h"
#include "sherds/sherds.h"
#include "tables/column_names.h"
#include "tables/csv.h"
#include "tests/core/tables/import_fixture.h"

namespace ostraka::tables {
namespace {

using namespace catalogue;

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

TEST_F(Import, UnknownColumnsBecomeFieldsOfOnesOwnWithAWarning) {
  const ImportReport report = import("number,site,trench,context,drawer\nX-1,ARM1,T3,0012,7\n");
  ASSERT_EQ(report.warnings.size(), 1u);
  EXPECT_NE(report.warnings[0].english().find("'drawer'"), std::string::npos);
  EXPECT_EQ(
      sherds::textOf(*sherds::Sherds(catalogue()).get(*sherds::Sherds(catalogue()).byNumber("X-1")),
                     "extra.drawer"),
      "7");
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

}  // namespace
}  // namespace ostraka::tables
