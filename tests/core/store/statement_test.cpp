#include <gmock/gmock.h>

#include <limits>

#include "base/limits.h"
#include "store/database.h"
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
  using Thing = std::pair<std::string, std::optional<double>>;
  EXPECT_THAT(database.sql("SELECT name, weight FROM thing ORDER BY row")
                  .all(&Thing::first, &Thing::second),
              testing::ElementsAre(Thing("rim", std::nullopt), Thing("base", 2.5)));
}

TEST(Statement, StoresOnlyWhatCanBeExportedAndRestored) {
  const catalogue::TemporaryFolder folder;
  const auto made = Database::open(folder.path() / "c.sqlite", Database::Mode::Create);
  ASSERT_TRUE(made);
  Database& database = **made;
  database.script(
      "CREATE TABLE thing (name TEXT, weight REAL) STRICT; CREATE TABLE history (why TEXT) STRICT;"
      "CREATE TEMP TABLE typed (name TEXT) STRICT;");
  const auto refusedIn = [&](const char* sql, const auto& value) {
    const Result<void> done = database.asResult([&] { database.run(sql, value); });
    return done ? std::string() : done.error().where;
  };
  for (const std::string& text :
       {std::string("a\0b", 3), std::string("\x1B[2J"), std::string("\xFF"),
        std::string(limits::kValueBytes.most + 1, 'x')}) {
    for (const char* stores :
         {"INSERT INTO thing (name) VALUES (?)", "INSERT OR REPLACE INTO thing (name) SELECT ?",
          "UPDATE thing SET name = ?"})
      EXPECT_EQ(refusedIn(stores, text), "thing") << stores;
    for (const char* other :
         {"SELECT name FROM thing WHERE name = ?", "DELETE FROM thing WHERE name = ?",
          "INSERT INTO temp.typed VALUES (?)", "INSERT INTO history VALUES (?)"})
      EXPECT_EQ(refusedIn(other, text), "") << other;
  }
  EXPECT_EQ(refusedIn("INSERT INTO thing (name) VALUES (?)", std::string("two\nlines\tand more")),
            "");
  constexpr const char* kWeight = "INSERT INTO thing (weight) VALUES (?)";
  EXPECT_EQ(refusedIn(kWeight, std::numeric_limits<double>::infinity()), "thing");
  EXPECT_EQ(refusedIn(kWeight, std::numeric_limits<double>::quiet_NaN()), "") << "as NULL";
  EXPECT_EQ(database.sql("SELECT count(*) FROM thing").one<int>(), 2);
}

}  // namespace
}  // namespace ostraka::store
