// Rows that do not enter, and what is said of them.
#include <gmock/gmock.h>

#include "sherds/sherds.h"
#include "tables/import_table.h"
#include "tables/refused_rows.h"
#include "tests/core/tables/import_fixture.h"

namespace ostraka::tables {
namespace {

using namespace catalogue;

TEST_F(Import, EachRefusalSaysRowColumnValueAndReason) {
  import(kTwo);
  const std::string head = "number,site,trench,context,part,length_mm,munsell_out,date_edtf,uuid\n";
  const auto row = [&](const std::string& line) { return why(head + line + "\n"); };
  EXPECT_NE(row("X-1,ARM1,T3,0012,wing,,,,").find("2 part wing: 'wing' is not a term"),
            std::string::npos);
  EXPECT_NE(row("X-1,ARM1,T3,0099,,,,,").find("2 context 0099: There is no context"),
            std::string::npos);
  EXPECT_NE(row("X-1,ARM1,T3,,,,,,").find("needs its context"), std::string::npos);
  EXPECT_NE(row("X-1,ARM1,T3,0012,,abc,,,").find("2 length_mm abc"), std::string::npos);
  EXPECT_NE(row("X-1,ARM1,T3,0012,,0,,,").find("greater than 0"), std::string::npos);
  EXPECT_NE(row("X-1,ARM1,T3,0012,,1001,,,").find("1000 mm"), std::string::npos);
  EXPECT_NE(row("X-1,ARM1,T3,0012,,,brown,,").find("2 munsell_out brown"), std::string::npos);
  EXPECT_NE(row("X-1,ARM1,T3,0012,,,,600 BC,").find("2 date_edtf 600 BC"), std::string::npos);
  EXPECT_NE(row("X-1,ARM1,T3,0012,,,,,nonsense").find("2 uuid nonsense: Not a uuid"),
            std::string::npos);
  EXPECT_NE(row("ARM1-T3-0012-0001,,,,,,,,019f5ff6-39c0-7b3a-9c55-2f7e8d104ab6")
                .find("belong to different sherds"),
            std::string::npos);
  EXPECT_NE(row(",ARM1,T3,0012,,,,,").find("neither a number nor a uuid"), std::string::npos);
  EXPECT_NE(row("X-1,ARM1").find("2  : Values in the row: 2, columns in the header: 9"),
            std::string::npos);
  EXPECT_NE(why(head + "Y-1,ARM1,T3,0012,,,,,\ny-1,ARM1,T3,0012,,,,,\nY-2,ARM1,T3,0012,,,,,\n")
                .find("2 number Y-1: This appears in more than one row of the table, in the lines "
                      "2, 3."),
            std::string::npos);
  EXPECT_FALSE(*sherds::Sherds(catalogue()).byNumber("X-1")) << "a refused row leaves nothing";
  EXPECT_FALSE(*sherds::Sherds(catalogue()).byNumber("Y-1")) << "nor does either of two";
  EXPECT_TRUE(*sherds::Sherds(catalogue()).byNumber("Y-2")) << "the other rows enter";
}

std::vector<std::string> columnsOf(const std::vector<Refusal>& refusals) {
  std::vector<std::string> columns;
  for (const Refusal& refusal : refusals) columns.push_back(refusal.column);
  return columns;
}

// Else a table of bad values is corrected and tried as often as its rows have faults.
TEST_F(Import, AllFaultsOfARowAreToldAtOnce) {
  const ImportReport report = import(
      "number,site,trench,context,bag,part,length_mm,width_mm,munsell_out,joins,uuid\n"
      "X-1,ARM1,T3,0099,4,wing,abc,0,brown,X-7,nonsense\n"
      "X-2,ARM1,T3,,,wing,12,11,,,\n");
  EXPECT_EQ(report.refused, 2);
  EXPECT_THAT(columnsOf(report.refusals),
              testing::ElementsAre("uuid", "joins", "bag", "length_mm", "munsell_out", "part",
                                   "width_mm", "context", "part"))
      << "the parts of a place are one value";
  EXPECT_EQ(report.refusals[6].line, 2);
  EXPECT_EQ(report.refusals[7].line, 3);
  EXPECT_EQ(report.left_out.rows.size(), 2u);
  const std::string text =
      refusedRowsCsv(report, [](const Message& reason) { return reason.english(); });
  EXPECT_NE(text.find("part: 'wing' is not a term"), std::string::npos) << text;
  EXPECT_NE(text.find(" width_mm: Enter a value greater than 0."), std::string::npos) << text;
}

TEST_F(Import, NumbersThatReadAsOthersAreToldOnce) {
  const std::string head = "number,site,trench,context\n", rest = ",ARM1,T3,0012\n";
  import(head + "K-0007" + rest);
  const std::string table = head + "k/7" + rest + "K-8" + rest + "K-08" + rest + "K-9" + rest;
  const ImportReport report = import(table);
  EXPECT_EQ(report.fresh, 4);
  EXPECT_THAT(
      report.warnings,
      testing::ElementsAre("New numbers differ from existing ones only in zeros, letter case or "
                           "punctuation: k/7 (K-0007), K-08 (K-8); check for typos."));
  EXPECT_TRUE(import(table).warnings.empty()) << "they are there now";
}

// Sherds with the trench's other spelling on them, one of which does not enter.
TEST_F(Import, NumbersOfRowsThatDoNotEnterAreToldAndThoseThatDidAreContinued) {
  import("number,site,trench,context\nOLD-1,ARM1,T3,0012\n");
  ASSERT_TRUE(set(*sherds::Sherds(catalogue()).byNumber("OLD-1"), "number", "OLD-2"));
  const ImportReport report = import(
      "number,site,trench,context,part\narm1-t3-0012-0002,arm1,t3,0012,rim\n"
      "arm1-t3-0012-0003,arm1,t3,0012,rimm\nold-1,arm1,t3,0012,\n");
  EXPECT_EQ(report.refused, 2) << "no such part; the number was assigned before";
  EXPECT_THAT(report.warnings,
              testing::ElementsAre("Rows that are not imported leave their numbers free: "
                                   "arm1-t3-0012-0003; correct and import them before you assign "
                                   "new numbers."));
  EXPECT_THAT(*sherds::Numbers(catalogue()).propose(std::vector{draft(context12)}),
              testing::ElementsAre("ARM1-T3-0012-0003"));
  import("number,site,trench,context\narm1-t3-0012-0007,arm1,t3,0012\n");
  EXPECT_THAT(*sherds::Numbers(catalogue()).propose(std::vector{draft(context12)}),
              testing::ElementsAre("ARM1-T3-0012-0008"));
}

TEST_F(Import, OfAStateThatContradictsTheReasonIsRefused) {
  const std::string head = "number,site,trench,context,state,void_reason\n";
  import(head + "X-1,ARM1,T3,0012,numbered,\nX-2,ARM1,T3,0012,void,a stone\n");
  EXPECT_EQ(valueOf(*sherds::Sherds(catalogue()).byNumber("X-2"), "state"), "void");
  const auto fate = [&](const std::string& of_row) {
    const ImportReport report =
        import("number,state,void_reason\n" + of_row + "\n", ImportMode::Preview);
    return !report.refusals.empty() ? report.refusals[0].column
           : report.changed == 1    ? std::string("changed")
                                    : "same";
  };
  EXPECT_EQ(fate("X-1,Numbered,"), "same");
  EXPECT_EQ(fate("X-1,void,"), "state") << "no reason";
  EXPECT_EQ(fate("X-1,void,lost"), "changed");
  EXPECT_EQ(fate("X-1,numbered,lost"), "state");
  EXPECT_EQ(fate("X-1,rubbish,"), "state");
  EXPECT_EQ(fate("X-2,numbered,"), "state") << "void still";
  EXPECT_EQ(fate("X-2,numbered,<clear>"), "changed");
  EXPECT_EQ(fate("X-2,void,"), "same");
  EXPECT_EQ(why(head + "X-9,ARM1,T3,0012,void,\n"),
            "2 state void: A sherd is void only with a reason; write it under void_reason, or "
            "correct the state.");
}

TEST_F(Import, NumbersThatASpreadsheetDamagedAreToldOnce) {
  const std::string table =
      "number,site,trench,context,bag,note\n"
      "1.23E+05,ARM1,T3,0012,2E+11,4E+05\n"
      "2-E+05,ARM1,T3,0012,2E+11,\n"
      "12E05,ARM1,T3,0012,02-Jan,\n";
  const ImportReport report = import(table, ImportMode::Enter, UnknownPlaces::Make);
  EXPECT_EQ(report.fresh, 3);
  EXPECT_THAT(report.warnings,
              testing::ElementsAre(testing::HasSubstr(": 2E+11, 1.23E+05, 02-Jan;")));
  EXPECT_TRUE(import(table).warnings.empty()) << "they are there now";
}

TEST_F(Import, AllDoubtsAboutARowAreAskedAtOnce) {
  const ImportReport report =
      import("number,site,trench,context,length_mm,weight_g\nX-1,ARM1,T3,0012,900,9000\n");
  EXPECT_EQ(report.asked, 1);
  EXPECT_TRUE(report.refusals.empty());
  EXPECT_THAT(columnsOf(report.questions), testing::ElementsAre("length_mm", "weight_g"));
  EXPECT_FALSE(*sherds::Sherds(catalogue()).byNumber("X-1"));
}

TEST_F(Import, AllFaultsOfAContextAreToldAtOnce) {
  const ImportReport report = import(
      "site,trench,context,kind,excavated_on,date_edtf,closed,bag,collected_on,weight_g,"
      "count_written\n"
      "ARM1,T3,0012,hole,yesterday,600 BC,perhaps,4,today,x,1.5\n");
  EXPECT_EQ(report.refused, 1);
  EXPECT_THAT(columnsOf(report.refusals),
              testing::UnorderedElementsAre("closed", "excavated_on", "date_edtf", "context",
                                            "collected_on", "weight_g", "count_written"));
  EXPECT_EQ(report.refusals[0].value, "perhaps");
}

// Of 40 rows with one number each is refused; a list of all of them in each would be 1,600.
TEST_F(Import, ARefusalNamesTheFirstOfManyRowsThatAreAlike) {
  std::string table = "number,site,trench,context\n";
  for (int i = 0; i < 40; ++i) table += "Y-1,ARM1,T3,0012\n";
  const ImportReport report = import(table);
  ASSERT_EQ(report.refused, 40);
  for (const Refusal& refusal : report.refusals)
    EXPECT_EQ(
        refusal.reason,
        "This appears in more than one row of the table, in the lines 2, 3, 4, 5, 6, 7, 8, 9, "
        "10, 11 and 30 more.");
}

}  // namespace
}  // namespace ostraka::tables
