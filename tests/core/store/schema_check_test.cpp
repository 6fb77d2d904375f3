#include "store/schema_check.h"

#include <gmock/gmock.h>

#include "store/migrations.h"
#include "tests/core/catalogue/small_project.h"

namespace ostraka::store {
namespace {

namespace fs = std::filesystem;

// A catalogue of this version, changed by a stranger.
fs::path changed(const catalogue::TemporaryFolder& folder, std::size_t version,
                 const std::string& change) {
  const fs::path file = folder.path() / "catalogue.sqlite";
  for (const char* part : {"", "-wal", "-shm"}) fs::remove(file.string() + part);
  const auto database = std::move(*Database::open(file, Database::Mode::Create));
  const Result<void> made =
      migrate(*database, migrations().first(version), [] { return Result<void>(); });
  EXPECT_TRUE(made) << made.error().sentence();
  database->script(change);
  return file;
}

TEST(SchemaCheck, LetsEveryVersionPassThatThisProgramMade) {
  const catalogue::TemporaryFolder folder;
  for (std::size_t version = 1; version <= migrations().size(); ++version) {
    const Result<void> ours = checkSchema(changed(folder, version, ""));
    EXPECT_TRUE(ours) << version << ": " << ours.error().sentence();
  }
}

TEST(SchemaCheck, ReadsOverCommentsAndBlanksButNotWithinQuotes) {
  const catalogue::TemporaryFolder folder;
  const std::string trigger = "DROP TRIGGER history_stays; CREATE TRIGGER history_stays ";
  EXPECT_TRUE(checkSchema(
      changed(folder, migrations().size(),
              trigger + "/* worded anew */ BEFORE UPDATE ON history  -- as ever\n BEGIN SELECT "
                        "raise(ABORT, 'history is only added to'); END;")));
  EXPECT_FALSE(checkSchema(
      changed(folder, migrations().size(),
              trigger + "BEFORE UPDATE ON history BEGIN SELECT raise(ABORT, 'history  is only "
                        "added to'); END;")));
}

TEST(SchemaCheck, LeavesTheWordsOfTheFullTextsOwnTablesToSQLite) {
  const catalogue::TemporaryFolder folder;
  const auto worded = [&](const std::string& columns) {
    return checkSchema(changed(folder, migrations().size(),
                               "PRAGMA writable_schema = ON; UPDATE sqlite_schema SET sql = "
                               "'CREATE TABLE ''sherd_text_docsize''(" +
                                   columns + ")' WHERE name = 'sherd_text_docsize'"));
  };
  EXPECT_TRUE(worded("id INTEGER, sz BLOB, PRIMARY KEY (id)"));
  EXPECT_FALSE(worded("id INTEGER PRIMARY KEY, sz BLOB CHECK (randomblob(sz) <> sz)"));
  EXPECT_FALSE(worded("id INTEGER PRIMARY KEY, sz BLOB, more AS (randomblob(id))"));
}

TEST(SchemaCheck, RefusesWhatAStrangerMayHaveSQLiteRun) {
  const std::string endless = "(WITH RECURSIVE c(x) AS (SELECT 1 UNION ALL SELECT x + 1 FROM c) ";
  const std::vector<std::pair<std::string, std::string>> attacks = {
      {"trigger", "CREATE TRIGGER evil AFTER INSERT ON history BEGIN DELETE FROM file; END"},
      {"no trigger", "DROP TRIGGER given_number_is_kept"},
      {"view in place of a table",
       "ALTER TABLE setting RENAME TO other; CREATE VIEW setting AS SELECT key, value FROM other "
       "WHERE " +
           endless + "SELECT max(x) FROM c) > 0"},
      {"another view",
       "DROP VIEW sherd_terms; CREATE VIEW sherd_terms AS SELECT 1 AS sherd, '' AS "
       "field, '' AS term"},
      {"no view", "DROP VIEW sherd_words"},
      {"generated column", "ALTER TABLE site ADD COLUMN more TEXT AS (upper(name))"},
      {"check", "ALTER TABLE sherd ADD COLUMN more INTEGER CHECK (randomblob(more) <> '')"},
      {"index", "CREATE INDEX evil ON sherd (length(ware))"},
      {"another index", "DROP INDEX sherd_ware; CREATE INDEX sherd_ware ON sherd (upper(ware))"},
      {"search", "CREATE VIRTUAL TABLE evil USING fts5(words)"},
      {"no version", "PRAGMA user_version = -1"}};
  const catalogue::TemporaryFolder folder;
  for (const auto& [name, change] : attacks) {
    const Result<void> ours = checkSchema(changed(folder, migrations().size(), change));
    ASSERT_FALSE(ours) << name;
    EXPECT_EQ(ours.error().code, ErrorCode::UnusableInput) << name;
    EXPECT_THAT(ours.error().what, testing::HasSubstr("those that Ostraka creates")) << name;
  }
}

TEST(SchemaCheck, NamesThePartThatIsAnother) {
  const catalogue::TemporaryFolder folder;
  EXPECT_EQ(checkSchema(changed(folder, migrations().size(),
                                "CREATE TRIGGER evil AFTER INSERT ON history BEGIN SELECT 1; END"))
                .error()
                .where,
            "trigger evil");
  EXPECT_EQ(
      checkSchema(changed(folder, migrations().size(), "DROP VIEW sherd_words")).error().where,
      "view sherd_words");
}

}  // namespace
}  // namespace ostraka::store
