// The tables of an export.
#include <gmock/gmock.h>

#include "catalogue/places.h"
#include "exchange/export_folder.h"
#include "exported_project.h"
#include "records/records.h"
#include "tables/csv.h"

namespace ostraka::exchange {
namespace {

namespace fs = std::filesystem;

using ExportedTables = ExportedProject;

TEST_F(ExportedTables, TablesSayWhereTheMassLiesOfModelsThatGoAlong) {
  ASSERT_TRUE(exportTo("with", {Form::Csv, Form::Ply}));
  ASSERT_TRUE(exportTo("without", {Form::Csv}));
  for (const auto& [folder, centre] : {std::pair("with", "2"), std::pair("without", "")}) {
    const auto table =
        tables::parseCsv(*readFile(folder_.path() / folder / "data/sherds.csv"), "sherds.csv");
    ASSERT_TRUE(table);
    for (const char* column : {"mass_centre_x_mm", "mass_centre_y_mm", "mass_centre_z_mm"}) {
      const auto at = std::find(table->columns.begin(), table->columns.end(), column);
      ASSERT_NE(at, table->columns.end());
      // Of a tetrahedron the mean of its corners.
      EXPECT_EQ(table->rows[1].values[static_cast<std::size_t>(at - table->columns.begin())],
                centre);
    }
  }
}

TEST_F(ExportedTables, OfASpreadsheetHaveTheReadersHeadingsAndThoseOfTheCsvTheSame) {
  ExportOptions options;
  options.target = folder_.path() / "out";
  options.forms = {Form::Csv, Form::Ods};
  options.words = [](const std::string& column) {
    return column == "length_mm" ? "Länge, mm" : column == "bag" ? "Beutel" : "<" + column + ">";
  };
  ASSERT_TRUE(exportFolder(catalogue(), project_->folder(), rows, options, quiet, {}));
  const std::string ods = *readFile(options.target / "data/sherds.ods");
  for (const char* heading : {"Länge, mm", "Beutel", "width_mm", "extra.drawer"})
    EXPECT_THAT(ods, testing::HasSubstr(std::string("office:value-type=\"string\"><text:p>") +
                                        heading + "</text:p>"));
  EXPECT_THAT(*readFile(options.target / "data/sherds.csv"), testing::HasSubstr(",length_mm,"));
  EXPECT_THAT(*readFile(options.target / "data/README.txt"),
              testing::HasSubstr("headings\nare in the language of whoever exported it"));
}

TEST_F(ExportedTables, AWholeProjectTellsOfAllContextsWithAllTheirFields) {
  records::ContextRecord c = *catalogue::Places(catalogue()).context(context13);
  c.excavated_on = "2025-07-31";
  c.closed = false;
  c.extra_json = R"({"description":"dark fill"})";
  ASSERT_TRUE(catalogue::Places(catalogue()).save(c, anna));
  ASSERT_TRUE(exportTo("all", {Form::Csv}));
  const auto table =
      tables::parseCsv(*readFile(folder_.path() / "all/data/contexts.csv"), "contexts.csv");
  ASSERT_TRUE(table);
  const auto value = [&](const tables::CsvRow& row, const char* column) {
    const auto at = std::find(table->columns.begin(), table->columns.end(), column);
    return at == table->columns.end()
               ? std::string("?")
               : row.values[static_cast<std::size_t>(at - table->columns.begin())];
  };
  ASSERT_EQ(table->rows.size(), 3u) << "a row for each bag: 4 and 5 of 0012, 1 of 0013";
  const tables::CsvRow &first = table->rows.front(), &last = table->rows.back();
  EXPECT_EQ(value(first, "closed"), "") << "nobody said";
  EXPECT_EQ(value(first, "extra.description"), "");
  EXPECT_EQ(value(last, "context"), "0013");
  EXPECT_EQ(value(last, "excavated_on"), "2025-07-31");
  EXPECT_EQ(value(last, "closed"), "no");
  EXPECT_EQ(value(last, "extra.description"), "dark fill");
  rows.pop_back();
  ASSERT_TRUE(exportTo("some", {Form::Csv}));
  EXPECT_EQ(tables::parseCsv(*readFile(folder_.path() / "some/data/contexts.csv"), "contexts.csv")
                ->rows.size(),
            2u)
      << "a part tells only where its sherds are from";
}

TEST_F(ExportedTables, EachColumnOfItsTablesIsExplained) {
  ASSERT_TRUE(exportTo("out", {Form::Csv}));
  const fs::path data = folder_.path() / "out/data";
  const auto meanings = tables::parseCsv(*readFile(data / "columns.csv"), "columns.csv");
  ASSERT_TRUE(meanings);
  std::set<std::string> explained;
  for (const tables::CsvRow& row : meanings->rows) {
    EXPECT_TRUE(explained.insert(row.values[0]).second) << row.values[0];
    EXPECT_FALSE(row.values[2].empty()) << row.values[0];
  }
  for (const char* file : {"sherds.csv", "contexts.csv"}) {
    const auto table = tables::parseCsv(*readFile(data / file), file);
    ASSERT_TRUE(table);
    for (const std::string& column : table->columns)
      EXPECT_TRUE(explained.contains(column) || column.starts_with("extra.")) << column;
  }
}

TEST_F(ExportedTables, TheSpreadsheetHoldsNumbersAsNumbersAndTextsAsTexts) {
  ASSERT_TRUE(exportTo("out", {Form::Ods}));
  const std::string ods = *readFile(folder_.path() / "out/data/sherds.ods");
  const auto holds = [&](const std::string& part) { return ods.find(part) != std::string::npos; };
  for (const char* sheet : {"sherds", "contexts", "columns"})
    EXPECT_TRUE(holds("table:name=\"" + std::string(sheet) + "\"")) << sheet;
  EXPECT_TRUE(holds(R"(office:value-type="float" office:value="23.4")"));
  EXPECT_TRUE(
      holds("office:value-type=\"string\"><text:p>=SUM(A1), &quot;quoted&quot;; "
            "Գառնի</text:p><text:p>second line</text:p>"));
  EXPECT_TRUE(holds("office:value-type=\"string\"><text:p>0012</text:p>"))
      << "zeros in front of a context's number stay";
}

}  // namespace
}  // namespace ostraka::exchange
