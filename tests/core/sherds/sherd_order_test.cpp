#include "sherds/sherds.h"
#include "store/database.h"
#include "store/migrations.h"
#include "tests/core/catalogue/small_project.h"

namespace ostraka::sherds {
namespace {

// Which index a query of the order is read from.
std::string planOf(store::Database& database, const std::string& query) {
  std::string plan;
  store::Statement rows = database.sql("EXPLAIN QUERY PLAN " + query);
  while (rows.next()) {
    int skipped = 0;
    std::string detail;
    rows >> skipped >> skipped >> skipped >> detail;
    plan += detail + "\n";
  }
  return plan;
}

TEST(Order, OfTheShownRowsComesFromIndexesAlone) {
  const catalogue::TemporaryFolder folder;
  const auto database =
      std::move(*store::Database::open(folder.path() / "c.sqlite", store::Database::Mode::Create));
  ASSERT_TRUE(store::migrate(*database, store::migrations(), {}));
  for (const char* query :
       {"SELECT s.row FROM sherd s WHERE NOT (s.state = 'void' AND s.number = '') ORDER BY "
        "s.number_sort, s.row",
        "SELECT ware, row FROM sherd WHERE ware <> '' ORDER BY ware",
        "SELECT part, row FROM sherd WHERE part <> '[]' ORDER BY part",
        "SELECT state, row FROM sherd WHERE state <> '' ORDER BY state",
        "SELECT context, row FROM sherd WHERE context IS NOT NULL ORDER BY context",
        "SELECT length, sherd FROM sherd_measure WHERE length IS NOT NULL ORDER BY length"}) {
    const std::string plan = planOf(*database, query);
    EXPECT_NE(plan.find("COVERING INDEX"), std::string::npos) << query << "\n" << plan;
    EXPECT_EQ(plan.find("TEMP B-TREE"), std::string::npos) << query << "\n" << plan;
  }
}

class Ordered : public catalogue::SmallProject {
 protected:
  Ordered() {
    for (const store::ContextRow& in : {context12, context12, context13, context13}) {
      const store::SherdRow row = numbered(in);
      rows.push_back(row);
    }
    EXPECT_TRUE(set(rows[0], "ware", "red"));
    EXPECT_TRUE(set(rows[1], "ware", "grey"));
    EXPECT_TRUE(set(rows[3], "ware", "red"));
    EXPECT_TRUE(set(rows[1], "bag", "5"));
    EXPECT_TRUE(set(rows[0], "bag", "4"));
    EXPECT_TRUE(set(rows[2], "weight_g", "12"));
    EXPECT_TRUE(set(rows[0], "weight_g", "7,5"));
    EXPECT_TRUE(set(rows[3], "weight_g", "12"));
  }
  /// The sherds' places in `rows`.
  std::string by(const std::string& field, bool descending = false, const std::string& line = "") {
    std::string out;
    for (const std::string& number : found(line, {field, descending}))
      for (std::size_t i = 0; i < rows.size(); ++i)
        if (Sherds(catalogue()).get(rows[i])->number == number) out += static_cast<char>('0' + i);
    return out;
  }
  std::vector<store::SherdRow> rows;
};

TEST_F(Ordered, TiesGoByNumberAndWhatIsNotRecordedComesLastBothWays) {
  EXPECT_EQ(by("ware"), "1032");
  EXPECT_EQ(by("ware", true), "0312");
  EXPECT_EQ(by("weight_g"), "0231");
  EXPECT_EQ(by("weight_g", true), "2301");
  EXPECT_EQ(by("bag"), "0123");
  EXPECT_EQ(by("bag", true), "1023");
  EXPECT_EQ(by("context", true), "2301");
  EXPECT_EQ(by("number", true), "3210");
  EXPECT_EQ(by("updated", true).substr(0, 1), "3");
  EXPECT_EQ(by("batch"), "0123") << "no batch at all";
}

TEST_F(Ordered, OnlyTheRowsThatFitAreOrdered) {
  EXPECT_EQ(by("weight_g", true, "ware:red"), "30");
}

TEST_F(Ordered, AFieldThatOrdersNothingIsRefused) {
  const auto refused = Sherds(catalogue()).rows({}, {"colour", false});
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().sentence().english().find("'colour'"), std::string::npos);
}

}  // namespace
}  // namespace ostraka::sherds
