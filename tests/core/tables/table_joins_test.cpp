#include "tables/table_joins.h"

#include <gmock/gmock.h>

#include "sherds/sherd_fields.h"
#include "sherds/sherds.h"
#include "tables/import_table.h"
#include "tests/core/tables/import_fixture.h"

namespace ostraka::tables {
namespace {

class Joins : public Import {
 protected:
  std::string of(const char* number) {
    return sherds::textOf(
        *sherds::Sherds(catalogue()).get(*sherds::Sherds(catalogue()).byNumber(number)), "joins");
  }
  const std::string head = "number,site,trench,context,joins\n";
};

TEST_F(Joins, WrittenInOneDirectionAllHoldAndComeToRest) {
  import(head + "X-1,ARM1,T3,0012,\nX-2,ARM1,T3,0012,\nX-3,ARM1,T3,0012,\n");
  const std::string chain = "number,joins\nX-1,X-2\nX-2,X-3\n";
  EXPECT_EQ(import(chain).changed, 2);
  EXPECT_EQ(of("X-1") + ", " + of("X-2") + ", " + of("X-3"), "X-2, X-1; X-3, X-2");
  EXPECT_EQ(import(chain).same, 2);
  EXPECT_EQ(import("number,joins\nX-1,X-2\nX-3,x-2\n").same, 2);
  EXPECT_EQ(import("number,joins\nX-2,X-3\n").changed, 1);
  EXPECT_EQ(of("X-1") + of("X-3"), "X-2") << "the table says that X-2 joins X-3 alone";
  EXPECT_EQ(import("number,joins\nX-3,<clear>\n").changed, 1);
  EXPECT_EQ(of("X-2"), "");
}

TEST_F(Joins, AmongNewSherdsEnterWithThem) {
  const std::string both = head +
                           "X-1,ARM1,T3,0012,X-2; X-3\nX-2,ARM1,T3,0012,X-1\n"
                           "X-3,ARM1,T3,0012,\n";
  const ImportReport report = import(both);
  EXPECT_EQ(report.fresh, 3);
  EXPECT_TRUE(report.warnings.empty());
  EXPECT_EQ(of("X-1") + ", " + of("X-2") + ", " + of("X-3"), "X-2; X-3, X-1, X-1");
  EXPECT_EQ(import(both).same, 3);
}

TEST_F(Joins, WithARowThatIsRefusedAreTold) {
  const ImportReport report =
      import(head +
             "X-1,ARM1,T3,0012,X-2\nX-2,ARM1,T3,0099,X-1\nX-4,ARM1,T3,0012,X-5\n"
             "X-6,ARM1,T3,0012,X-6\n");
  EXPECT_EQ(report.fresh, 1);
  EXPECT_EQ(of("X-1"), "");
  EXPECT_THAT(report.warnings, testing::Contains(testing::HasSubstr("left out: X-1 – X-2;")));
  EXPECT_EQ(report.refused, 3);
  EXPECT_THAT(report.refusals[1].reason, testing::HasSubstr("no sherd X-5 to join"));
  EXPECT_THAT(report.refusals[2].reason, testing::HasSubstr("cannot join itself"));
}

}  // namespace
}  // namespace ostraka::tables
