// Sites, trenches, contexts and bags from a table.
#include <gmock/gmock.h>

#include "catalogue/places.h"
#include "records/records.h"
#include "tests/core/tables/import_fixture.h"

namespace ostraka::tables {
namespace {

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

TEST_F(Import, OfContextsCountsABagThatItMakesAsNewAndTellsWhatItReplaces) {
  import("site,trench,context,period,drawer\nARM1,T3,0012,Roman,A\n");
  const std::string table =
      "site,trench,context,period,drawer,bag,weight_g\nARM1,T3,0012,Iron Age,B,9,120\n"
      "ARM1,T3,0013,,,1,\n";
  const ImportReport report = import(table, ImportMode::Preview);
  EXPECT_EQ(report.fresh, 1) << "bag 9";
  EXPECT_EQ(report.changed, 0);
  EXPECT_EQ(report.same, 1) << "bag 1 is there";
  ASSERT_EQ(report.changed_values.size(), 2u) << "nothing of the new bag";
  for (const ChangedValue& value : report.changed_values) EXPECT_EQ(value.line, 2);
  EXPECT_EQ(report.changed_values[0].old_value + report.changed_values[0].new_value,
            "RomanIron Age");
  EXPECT_EQ(report.changed_values[1].field, "extra.drawer");
  EXPECT_EQ(report.changed_values[1].old_value + report.changed_values[1].new_value, "AB");
  import(table);
  EXPECT_EQ(import(table).same, 2);
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
