#include "tables/csv.h"

#include <gmock/gmock.h>

#include <chrono>
#include <random>

#include "base/limits.h"

namespace ostraka::tables {
namespace {

using testing::ElementsAre;

std::vector<std::vector<std::string>> rowsOf(const std::string& text) {
  const Result<CsvTable> table = parseCsv(text, "t.csv");
  EXPECT_TRUE(table) << (table ? "" : table.error().sentence());
  std::vector<std::vector<std::string>> rows;
  if (table)
    for (const CsvRow& row : table->rows) rows.push_back(row.values);
  return rows;
}

TEST(Csv, QuotesLineEndsAndSeparatorsInsideValuesAreText) {
  EXPECT_THAT(rowsOf("a,b\r\n\"x,\"\"y\"\"\",\"two\nlines\"\r\n1,2\r\n"),
              ElementsAre(ElementsAre("x,\"y\"", "two\nlines"), ElementsAre("1", "2")));
}

TEST(Csv, AVerticalTabIsALineEndInsideAValue) {
  EXPECT_THAT(rowsOf("a,b\n\"two\vlines\",x\vy\n"), ElementsAre(ElementsAre("two\nlines", "x\ny")));
}

TEST(Csv, TheSeparatorIsTakenFromTheHeader) {
  EXPECT_EQ(parseCsv("a;b,c\n", "t")->separator, ',') << "the first of equals";
  EXPECT_EQ(parseCsv("a;b;c,d\n", "t")->separator, ';');
  EXPECT_EQ(parseCsv("a\tb\n", "t")->separator, '\t');
  EXPECT_THAT(rowsOf("a;b\n1,5;2\n"), ElementsAre(ElementsAre("1,5", "2")));
}

TEST(Csv, EveryKindOfLineEndWillDoAndTheLastMayLackIt) {
  EXPECT_EQ(rowsOf("a,b\n1,2\n3,4").size(), 2u);
  EXPECT_EQ(rowsOf("a,b\r1,2\r3,4\r").size(), 2u);
  EXPECT_EQ(rowsOf("a,b\r\n\r\n1,2\r\n\r\n").size(), 1u) << "empty lines are left out";
}

TEST(Csv, LinesAreCountedAsAnEditorCountsThem) {
  const Result<CsvTable> table = parseCsv("a,b\n\"x\ny\",1\n\n2,3\n", "t.csv");
  ASSERT_TRUE(table);
  EXPECT_EQ(table->rows[0].line, 2);
  EXPECT_EQ(table->rows[1].line, 5);
}

TEST(Csv, Utf8WithOrWithoutMarkAndUtf16AreRead) {
  EXPECT_THAT(rowsOf("\xEF\xBB\xBF"
                     "a\né\n"),
              ElementsAre(ElementsAre("é")));
  EXPECT_THAT(rowsOf("\xEF\xBB\xBF\xEF\xBB\xBF"
                     "a\né\n"),
              ElementsAre(ElementsAre("é")))
      << "a second mark is no part of the first column's name";
  EXPECT_THAT(rowsOf(std::string("\xFF\xFE"
                                 "a\0\n\0\xE9\0\n\0",
                                 10)),
              ElementsAre(ElementsAre("é")));
  EXPECT_THAT(rowsOf(std::string("\xFE\xFF\0a\0\n\xD8\x3C\xDF\xFA\0\n", 12)),
              ElementsAre(ElementsAre("\xF0\x9F\x8F\xBA")))
      << "an amphora, big-endian";
}

TEST(Csv, WhatIsNoTableIsRefusedWithItsLine) {
  const auto why = [](const std::string& text) {
    const Result<CsvTable> table = parseCsv(text, "t.csv");
    return table ? std::string("accepted") : table.error().sentence().english();
  };
  EXPECT_NE(why("").find("empty"), std::string::npos);
  EXPECT_NE(why("a,b\n1,2\n\"open,3\n").find("Line 3 has an unclosed quotation mark"),
            std::string::npos);
  EXPECT_NE(why("a\n\"x\"y\n").find("Line 2 has characters after"), std::string::npos);
  EXPECT_NE(why("a\nok\nSch\xF6n\n").find("Line 3 is not in UTF-8"), std::string::npos);
  EXPECT_NE(why(std::string("a\nb\0c\n", 6)).find("binary data"), std::string::npos);
  for (const char* sheet : {"PK\x03\x04\x14", "\xD0\xCF\x11\xE0"})
    EXPECT_NE(why(sheet).find("save the sheet as 'CSV UTF-8'"), std::string::npos);
  EXPECT_EQ(why("PK,b\n1,2\n"), "accepted");
  EXPECT_NE(why("a\n" + std::string((1 << 20) + 1, 'x')).find("Line 2 has a value longer"),
            std::string::npos);
}

TEST(Csv, ALineOfExcelBeforeTheHeaderNamesTheSeparator) {
  for (const char* line : {"sep=;\r\n", "SEP=;\n", "\"sep=;\"\r", "\xEF\xBB\xBFsep=;\n"}) {
    const Result<CsvTable> table = parseCsv(std::string(line) + "a,b;c\n1;2\n", "t.csv");
    ASSERT_TRUE(table) << line;
    EXPECT_EQ(table->separator, ';');
    EXPECT_THAT(table->columns, ElementsAre("a,b", "c")) << line;
    ASSERT_EQ(table->rows.size(), 1u);
    EXPECT_EQ(table->rows[0].line, 3);
    EXPECT_THAT(table->rows[0].values, ElementsAre("1", "2"));
  }
  EXPECT_THAT(parseCsv("sep=\t\na;b\tc\n", "t.csv")->columns, ElementsAre("a;b", "c"));
  EXPECT_THAT(parseCsv("sep=;b\n1;2\n", "t.csv")->columns, ElementsAre("sep=", "b"));
  EXPECT_FALSE(parseCsv("sep=;", "t.csv"));
}

TEST(Csv, FormulasAreDisarmedAndComeBack) {
  EXPECT_EQ(guarded("=1+1"), "'=1+1");
  EXPECT_EQ(guarded("'=1+1"), "''=1+1");
  EXPECT_EQ(guarded("@cmd"), "'@cmd");
  for (const std::string wide : {"＝1+1", "＋1", "－1", "＠cmd"}) {
    EXPECT_EQ(guarded(wide), "'" + wide) << "wide letters of East Asian keyboards";
    EXPECT_EQ(unguarded("'" + wide), wide);
  }
  EXPECT_EQ(guarded("（grey)"), "（grey)") << "no formula begins so";
  EXPECT_EQ(guarded("'tis"), "'tis") << "a harmless quote stays alone";
  EXPECT_EQ(unguarded("'-5"), "-5");
  EXPECT_EQ(unguarded("-5"), "-5") << "typed by a person in a spreadsheet";
  EXPECT_EQ(unguarded("''"), "''");
}

TEST(Csv, AMarkInsideTheFirstQuotationIsNoPartOfTheName) {
  const Result<CsvTable> table = parseCsv("\"\xEF\xBB\xBFnumber\",part\r\n1,rim\r\n", "t");
  ASSERT_TRUE(table);
  EXPECT_EQ(table->columns, (std::vector<std::string>{"number", "part"}));
}

TEST(Csv, ManyMarksAreTakenOffAtOnce) {
  std::string marks;
  for (int i = 0; i < 300'000; ++i) marks += "\xEF\xBB\xBF";
  const auto begin = std::chrono::steady_clock::now();
  for (const char* quote : {"", "\""}) {
    const Result<CsvTable> table = parseCsv(quote + marks + "number" + quote + ",part\n", "t");
    ASSERT_TRUE(table);
    EXPECT_EQ(table->columns, (std::vector<std::string>{"number", "part"}));
  }
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(5))
      << "taken off one by one they take minutes";
}

TEST(Csv, MoreColumnsThanCanBeComparedAreRefused) {
  const std::string most(limits::kTableColumns.most - 1, ',');
  EXPECT_TRUE(parseCsv(most + "\n", "t"));
  EXPECT_EQ(parseCsv(most + ",\n", "t").error().what,
            "The table has more than 1,000 columns; split it.");
  EXPECT_TRUE(parseCsv("a,b\n" + most + ",\n", "t")) << "such a row is refused alone";
}

TEST(Csv, AColumnNamedWithSemicolonsStaysOne) {
  const std::vector<std::string> columns = {"ware; as Hayes; 1972", "no\tte", "part"};
  const Result<CsvTable> table = parseCsv(csvLine(columns) + csvLine({"a", "b", "c"}), "t");
  ASSERT_TRUE(table);
  EXPECT_EQ(table->columns, columns);
  EXPECT_EQ(table->rows[0].values, (std::vector<std::string>{"a", "b", "c"}));
}

TEST(Csv, AnyTextSurvivesWritingAndReading) {
  std::mt19937 random(5);
  const std::string letters = "=+-@'\",;\r\n\t aé1";
  for (int i = 0; i < 20'000; ++i) {
    std::string text;
    for (std::size_t n = random() % 8; n > 0; --n) {
      const char c = letters[random() % letters.size()];
      if (static_cast<unsigned char>(c) < 0x80) text += c;
    }
    EXPECT_EQ(unguarded(guarded(text)), text);
    const std::string guard = guarded(text);
    if (!guard.empty()) {
      EXPECT_EQ(std::string("=+-@\t\r\n").find(guard[0]), std::string::npos) << text;
    }
    const std::string file = csvLine({"a", "b"}) + csvLine({guard, "x"});
    const Result<CsvTable> table = parseCsv(file, "t");
    ASSERT_TRUE(table) << text;
    ASSERT_EQ(table->rows.size(), 1u) << text;
    EXPECT_EQ(table->rows[0].values[0], guard);
  }
}

}  // namespace
}  // namespace ostraka::tables
