#include "merge/units.h"

#include <gmock/gmock.h>

#include <map>
#include <set>

#include "store/database.h"
#include "tests/core/catalogue/small_project.h"

namespace ostraka::merge {
namespace {

using testing::ElementsAre;

Table tableOf(const char* name, const std::vector<std::string>& columns) {
  Table table;
  table.name = name;
  table.columns = columns;
  return table;
}

std::map<std::string, std::vector<std::size_t>> columnsOf(const std::vector<Unit>& units) {
  std::map<std::string, std::vector<std::size_t>> all;
  for (const Unit& unit : units) all[unit.name] = unit.columns;
  return all;
}

TEST(Units, AreWhatAPersonDecidesInOneStep) {
  const auto units = columnsOf(unitsOf(tableOf(
      "site", {"latitude_deg", "code", "code_key", "longitude_deg", "name", "created_at"})));
  EXPECT_THAT(units, ElementsAre(testing::Pair("code", ElementsAre(1, 2)),
                                 testing::Pair("location", ElementsAre(0, 3)),
                                 testing::Pair("name", ElementsAre(4))));
}

// Else a merge could take the bag of one project and the context of the other.
TEST(Units, OfASherdsPlaceAreToldByTheHistoryOfItsSiteAndTrenchToo) {
  const std::vector<Unit> units = unitsOf(tableOf("sherd", {"context", "note", "bag"}));
  ASSERT_EQ(units.size(), 2u);
  EXPECT_EQ(units[0].name, "place");
  EXPECT_THAT(units[0].columns, ElementsAre(0, 2));
  EXPECT_THAT(units[0].fields, ElementsAre("context", "bag", "site", "trench"));
  EXPECT_THAT(units[1].fields, ElementsAre("note"));
}

TEST(Units, AreNoneOfWhatIsOnlyAddedTo) {
  EXPECT_TRUE(unitsOf(tableOf("pair_decision", {"verdict", "note"})).empty());
  EXPECT_TRUE(unitsOf(tableOf("measurement", {"value"})).empty());
  EXPECT_TRUE(unitsOf(tableOf("scan", {"state", "updated_at"})).empty()) << "follows from others";
}

using UnitsOfProject = catalogue::SmallProject;

// A column of a later migration that nobody thought of is a unit by itself.
TEST_F(UnitsOfProject, HoldNoColumnOfTheCatalogueTwice) {
  const Content content = readContent(catalogue().database());
  for (const Table& table : content.tables) {
    std::set<std::size_t> columns;
    std::set<std::string> names;
    for (const Unit& unit : unitsOf(table)) {
      EXPECT_TRUE(names.insert(unit.name).second) << table.name << " " << unit.name;
      for (const std::size_t column : unit.columns)
        EXPECT_TRUE(columns.insert(column).second) << table.name << " " << table.columns[column];
    }
  }
  const auto sherd = columnsOf(unitsOf(content.table("sherd")));
  EXPECT_EQ(sherd.at("place").size(), 2u) << "both columns are still called so";
  EXPECT_EQ(sherd.at("number").size(), 4u);
  EXPECT_EQ(sherd.at("model").size(), 2u);
  EXPECT_EQ(columnsOf(unitsOf(content.table("batch"))).at("results").size(), 10u);
}

TEST(CustomFields, GoThereAndBackInTheOrderOfTheirNames) {
  const auto fields = customFields(R"({"shelf":"B \"2\"","drawer":7,"list":[1]})");
  using testing::Pair;
  EXPECT_THAT(fields,
              ElementsAre(Pair("drawer", "7"), Pair("list", "[1]"), Pair("shelf", R"("B \"2\"")")));
  EXPECT_EQ(customFieldsJson(fields), R"({"drawer":7,"list":[1],"shelf":"B \"2\""})");
  EXPECT_EQ(textOf(fields[2].second), "B \"2\"");
  EXPECT_EQ(textOf(fields[0].second), "7");
  for (const Value& none : {Value(), Value(""), Value("[1]"), Value("{not json")})
    EXPECT_TRUE(customFields(none).empty()) << none.value_or("NULL");
  EXPECT_EQ(customFieldsJson({}), "{}");
}

}  // namespace
}  // namespace ostraka::merge
