#include <gmock/gmock.h>

#include "tests/core/catalogue/small_project.h"

namespace ostraka::store {
namespace {

TEST(Statement, GivesItsRowsColumnByColumnAndAsLists) {
  const catalogue::TemporaryFolder folder;
  const auto made = Database::open(folder.path() / "c.sqlite", Database::Mode::Create);
  ASSERT_TRUE(made);
  Database& database = **made;
  database.script("CREATE TABLE thing (row INTEGER PRIMARY KEY, name TEXT, weight REAL) STRICT;");
  for (const char* name : {"rim", "base"})
    database.run("INSERT INTO thing (name, weight) VALUES (?, ?)", name, std::optional<double>());
  database.run("UPDATE thing SET weight = ? WHERE name = ?", 2.5, "base");

  Statement rows = database.sql("SELECT name, weight FROM thing WHERE row > ? ORDER BY row", 0);
  std::string name;
  std::optional<double> weight = 1.0;
  ASSERT_TRUE(rows.read(name, weight));
  EXPECT_EQ(name, "rim");
  EXPECT_FALSE(weight);
  ASSERT_TRUE(rows.read(name, weight));
  EXPECT_EQ(weight, 2.5);
  EXPECT_FALSE(rows.read(name, weight));
  EXPECT_EQ(name, "base") << "without a row they stay";

  EXPECT_THAT(database.sql("SELECT name FROM thing ORDER BY name").all<std::string>(),
              testing::ElementsAre("base", "rim"));
  EXPECT_EQ(database.sql("SELECT row FROM thing WHERE name = ?", "base").one<SherdRow>(),
            SherdRow{2});
  EXPECT_EQ(database.sql("SELECT weight FROM thing WHERE name = 'lid'").one<double>(), 0);
}

}  // namespace
}  // namespace ostraka::store
