#include "store/database.h"

#include <gmock/gmock.h>

#include <fstream>

#include "store/file_header.h"
#include "store/values.h"
#include "tests/core/files/temporary_folder.h"

namespace ostraka::store {
namespace {

namespace fs = std::filesystem;

// A catalogue with one table of things.
class Databases : public testing::Test {
 protected:
  Databases() {
    open(Database::Mode::Create)
        ->script(
            "PRAGMA application_id = 1330861138; PRAGMA user_version = 1;"  // OSTR
            "CREATE TABLE thing (row INTEGER PRIMARY KEY, name TEXT NOT NULL UNIQUE) STRICT;"
            "CREATE TABLE part (thing INTEGER NOT NULL REFERENCES thing (row)) STRICT;");
    first_ = open(Database::Mode::ReadWrite);
  }
  std::unique_ptr<Database> open(Database::Mode mode, Waiting waiting = {}) const {
    Result<std::unique_ptr<Database>> opened = Database::open(file(), mode, std::move(waiting));
    EXPECT_TRUE(opened) << opened.error().sentence();
    return std::move(*opened);
  }
  fs::path file() const { return folder_.path() / "catalogue.sqlite"; }
  static void add(Database& database, const char* name) {
    database.run("INSERT INTO thing (name) VALUES (?)", name);
  }
  static std::vector<std::string> namesIn(Database& database) {
    return database.sql("SELECT name FROM thing ORDER BY name").all<std::string>();
  }
  TemporaryFolder folder_;
  std::unique_ptr<Database> first_;
};

TEST_F(Databases, ATransactionIsWholeOrNothing) {
  const Result<int> done = first_->inTransaction([&] {
    add(*first_, "rim");
    return 7;
  });
  EXPECT_EQ(*done, 7);
  const Result<void> refused = first_->inTransaction([&] {
    add(*first_, "base");
    throw Refused(Error::unusable("no base"));
  });
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::UnusableInput);
  EXPECT_FALSE(first_->inTransaction([&] {
    add(*first_, "base");
    add(*first_, "rim");  // is there already
  }));
  EXPECT_THAT(namesIn(*first_), testing::ElementsAre("rim"));
}

TEST_F(Databases, APartOfATransactionIsTakenBackAlone) {
  ASSERT_TRUE(first_->inTransaction([&] {
    add(*first_, "rim");
    EXPECT_FALSE(first_->inTransaction([&] {
      add(*first_, "base");
      add(*first_, "rim");
    }));
    EXPECT_TRUE(first_->inTransaction([&] { add(*first_, "neck"); }));
  }));
  EXPECT_THAT(namesIn(*first_), testing::ElementsAre("neck", "rim"));
}

TEST_F(Databases, ASnapshotIsOfOneMoment) {
  const auto second = open(Database::Mode::ReadWrite);
  add(*first_, "rim");
  ASSERT_TRUE(second->inSnapshot([&] {
    EXPECT_EQ(namesIn(*second).size(), 1u);
    add(*first_, "base");
    EXPECT_EQ(namesIn(*second).size(), 1u);
  }));
  EXPECT_EQ(namesIn(*second).size(), 2u);
}

// Whoever waits for a lock may give up.
TEST_F(Databases, AWriterWaitsForTheOtherUntilAStopIsRequested) {
  std::stop_source stop;
  const auto second = open(Database::Mode::ReadWrite, {stop.get_token(), nullptr});
  ASSERT_TRUE(first_->inTransaction([&] {
    stop.request_stop();
    const Result<void> waited = second->inTransaction([&] { add(*second, "rim"); });
    ASSERT_FALSE(waited);
    EXPECT_EQ(waited.error().code, ErrorCode::Cancelled);
  }));
  EXPECT_TRUE(second->inTransaction([&] { add(*second, "rim"); })) << "nobody is in its way";
}

TEST_F(Databases, ReferencesMustLeadSomewhere) {
  EXPECT_FALSE(first_->asResult([&] { first_->run("INSERT INTO part VALUES (99)"); }));
  add(*first_, "rim");
  EXPECT_TRUE(first_->asResult([&] {
    first_->run("INSERT INTO part VALUES (?)", first_->lastRow());
    EXPECT_EQ(first_->changes(), 1);
  }));
}

// As a query does that asks the same of each row that it finds.
TEST_F(Databases, OneTextMayBeReadWhileItIsBeingRead) {
  for (const char* name : {"base", "neck", "rim"}) add(*first_, name);
  const std::string text = "SELECT name FROM thing ORDER BY name";
  Statement outer = first_->sql(text);
  std::string name;
  int rows = 0;
  while (outer.read(name)) {
    ++rows;
    EXPECT_EQ(first_->sql(text).all<std::string>().size(), 3u);
  }
  EXPECT_EQ(rows, 3);
  EXPECT_EQ(name, "rim");
}

TEST_F(Databases, ReadOnlyOnesWriteNothing) {
  add(*first_, "rim");
  const auto reader = open(Database::Mode::ReadOnly);
  EXPECT_TRUE(reader->readOnly());
  EXPECT_THAT(namesIn(*reader), testing::ElementsAre("rim"));
  const Result<void> written = reader->asResult([&] { add(*reader, "base"); });
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().code, ErrorCode::CannotWrite);
}

TEST_F(Databases, ACopyIsOneFileWithAllThatWasSaved) {
  add(*first_, "rim");
  const fs::path copy = folder_.path() / "copy.sqlite";
  first_->copyTo(copy);
  EXPECT_FALSE(fs::exists(copy.string() + "-wal"));
  add(*first_, "base");
  const auto copied = Database::open(copy, Database::Mode::ReadOnly);
  ASSERT_TRUE(copied) << copied.error().sentence();
  EXPECT_THAT(namesIn(**copied), testing::ElementsAre("rim"));
  EXPECT_THROW(first_->copyTo(folder_.path() / "no folder" / "copy.sqlite"), Refused);
}

TEST_F(Databases, AreNotOpenedWhereNoneIsOrARepairIsToBeEnded) {
  EXPECT_FALSE(Database::open(folder_.path() / "none.sqlite", Database::Mode::ReadWrite));
  EXPECT_FALSE(Database::open(folder_.path() / "no folder/c.sqlite", Database::Mode::Create));
  std::ofstream(repairedBeside(file())) << "whole";
  const auto opened = Database::open(file(), Database::Mode::ReadWrite);
  ASSERT_FALSE(opened);
  EXPECT_EQ(opened.error().code, ErrorCode::Damaged);
}

}  // namespace
}  // namespace ostraka::store
