#include "tables/refused_rows.h"

#include <gmock/gmock.h>

#include "base/message.h"
#include "tests/core/tables/import_fixture.h"

namespace ostraka::tables {
namespace {

TEST_F(Import, RefusedRowsAreWrittenAsTheTableHasThemAndImportedAgain) {
  const ImportReport report = import(
      "Nummer;Fundort;Schnitt;Befund;Teil;Bemerkung\n"
      "K-1;ARM1;T3;0012;Wand;\"a;b\"\n"
      "K-2;ARM1;T3;0012;rim;\n"
      "K-3;ARM1;T3\n"
      "K-4;ARM1;T3;0012;rim;;7\n");
  EXPECT_EQ(report.refused, 3);
  const std::string text = refusedRowsCsv(
      report, [](const Message& words) { return "<" + words.templateWords() + ">"; });
  const std::string broken =
      "\"<Values in the row: %1, columns in the header: %2; correct the row.>\"";
  EXPECT_EQ(text, std::string(kUtf8Mark) +
                      "Ostraka: <why this row was not imported>;Nummer;Fundort;Schnitt;Befund;"
                      "Teil;Bemerkung\r\n"
                      "<%1: %2>;K-1;ARM1;T3;0012;Wand;\"a;b\"\r\n" +
                      broken + ";K-3;ARM1;T3\r\n" + broken + ";K-4;ARM1;T3;0012;rim;;7\r\n");
  std::string corrected = text;
  corrected.replace(corrected.find("Wand"), 4, "rim");
  const ImportReport again = import(corrected);
  EXPECT_EQ(again.fresh, 1);
  EXPECT_EQ(again.mapping.columns.size(), 6u) << "the reasons are no column";
  EXPECT_EQ(again.refused, 2) << "what was not corrected is refused again";
  EXPECT_EQ(again.left_out.columns.size(), 6u);
  ASSERT_EQ(again.left_out.rows.size(), 2u);
  EXPECT_EQ(again.left_out.rows[0].values.size(), 3u);
}

TEST(RefusedRows, OfAnExportFolderAreHeadedInTheReadersLanguage) {
  ImportReport report;  // a folder has no table
  report.refusals.push_back({3, "part", "wing", message("Not a term.")});
  const std::string text = refusedRowsCsv(
      report, [](const Message& words) { return "<" + words.templateWords() + ">"; });
  EXPECT_TRUE(
      text.starts_with(std::string(kUtf8Mark) +
                       "Ostraka: <why this row was not imported>,<line>,<field>,<value>\r\n"))
      << text;
  EXPECT_NE(text.find(",3,part,wing\r\n"), std::string::npos) << text;
}

// Whoever made the table: the file is opened in a spreadsheet.
TEST_F(Import, RefusedRowsHoldNoFormulasAndAreReadAsTheTable) {
  const std::string formula = "=1+1";
  const ImportReport report = import("number,site,trench,context,part," + formula +
                                     ",@sum\nK-1,ARM1,T3,0012,wing," + formula + ",'-1\n");
  ASSERT_EQ(report.refused, 1);
  const std::string text =
      refusedRowsCsv(report, [](const Message& reason) { return reason.english(); });
  EXPECT_NE(text.find(",'" + formula + ",'@sum\r\n"), std::string::npos) << text;
  EXPECT_NE(text.find(",wing,'" + formula + ",'-1\r\n"), std::string::npos) << text;
  EXPECT_EQ(import(text).left_out.columns, report.left_out.columns);
}

}  // namespace
}  // namespace ostraka::tables
