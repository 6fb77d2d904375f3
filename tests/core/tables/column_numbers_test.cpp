// Numbers of a table that are read in two ways, or that hardly a sherd has.
#include "tables/column_numbers.h"

#include <gmock/gmock.h>

#include "sherds/sherd_fields.h"
#include "sherds/sherds.h"
#include "tests/core/tables/import_fixture.h"

namespace ostraka::tables {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class Numbers : public Import {
 protected:
  // A table of sherds in one context, with one more column.
  static std::string table(const std::string& column, const std::vector<std::string>& values,
                           char separator = ';') {
    std::string text;
    const auto line = [&](const std::vector<std::string>& cells) {
      for (const std::string& cell : cells)
        text += (text.empty() || text.back() == '\n' ? "" : std::string(1, separator)) + cell;
      text += "\n";
    };
    line({"number", "site", "trench", "context", column});
    for (std::size_t i = 0; i < values.size(); ++i)
      line({"X-" + std::to_string(i + 1), "ARM1", "T3", "0012", values[i]});
    return text;
  }
  std::string valueIn(const char* number, const char* field) {
    return sherds::textOf(
        *sherds::Sherds(catalogue()).get(*sherds::Sherds(catalogue()).byNumber(number)), field);
  }
  static std::vector<int> linesOf(const std::vector<Refusal>& refusals) {
    std::vector<int> lines;
    for (const Refusal& refusal : refusals) lines.push_back(refusal.line);
    return lines;
  }
};

TEST_F(Numbers, WithThreeDigitsBehindTheirOnlyMarkAreRefused) {
  for (const char* value : {"1,250", "2.500", "12.500", "100,000 g", "1.250 ± 3"})
    EXPECT_THAT(why(table("weight (g)", {value})), HasSubstr("can be read as")) << value;
  EXPECT_THAT(why(table("weight (g)", {"\"1,250\""}, ',')),
              HasSubstr("2 weight (g) 1,250: '1,250' can be read as 1250 or as 1.2500"));
  EXPECT_THAT(why(table("weight (kg)", {"2.500"})), HasSubstr("2.500: '2.500' can be read"))
      << "as it was written, not in grams";
  for (const char* value : {"0,125", "12,5", "1250,125", "1250", "1.2500"})
    EXPECT_EQ(why(table("weight (g)", {value})), "accepted") << value;
}

TEST_F(Numbers, AreReadAsTheOthersOfTheirColumnShow) {
  ImportReport report = import(table("weight (g)", {"1,250", "12,5"}));
  EXPECT_EQ(report.fresh, 2);
  EXPECT_EQ(valueIn("X-1", "weight_g"), "1.25");
  report = import(table("weight (g)", {"2.500", "12,5"}));
  EXPECT_THAT(linesOf(report.refusals), ElementsAre(2)) << "a point is none of its decimal marks";
  report = import(table("weight (g)", {"2.500", "12,5", "7.5"}));
  EXPECT_THAT(linesOf(report.refusals), ElementsAre(2)) << "the others contradict each other";
  report = import(table("weight (g)", {"2.500", "0.125"}));
  EXPECT_TRUE(report.refusals.empty()) << "thousands do not begin with 0";
}

TEST_F(Numbers, OfATableThatOstrakaWroteHavePoints) {
  const std::string head = "number,site,trench,context,weight_g";
  EXPECT_EQ(import(head + ",measured_by_hand\nX-1,ARM1,T3,0012,12.125,weight_g\n").fresh, 1);
  EXPECT_EQ(import(head + "\nX-2,ARM1,T3,0012,12.125\n").refused, 1);
}

TEST_F(Numbers, OfBagsAreRefusedAlike) {
  const std::string bag = "site;trench;context;bag;weight_g\nARM1;T3;0012;4;";
  EXPECT_THAT(why(bag + "1,250\n"), HasSubstr("can be read as 1250 or as 1.250"));
  EXPECT_EQ(import(bag + "1.25\n").changed, 1);
  EXPECT_EQ(import(bag + "1,250\n").same, 1) << "it is there already";
}

TEST_F(Numbers, ThatHardlyASherdHasAsk) {
  const ImportReport report =
      import(table("weight_g", {"0.001", "19500", "23.4", "210", "8", "40.5"}));
  EXPECT_EQ(report.fresh, 4);
  EXPECT_EQ(report.asked, 2);
  EXPECT_THAT(linesOf(report.questions), ElementsAre(2, 3));
  EXPECT_EQ(report.questions[0].reason, "Check the unit: 0.001 g is unusual for a sherd.");
  EXPECT_FALSE(*sherds::Sherds(catalogue()).byNumber("X-1"));
  EXPECT_EQ(import(table("weight_g", {"0.4", "900"})).questions.size(), 2u);
}

TEST_F(Numbers, OfRimsBelowOnePerCentAsk) {
  const ImportReport report = import(table("rim_pct", {"0.15", "12", "100"}));
  EXPECT_THAT(linesOf(report.questions), ElementsAre(2));
  EXPECT_EQ(report.fresh, 2);
}

TEST_F(Numbers, FarFromTheOthersOfTheirColumnAsk) {
  const std::string diameters = table("rim_diameter_mm", {"24", "240", "0.24"});
  const ImportReport report = import(diameters);
  EXPECT_EQ(report.asked, 3) << "nobody knows which of them is right";
  EXPECT_EQ(report.fresh, 0);
  EXPECT_EQ(report.questions[1].reason,
            "Check the unit: 240 mm is far from the other values of this column.");
  const ImportReport one = import(table("rim_diameter_mm", {"180", "220", "24", "205"}));
  EXPECT_THAT(linesOf(one.questions), ElementsAre(4));
}

TEST_F(Numbers, ThatAskEnterOnceTheyAreConfirmedAndAreNotAskedAboutAgain) {
  const std::string weights = table("weight_g", {"19500", "23.4"});
  ImportOptions confirmed;
  confirmed.mode = ImportMode::Enter;
  confirmed.confirmed_lines = {2};
  const auto report = importTable(catalogue(), weights, "t.csv", confirmed, anna, quiet, {});
  ASSERT_TRUE(report);
  EXPECT_EQ(report->questions.size(), 1u) << "the other one is far from it";
  EXPECT_EQ(valueIn("X-1", "weight_g"), "19500");
  EXPECT_EQ(import(table("weight_g", {"19500"})).same, 1);
}

TEST_F(Import, OfChangesNamesWhatIsReplaced) {
  import("number,site,trench,context,ware,bag\nX-1,ARM1,T3,0012,grey,4\n");
  const ImportReport report = import("number,ware,note\nX-1,cooking,burnt\n", ImportMode::Preview);
  ASSERT_EQ(report.changed_values.size(), 2u);
  const ChangedValue& ware = report.changed_values[0].field == "ware" ? report.changed_values[0]
                                                                      : report.changed_values[1];
  EXPECT_EQ(ware.name, "X-1");
  EXPECT_EQ(ware.line, 2);
  EXPECT_EQ(ware.old_value, "grey");
  EXPECT_EQ(ware.new_value, "cooking");
  EXPECT_TRUE(import("number,site,trench,context\nX-2,ARM1,T3,0012\n").changed_values.empty());
  import("site,trench,context,bag,weight_g\nARM1,T3,0012,4,12.5\n");
  const ImportReport bags =
      import("site,trench,context,period,bag,weight_g\nARM1,T3,0012,Iron Age,4,13\n");
  ASSERT_EQ(bags.changed_values.size(), 2u);
  EXPECT_EQ(bags.changed_values[0].name, "ARM1 T3 0012");
  EXPECT_EQ(bags.changed_values[0].new_value, "Iron Age");
  EXPECT_EQ(bags.changed_values[1].name, "ARM1 T3 0012, bag 4");
  EXPECT_EQ(bags.changed_values[1].line, 2);
  EXPECT_EQ(bags.changed_values[1].old_value, "12.5");
  EXPECT_EQ(bags.changed_values[1].new_value, "13");
}

}  // namespace
}  // namespace ostraka::tables
