#include "store/page_checksums.h"

#include <sqlite3.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <set>
#include <vector>

#include "sherds/sherds.h"
#include "store/wal_content.h"
#include "tests/core/catalogue/flipped_bits.h"
#include "tests/core/catalogue/small_project.h"

namespace ostraka::store {
namespace {

namespace fs = std::filesystem;

class PageChecksums : public catalogue::SmallProject {
 protected:
  void fill(int sherds) {
    for (int i = 0; i < sherds; ++i) {
      const SherdRow sherd = i % 3 == 0 ? draft(context13, bag1) : numbered(context12);
      EXPECT_TRUE(set(sherd, "ware", i % 2 == 0 ? "grey" : "red slipped"));
      EXPECT_TRUE(set(sherd, "length_mm", std::to_string(20 + i)));
      EXPECT_TRUE(set(sherd, "note", "found beside the oven, number " + std::to_string(i)));
    }
  }
  fs::path folder() const { return folder_.path() / "project"; }
  fs::path file() const { return folder() / "catalogue.sqlite"; }
};

// What a process leaves that is killed after it has saved.
template <class Work>
void inAKilledProcess(Work work) {
  const pid_t child = ::fork();
  if (child == 0) {
    work();
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  ASSERT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
}

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

// As frames of a WAL tell it: which of them count.
WalContent walOf(const std::string& wal) {
  const ReadAt read = [&](unsigned char* to, std::size_t count, std::int64_t from) {
    const auto at = static_cast<std::size_t>(from);
    if (at + count > wal.size()) return false;
    std::copy_n(wal.begin() + from, count, to);
    return true;
  };
  return readWal(read, static_cast<std::int64_t>(wal.size()));
}

class DamagedWal : public PageChecksums {
 protected:
  // A few transactions in the WAL of a closed project.
  void SetUp() override {
    project_.reset();
    inAKilledProcess([&] {
      project_ = std::make_unique<upkeep::Project>(*upkeep::Project::open(folder()));
      fill(4);
    });
    main_ = catalogue::bytesOf(file());
    wal_ = catalogue::bytesOf(file().string() + "-wal");
    frames_ = walOf(wal_).frames;
    ASSERT_GT(frames_.size(), 20u);
    content_ = *catalogue::contentOf(folder());
  }
  Result<std::string> contentWith(const std::string& wal) {
    catalogue::writeBytes(file(), main_);
    catalogue::writeBytes(file().string() + "-wal", wal);
    fs::remove(file().string() + "-shm");
    return catalogue::contentOf(folder());
  }
  std::string walWithBitOf(std::size_t byte) const {
    std::string wal = wal_;
    wal[byte] ^= 4;
    return wal;
  }
  std::string main_, wal_, content_;
  std::vector<WalFrame> frames_;
};

TEST_F(DamagedWal, IsRefusedAndLeftAsItIs) {
  // Number of the page, size, salt, checksum, page and page's checksum; a whole WAL stands first.
  ASSERT_EQ(*contentWith(wal_), content_);
  for (std::size_t frame = 0; frame + 1 < frames_.size(); frame += 7)
    for (const int place : {-21, -17, -14, -3, 100, 4090}) {
      const auto byte = static_cast<std::size_t>(frames_[frame].at + place);
      const std::string wal = walWithBitOf(byte);
      const Result<std::string> content = contentWith(wal);
      ASSERT_FALSE(content) << "frame " << frame << ", byte " << place;
      EXPECT_EQ(content.error().code, ErrorCode::Damaged);
      EXPECT_EQ(catalogue::bytesOf(file().string() + "-wal"), wal);
    }
}

TEST_F(DamagedWal, IsRefusedForABitOfItsHeaderAndOfTheLastPage) {
  for (const std::size_t byte : {std::size_t{1}, std::size_t{17}, std::size_t{26},
                                 static_cast<std::size_t>(frames_.back().at) + 700}) {
    const Result<std::string> content = contentWith(walWithBitOf(byte));
    ASSERT_FALSE(content) << "byte " << byte;
    EXPECT_EQ(content.error().code, ErrorCode::Damaged);
  }
}

TEST_F(DamagedWal, IsRepairedWithoutAnyBackup) {
  fs::remove_all(folder() / "backups");
  for (const int place : {-21, -17, -14, -3, 100, 4090}) {
    const std::string wal = walWithBitOf(static_cast<std::size_t>(frames_[9].at + place));
    ASSERT_FALSE(contentWith(wal));
    QuietProgress quiet;
    const Result<upkeep::RepairReport> report = upkeep::repairCatalogue(folder(), quiet, {});
    ASSERT_TRUE(report) << report.error().sentence();
    EXPECT_EQ(catalogue::bytesOf(report->damaged.string() + "-wal"), wal) << "it is kept";
    EXPECT_EQ(*catalogue::contentOf(folder()), content_) << "byte " << place;
    fs::remove_all(folder() / "backups");
  }
}

// What a killed process or a power cut leaves of a transaction is not damage.
TEST_F(DamagedWal, IsNotOneThatEndsWithinATransaction) {
  const auto last = static_cast<std::size_t>(frames_.back().at);
  for (const std::size_t bytes : {last + 2000, last - 10, last - 24, last - 5000}) {
    EXPECT_TRUE(contentWith(wal_.substr(0, bytes)));
    EXPECT_TRUE(contentWith(wal_.substr(0, bytes) + std::string(20000, '\0')));
  }
  // The first frame of a transaction that was given up lies behind the saved ones.
  EXPECT_EQ(*contentWith(
                wal_ + wal_.substr(static_cast<std::size_t>(frames_[3].at) - 24, kPageBytes + 24)),
            content_);
}

// Disks write in any order: the end of what was being written may stand, and not all before it.
TEST_F(DamagedWal, IsNotOneWhoseLastTransactionLacksAFrame) {
  const auto withoutFrame = [&](std::size_t frame) {
    std::string wal = wal_;
    wal.replace(static_cast<std::size_t>(frames_[frame].at) - 24, kPageBytes + 24,
                std::string(kPageBytes + 24, '\0'));
    return wal;
  };
  std::vector<std::size_t> ends;  // frames that name the size of the database
  for (std::size_t i = 0; i < frames_.size(); ++i)
    if (wal_.substr(static_cast<std::size_t>(frames_[i].at) - 20, 4) != std::string(4, '\0'))
      ends.push_back(i);
  ASSERT_GT(ends.size(), 1u);
  const std::size_t first_of_last = ends[ends.size() - 2] + 1;
  ASSERT_LT(first_of_last, ends.back());
  const Result<std::string> cut_off = contentWith(withoutFrame(first_of_last));
  ASSERT_TRUE(cut_off) << cut_off.error().sentence();
  EXPECT_NE(*cut_off, content_);
  const Result<std::string> lost = contentWith(withoutFrame(first_of_last - 2));
  ASSERT_FALSE(lost);
  EXPECT_EQ(lost.error().code, ErrorCode::Damaged);
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
