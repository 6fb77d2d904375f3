#include "store/migrations.h"

#include "tests/core/catalogue/small_project.h"

namespace ostraka::store {
namespace {

const std::vector<Migration> kTwo = {
    {1, "0001_a", "CREATE TABLE thing (row INTEGER PRIMARY KEY, name TEXT NOT NULL) STRICT;"},
    {2, "0002_b", "ALTER TABLE thing ADD COLUMN weight REAL; UPDATE thing SET weight = 2.5;"}};

std::unique_ptr<Database> fresh(const catalogue::TemporaryFolder& folder) {
  return std::move(*Database::open(folder.path() / "c.sqlite", Database::Mode::Create));
}

TEST(Migrations, AnOlderCatalogueKeepsItsRowsAndIsBackedUpFirst) {
  const catalogue::TemporaryFolder folder;
  const auto database = fresh(folder);
  int backups = 0;
  const auto backup = [&]() -> Result<void> {
    ++backups;
    return {};
  };
  ASSERT_TRUE(migrate(*database, std::span(kTwo).first(1), backup));
  EXPECT_EQ(backups, 0) << "a new catalogue has nothing to lose";
  database->script("INSERT INTO thing VALUES (1, 'old')");
  ASSERT_TRUE(migrate(*database, kTwo, backup));
  EXPECT_EQ(backups, 1);
  EXPECT_EQ(schemaVersion(*database), 2);
  Statement row = database->sql("SELECT name, weight FROM thing");
  std::string name;
  double weight = 0;
  ASSERT_TRUE(row.next());
  row >> name >> weight;
  EXPECT_EQ(name, "old");
  EXPECT_EQ(weight, 2.5);
  ASSERT_TRUE(migrate(*database, kTwo, backup));
  EXPECT_EQ(backups, 1) << "nothing to do";
}

TEST(Migrations, ANewerSchemaIsRefusedWithASentence) {
  const catalogue::TemporaryFolder folder;
  const auto database = fresh(folder);
  ASSERT_TRUE(migrate(*database, kTwo, {}));
  const Result<void> older = migrate(*database, std::span(kTwo).first(1), {});
  ASSERT_FALSE(older);
  EXPECT_NE(older.error().what.english().find(
                "newer Ostraka made this project (catalogue version 2, this program supports 1)"),
            std::string::npos);
}

TEST(Migrations, AStepThatFailsLeavesTheLastWholeSchema) {
  const catalogue::TemporaryFolder folder;
  const auto database = fresh(folder);
  const std::vector<Migration> broken = {
      kTwo[0], {2, "0002_bad", "CREATE TABLE half (a INTEGER) STRICT; CREATE NONSENSE;"}};
  EXPECT_FALSE(migrate(*database, broken, {}));
  EXPECT_EQ(schemaVersion(*database), 1);
  EXPECT_THROW(database->sql("SELECT * FROM half"), SqlFailure);
}

TEST(Migrations, ABackupThatFailsStopsTheUpdate) {
  const catalogue::TemporaryFolder folder;
  const auto database = fresh(folder);
  ASSERT_TRUE(migrate(*database, std::span(kTwo).first(1), {}));
  const auto full = []() -> Result<void> { return Error{ErrorCode::CannotWrite, "full", {}}; };
  EXPECT_FALSE(migrate(*database, kTwo, full));
  EXPECT_EQ(schemaVersion(*database), 1);
}

TEST(Migrations, TheProgramsOwnAreNumberedWithoutGapsAndMakeASoundCatalogue) {
  int number = 0;
  for (const Migration& step : migrations()) EXPECT_EQ(step.number, ++number) << step.name;
  EXPECT_GE(number, 1);
  const catalogue::TemporaryFolder folder;
  const auto database = fresh(folder);
  ASSERT_TRUE(migrate(*database, migrations(), {}));
  Statement tables = database->sql(
      "SELECT count(*) FROM pragma_table_list WHERE type = 'table' AND strict = 0 AND name NOT "
      "LIKE 'sqlite_%'");
  int loose = -1;
  ASSERT_TRUE(tables.next());
  tables >> loose;
  EXPECT_EQ(loose, 0) << "all tables are STRICT";
}

}  // namespace
}  // namespace ostraka::store
