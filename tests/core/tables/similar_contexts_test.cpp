#include "tables/similar_contexts.h"

#include <gmock/gmock.h>

#include "tests/core/tables/import_fixture.h"

namespace ostraka::tables {
namespace {

// Spreadsheets leave out zeros: the sherds of one context would stand in two.
TEST_F(Import, OfContextsThatReadAsOthersAreTold) {
  const ImportReport report =
      import("site,trench,context\nARM1,T3,12\nARM1,T3,012\nARM1,T3,14\nARM1,T4,12\n");
  EXPECT_EQ(report.fresh, 4);
  EXPECT_THAT(report.warnings,
              testing::Contains("New contexts differ from existing ones only in zeros, letter case "
                                "or punctuation: 12 (0012), 012 (0012); check for typos."));
  const ImportReport again = import("site,trench,context,kind\nARM1,T3,12,layer\n");
  EXPECT_THAT(again.warnings, testing::IsEmpty()) << "it is there now";
}

TEST_F(Import, OfSherdsTellsOfContextsThatReadAsOthers) {
  const std::string head = "number,site,trench,context\n";
  const ImportReport report = import(head + "K-1,ARM1,T3,12\nK-2,ARM1,T3,12\nK-3,ARM1,T3,0012\n",
                                     ImportMode::Enter, UnknownPlaces::Make);
  EXPECT_EQ(report.fresh, 3);
  EXPECT_THAT(report.warnings,
              testing::ElementsAre("New contexts differ from existing ones only in zeros, letter "
                                   "case or punctuation: 12 (0012); check for typos."));
}

}  // namespace
}  // namespace ostraka::tables
