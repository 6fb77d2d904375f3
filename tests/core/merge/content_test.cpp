#include "merge/content.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <set>

#include "store/database.h"
#include "tests/core/catalogue/small_project.h"

namespace ostraka::merge {
namespace {

class ReadContent : public catalogue::SmallProject {
 protected:
  Content read() { return readContent(catalogue().database()); }
  static Value in(const Table& table, const Row& row, const std::string& column) {
    return row.values.at(table.column(column));
  }
};

TEST_F(ReadContent, NamesRowsAndWhatTheyReferToByTheirIds) {
  const store::SherdRow sherd = numbered(context12);
  const Content content = read();
  const Table &contexts = content.table("context"), &sherds = content.table("sherd");
  const Row& only = sherds.rows.at(0);
  EXPECT_EQ(only.row, sherd.value);
  EXPECT_EQ(sherds.find(only.id), &only);
  EXPECT_EQ(sherds.find("no such id"), nullptr);
  const Row* context = contexts.find(*in(sherds, only, "context"));
  ASSERT_NE(context, nullptr);
  EXPECT_EQ(in(contexts, *context, "number"), "0012");
  EXPECT_EQ(in(sherds, only, "bag"), std::nullopt) << "NULL is not an empty text";
  EXPECT_EQ(sherds.column("no such column"), sherds.columns.size());
  EXPECT_THROW(content.table("stranger"), store::Refused);
}

// So that a row can be entered when all that it names is there.
TEST_F(ReadContent, PutsATableBehindThoseThatItRefersTo) {
  std::set<std::string> before;
  const Content content = read();
  for (const Table& table : content.tables) {
    before.insert(table.name);
    for (const std::string& name : table.refers) {
      EXPECT_TRUE(name.empty() || before.contains(name)) << table.name << " refers to " << name;
    }
    for (const std::string& name : table.unique)
      EXPECT_LT(table.column(name), table.columns.size()) << table.name << " has no " << name;
  }
  EXPECT_TRUE(before.contains("measurement"));
}

TEST_F(ReadContent, TellsTheHistoryInIdsThatBothProjectsKnow) {
  const store::SherdRow sherd = numbered(context12);
  ASSERT_TRUE(set(sherd, "ware", "grey"));
  const store::BatchRow batch = newBatch({bag5, bag4});
  const Content content = read();
  const Event& ware = *std::ranges::find(content.events, "ware", &Event::field);
  EXPECT_EQ(ware.row, content.table("sherd").rows.at(0).id);
  EXPECT_EQ(ware.person, content.table("person").rows.at(0).id);
  EXPECT_EQ(ware.old_value, "");
  EXPECT_EQ(ware.new_value, "grey");
  EXPECT_EQ(ware.refers, "");
  const Table& bags = content.table("bag");
  const std::string five = bags.rows.at(bags.by_row.at(bag5.value)).id,
                    four = bags.rows.at(bags.by_row.at(bag4.value)).id;
  const Event& begun = *std::ranges::find(content.events, "bags", &Event::field);
  EXPECT_EQ(begun.refers, "bag");
  EXPECT_THAT(begun.new_value, testing::AllOf(testing::HasSubstr(five), testing::HasSubstr(four)));
  const Table& batches = content.table("batch");
  EXPECT_THAT(content.bags.at(batches.rows.at(batches.by_row.at(batch.value)).id),
              testing::UnorderedElementsAre(five, four));
}

// Its event stays, and must not be taken for one of another row of that number.
TEST_F(ReadContent, NamesARowThatIsGoneByItsTableAndNumber) {
  const store::SherdRow sherd = draft(context12);
  ASSERT_TRUE(set(sherd, "ware", "grey"));
  store::Database& database = catalogue().database();
  database.script("PRAGMA foreign_keys = OFF");
  database.run("DELETE FROM sherd WHERE row = ?", sherd);
  const Content content = read();
  EXPECT_EQ(std::ranges::count(content.events, "sherd#" + std::to_string(sherd.value), &Event::row),
            std::ranges::count(content.events, "sherd", &Event::table));
}

TEST_F(ReadContent, TellsJoinsBothWays) {
  const store::SherdRow a = numbered(context12), b = numbered(context12);
  ASSERT_TRUE(set(a, "joins", "ARM1-T3-0012-0002"));
  const Content content = read();
  const std::string first = content.table("sherd").rows.at(0).id,
                    second = content.table("sherd").rows.at(1).id;
  EXPECT_EQ(content.table("sherd").by_row.at(b.value), 1u);
  EXPECT_THAT(content.joins,
              testing::ElementsAre(testing::Pair(first, second), testing::Pair(second, first)));
}

}  // namespace
}  // namespace ostraka::merge
