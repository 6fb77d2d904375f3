#include "store/page_checksums.h"

#include <sqlite3.h>

#include <set>
#include <vector>

#include "tests/core/catalogue/flipped_bits.h"
#include "tests/core/store/filled_project.h"

namespace ostraka::store {
namespace {

namespace fs = std::filesystem;

using PageChecksums = FilledProject;

// As any program that knows SQLite opens it.
std::string askedOfPlainSqlite(const fs::path& file, const char* sql) {
  sqlite3* database = nullptr;
  std::string answer;
  const auto collect = [](void* to, int count, char** values, char**) {
    for (int i = 0; i < count; ++i) *static_cast<std::string*>(to) += values[i] ? values[i] : "";
    return 0;
  };
  char* error = nullptr;
  if (sqlite3_open(file.c_str(), &database) != SQLITE_OK ||
      sqlite3_exec(database, sql, collect, &answer, &error) != SQLITE_OK)
    answer = std::string("error: ") + (error ? error : "cannot be opened");
  sqlite3_free(error);
  sqlite3_close(database);
  return answer;
}

TEST_F(PageChecksums, EachPageOfTheFileCarriesItsOwn) {
  fill(30);
  project_.reset();
  const std::string bytes = catalogue::bytesOf(file());
  ASSERT_GT(bytes.size(), 20 * kPageBytes);
  ASSERT_EQ(bytes.size() % kPageBytes, 0u);
  for (std::size_t at = 0; at < bytes.size(); at += kPageBytes)
    EXPECT_TRUE(isWholePage(reinterpret_cast<const unsigned char*>(bytes.data()) + at,
                            static_cast<std::uint32_t>(at / kPageBytes) + 1))
        << "page " << at / kPageBytes + 1;
}

TEST_F(PageChecksums, AreNotThoseOfAnotherPageOrOfAnEmptyOne) {
  std::vector<unsigned char> page(kPageBytes, 0);
  EXPECT_FALSE(isWholePage(page.data(), 1)) << "a page that was never written";
  page[7] = 3;
  storeChecksum(page.data(), 5);
  EXPECT_TRUE(isWholePage(page.data(), 5));
  EXPECT_FALSE(isWholePage(page.data(), 6)) << "written to the wrong place";
}

// A repair turns back the one bit that fits, so no two may fit.
TEST_F(PageChecksums, AreOthersForEachFlippedBit) {
  std::mt19937_64 random(3);
  for (std::uint32_t number = 1; number <= 12; ++number) {
    std::vector<unsigned char> page(kPageBytes, 0);
    for (std::size_t i = 0; number > 1 && i < kPageBytes - kReservedBytes; ++i)
      page[i] = static_cast<unsigned char>(random());
    std::set<std::uint64_t> sums = {pageChecksum(page.data(), number)};
    for (std::size_t bit = 0; bit < 8 * (kPageBytes - kReservedBytes); ++bit) {
      page[bit / 8] ^= static_cast<unsigned char>(1 << bit % 8);
      sums.insert(pageChecksum(page.data(), number));
      page[bit / 8] ^= static_cast<unsigned char>(1 << bit % 8);
    }
    EXPECT_EQ(sums.size(), 1 + 8 * (kPageBytes - kReservedBytes)) << "page " << number;
  }
}

TEST_F(PageChecksums, NoFlippedBitIsAcceptedWithAnotherContent) {
  fill(40);
  project_.reset();
  const catalogue::Flips flips = catalogue::flipBits(folder(), 300, 20261124, 10);
  EXPECT_EQ(flips.accepted, 0);
  EXPECT_GT(flips.found, 270) << "pages that nothing uses are few";
  EXPECT_EQ(flips.not_restored, 0);
  EXPECT_GT(flips.restored, 25);
}

TEST_F(PageChecksums, EveryBitOfTheHeaderIsGuarded) {
  fill(3);
  project_.reset();
  const std::string content = *catalogue::contentOf(folder());
  const std::string whole = catalogue::bytesOf(file());
  for (std::size_t bit = 0; bit < 100 * 8; ++bit) {
    std::string bytes = whole;
    bytes[bit / 8] ^= static_cast<char>(1 << bit % 8);
    catalogue::writeBytes(file(), bytes);
    EXPECT_FALSE(upkeep::Project::open(folder())) << "bit " << bit % 8 << " of byte " << bit / 8;
  }
  catalogue::writeBytes(file(), whole);
  EXPECT_EQ(*catalogue::contentOf(folder()), content);
}

TEST_F(PageChecksums, ATruncatedFileIsRefused) {
  fill(30);
  project_.reset();
  fs::resize_file(file(), fs::file_size(file()) - kPageBytes);
  EXPECT_FALSE(catalogue::contentOf(folder()));
}

TEST_F(PageChecksums, WhatAKilledProcessSavedIsThere) {
  project_.reset();
  inAKilledProcess([&] {
    project_ = std::make_unique<upkeep::Project>(*upkeep::Project::open(folder()));
    fill(30);
  });
  ASSERT_GT(fs::file_size(file().string() + "-wal"), 0u) << "nothing was tried";
  const Result<upkeep::Project> again = upkeep::Project::open(folder());
  ASSERT_TRUE(again) << again.error().sentence();
  EXPECT_EQ(sherds::Sherds(again->catalogue()).rows({}, {})->size(), 30u);
  EXPECT_TRUE(again->catalogue().checkIntegrity());
}

TEST_F(PageChecksums, AnotherSqliteReadsItAndFinishesWhatAKilledProcessLeft) {
  project_.reset();
  inAKilledProcess([&] {
    project_ = std::make_unique<upkeep::Project>(*upkeep::Project::open(folder()));
    fill(30);
  });
  EXPECT_EQ(askedOfPlainSqlite(file(), "SELECT count(*) FROM sherd; PRAGMA integrity_check"),
            "30ok");
  EXPECT_FALSE(fs::exists(file().string() + "-wal")) << "it was not written into the file";
  const Result<std::string> content = catalogue::contentOf(folder());
  EXPECT_TRUE(content) << content.error().sentence();
}

TEST_F(PageChecksums, WhatAnotherProgramChangedIsFound) {
  fill(3);
  project_.reset();
  EXPECT_EQ(askedOfPlainSqlite(file(), "UPDATE sherd SET ware = 'other'"), "");
  const Result<std::string> content = catalogue::contentOf(folder());
  ASSERT_FALSE(content);
  EXPECT_EQ(content.error().code, ErrorCode::Damaged);
}

TEST_F(PageChecksums, AFileThatWasReplacedIsNotReadAnyMore) {
  const fs::path copy = *project_->backUp();
  const auto database = *Database::open(copy, Database::Mode::ReadOnly);
  const auto rows = [&] {
    return database->asResult([&] { return database->sql("SELECT row FROM site").next(); });
  };
  ASSERT_TRUE(rows());
  fs::copy_file(copy, copy.string() + ".new");
  fs::rename(copy.string() + ".new", copy);
  const Result<bool> after = rows();
  ASSERT_FALSE(after);
  EXPECT_EQ(after.error().code, ErrorCode::Failed);
}

TEST_F(PageChecksums, ManyWritersAtOnceLeaveAWholeFile) {
  project_.reset();
  std::vector<pid_t> writers;
  for (int writer = 0; writer < 4; ++writer) {
    const pid_t child = ::fork();
    if (child == 0) {
      project_ = std::make_unique<upkeep::Project>(*upkeep::Project::open(folder()));
      bool all = true;
      for (int i = 0; i < 40; ++i)
        all = sherds::Sherds(catalogue()).add({}, anna).has_value() && all;
      if (writer % 2 == 0) project_.reset();
      ::_exit(all ? 0 : 1);
    }
    writers.push_back(child);
  }
  for (const pid_t writer : writers) {
    int status = 0;
    ::waitpid(writer, &status, 0);
    EXPECT_EQ(status, 0);
  }
  const Result<upkeep::Project> again = upkeep::Project::open(folder());
  ASSERT_TRUE(again) << again.error().sentence();
  EXPECT_EQ(sherds::Sherds(again->catalogue()).rows({}, {})->size(), 160u);
  const Result<void> whole = again->catalogue().checkIntegrity();
  EXPECT_TRUE(whole) << whole.error().sentence();
}

}  // namespace
}  // namespace ostraka::store
