#include "upkeep/page_repair.h"

#include <gmock/gmock.h>

#include "store/page_checksums.h"
#include "tests/core/catalogue/flipped_bits.h"
#include "tests/core/catalogue/small_project.h"

namespace ostraka::upkeep {
namespace {

namespace fs = std::filesystem;
using store::kPageBytes;

class PageRepairs : public catalogue::SmallProject {
 protected:
  void SetUp() override {
    for (int i = 0; i < 20; ++i) numbered(context12);
    backup_ = *project_->backUp();
    const fs::path file = project_->folder() / "catalogue.sqlite";
    project_.reset();
    whole_ = catalogue::bytesOf(file);
    pages_ = static_cast<int>(whole_.size() / kPageBytes);
    ASSERT_GT(pages_, 10);
    // A page that has not changed since the backup.
    const std::string backed_up = catalogue::bytesOf(backup_);
    while (pageOf(whole_, same_) != pageOf(backed_up, same_)) ASSERT_LT(++same_, pages_);
  }
  // Of a copy that holds these bytes.
  PageRepair repaired(const std::string& bytes, const std::vector<fs::path>& backups) {
    catalogue::writeBytes(copy_, bytes);
    return catalogue::valueIn(repairPages(copy_, backups));
  }
  // number: from 1.
  static std::string pageOf(const std::string& bytes, int number) {
    return bytes.substr(static_cast<std::size_t>(number - 1) * kPageBytes, kPageBytes);
  }
  std::string withoutPage(int number) const {
    std::string bytes = whole_;
    return bytes.replace(static_cast<std::size_t>(number - 1) * kPageBytes, kPageBytes,
                         std::string(kPageBytes, '?'));
  }
  std::string withFlips(int number, const std::vector<std::size_t>& bytes_of_page) const {
    std::string bytes = whole_;
    for (const std::size_t byte : bytes_of_page)
      bytes[static_cast<std::size_t>(number - 1) * kPageBytes + byte] ^= 16;
    return bytes;
  }
  const fs::path copy_ = folder_.path() / "copy.sqlite";
  fs::path backup_;
  std::string whole_;
  int pages_ = 0, same_ = 3;
};

TEST_F(PageRepairs, LeaveAWholeFileAsItIs) {
  const PageRepair repair = repaired(whole_, {backup_});
  EXPECT_EQ(repair.pages, pages_);
  EXPECT_EQ(repair.by_bit + repair.by_backup, 0);
  EXPECT_TRUE(repair.lost.empty());
  EXPECT_FALSE(repair.wal_damaged);
  EXPECT_EQ(catalogue::bytesOf(copy_), whole_);
}

TEST_F(PageRepairs, TurnOneBitOfAPageBackWithoutABackup) {
  const PageRepair repair = repaired(withFlips(same_, {100}), {});
  EXPECT_EQ(repair.by_bit, 1);
  EXPECT_TRUE(repair.lost.empty());
  EXPECT_EQ(catalogue::bytesOf(copy_), whole_);
}

// The checksum of the damaged page says which page of a backup it was.
TEST_F(PageRepairs, TakeAPageWithMoreDamageFromABackupThatHasTheSameOne) {
  const std::string damaged = withFlips(same_, {100, 900});
  const PageRepair alone = repaired(damaged, {});
  EXPECT_THAT(alone.lost, testing::ElementsAre(same_));
  EXPECT_EQ(alone.by_bit, 0);
  const PageRepair repair = repaired(damaged, {backup_});
  EXPECT_EQ(repair.by_backup, 1);
  EXPECT_TRUE(repair.lost.empty());
  EXPECT_EQ(catalogue::bytesOf(copy_), whole_);
}

TEST_F(PageRepairs, NameAPageWhoseChecksumIsGoneThoughABackupIsThere) {
  EXPECT_THAT(repaired(withoutPage(4), {backup_}).lost, testing::ElementsAre(4));
}

TEST_F(PageRepairs, AddThePagesThatATruncatedFileLacks) {
  const PageRepair repair =
      repaired(whole_.substr(0, static_cast<std::size_t>(pages_ - 2) * kPageBytes + 100), {});
  EXPECT_EQ(repair.pages, pages_);
  EXPECT_THAT(repair.lost, testing::ElementsAre(pages_ - 1, pages_));
  EXPECT_EQ(fs::file_size(copy_), whole_.size());
}

TEST_F(PageRepairs, TakeTheSchemaOfABackupWhereTheFirstPageIsLost) {
  const PageRepair repair = repaired(withoutPage(1), {});
  ASSERT_THAT(repair.lost, testing::ElementsAre(1));
  const Result<bool> taken = takeSchemaPages(copy_, repair, backup_);
  ASSERT_TRUE(taken) << taken.error().sentence();
  EXPECT_TRUE(*taken);
  const auto database = store::Database::open(copy_, store::Database::Mode::ReadOnly);
  ASSERT_TRUE(database) << database.error().sentence();
  EXPECT_EQ((*database)->sql("SELECT count(*) FROM sherd").one<int>(), 20);
}

}  // namespace
}  // namespace ostraka::upkeep
