#include "upkeep/repair.h"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <random>

#include "records/sherd.h"
#include "sherds/sherd_fields.h"
#include "sherds/sherds.h"
#include "store/database.h"
#include "store/page_checksums.h"
#include "tests/core/catalogue/flipped_bits.h"
#include "tests/core/catalogue/small_project.h"

namespace ostraka::upkeep {
namespace {

namespace fs = std::filesystem;

class Repairing : public catalogue::SmallProject {
 protected:
  fs::path folder() const { return folder_.path() / "project"; }
  fs::path file() const { return folder() / "catalogue.sqlite"; }
  RepairReport repaired() {
    return catalogue::valueIn(
        repairCatalogue(folder(), quiet_, {}, [this] { return now_ms += 1; }));
  }
  // Pages whose bytes hold all these texts are overwritten as a failing disk does it.
  int destroyPagesWith(const std::vector<std::string>& texts) {
    std::string bytes = catalogue::bytesOf(file());
    std::mt19937_64 random(7);
    int destroyed = 0;
    for (std::size_t at = 0; at < bytes.size(); at += store::kPageBytes)
      if (std::all_of(texts.begin(), texts.end(),
                      [page = bytes.substr(at, store::kPageBytes)](const std::string& text) {
                        return page.find(text) != std::string::npos;
                      })) {
        for (std::size_t i = 0; i < store::kPageBytes; ++i)
          bytes[at + i] = static_cast<char>(random());
        ++destroyed;
      }
    catalogue::writeBytes(file(), bytes);
    return destroyed;
  }
  void fill(int sherds) {
    for (int i = 0; i < sherds; ++i) {
      const store::SherdRow sherd = numbered(context12);
      EXPECT_TRUE(set(sherd, "ware", "grey"));
      EXPECT_TRUE(set(sherd, "weight_g", std::to_string(5 + i)));
      EXPECT_TRUE(set(sherd, "note", std::string(60, 'n') + std::to_string(i)));
    }
  }
  QuietProgress quiet_;
};

TEST_F(Repairing, AWholeCatalogueIsLeftAsItIs) {
  fill(5);
  project_.reset();
  const std::string before = catalogue::bytesOf(file());
  const RepairReport report = repaired();
  EXPECT_TRUE(report.damaged.empty());
  EXPECT_EQ(catalogue::bytesOf(file()), before);
}

TEST_F(Repairing, AFlippedBitIsTurnedBackWithoutAnyBackup) {
  fill(30);
  project_.reset();
  const std::string content = *catalogue::contentOf(folder());
  std::string bytes = catalogue::bytesOf(file());
  for (const std::size_t page : {1, 4, 9}) bytes[page * store::kPageBytes + 3000] ^= 16;
  catalogue::writeBytes(file(), bytes);
  ASSERT_FALSE(catalogue::contentOf(folder()));
  const RepairReport report = repaired();
  EXPECT_EQ(report.pages_by_bit, 3);
  EXPECT_TRUE(report.backup.empty());
  EXPECT_TRUE(report.rows.empty());
  EXPECT_EQ(*catalogue::contentOf(folder()), content);
  EXPECT_EQ(catalogue::bytesOf(report.damaged), bytes) << "the damaged file is kept";
}

TEST_F(Repairing, RowsOfADestroyedPageComeFromTheBackupAndLaterChangesFromTheHistory) {
  fill(60);
  const store::SherdRow changed = *sherds::Sherds(catalogue()).byNumber("ARM1-T3-0012-0020");
  ASSERT_TRUE(set(changed, "vessel", "V20"));
  ASSERT_TRUE(project_->backUp());
  ASSERT_TRUE(set(changed, "ware", "red slipped"));
  ASSERT_TRUE(set(changed, "weight_g", "77.5"));
  const store::SherdRow untouched = numbered(context13);
  project_.reset();
  const std::string uuid = [&] {
    const Project open = catalogue::valueIn(Project::open(folder()));
    return sherds::Sherds(open.catalogue()).get(changed)->id;
  }();
  // The page with the sherd's own row, not those of its history.
  ASSERT_EQ(destroyPagesWith({"V20", uuid}), 1);
  ASSERT_FALSE(catalogue::contentOf(folder()));
  const RepairReport report = repaired();
  EXPECT_GT(report.pages_lost, 0);
  EXPECT_FALSE(report.all_from_backup);
  const Result<std::string> content = catalogue::contentOf(folder());
  ASSERT_TRUE(content) << content.error().sentence();
  const Project open = catalogue::valueIn(Project::open(folder()));
  const records::SherdRecord sherd = *sherds::Sherds(open.catalogue()).get(changed);
  EXPECT_EQ(sherd.id, uuid);
  EXPECT_EQ(sherd.number, "ARM1-T3-0012-0020");
  EXPECT_EQ(sherds::textOf(sherd, "vessel"), "V20");
  EXPECT_EQ(sherds::textOf(sherd, "ware"), "red slipped") << "as the history says";
  EXPECT_EQ(sherds::textOf(sherd, "weight_g"), "77.5");
  EXPECT_EQ(sherds::Sherds(open.catalogue()).get(untouched)->number, "ARM1-T3-0013-0001")
      << "newer than the backup";
  EXPECT_EQ(sherds::Sherds(open.catalogue()).rows({}, {})->size(), 61u);
  EXPECT_TRUE(std::any_of(report.rows.begin(), report.rows.end(), [&](const RepairedRow& row) {
    return row.table == "sherd" && row.row == changed.value &&
           row.from == RepairedRow::From::Backup && row.name == sherd.number;
  }));
  EXPECT_TRUE(std::none_of(report.rows.begin(), report.rows.end(), [](const RepairedRow& row) {
    return row.table == "sherd" && row.from == RepairedRow::From::Nowhere;
  }));
}

TEST_F(Repairing, AnySinglePageMayBeDestroyed) {
  fill(30);
  ASSERT_TRUE(project_->backUp());
  ASSERT_TRUE(set(*sherds::Sherds(catalogue()).byNumber("ARM1-T3-0012-0003"), "ware", "cooking"));
  const fs::path backup = project_->backups()[0];
  project_.reset();
  const std::string whole = catalogue::bytesOf(file()), good = catalogue::bytesOf(backup);
  std::mt19937_64 random(11);
  for (std::size_t at = 0; at < whole.size(); at += store::kPageBytes) {
    std::string bytes = whole;
    for (std::size_t i = 0; i < store::kPageBytes; ++i) bytes[at + i] = static_cast<char>(random());
    fs::remove_all(folder() / "backups");
    fs::create_directories(folder() / "backups");
    catalogue::writeBytes(backup, good);
    catalogue::writeBytes(file(), bytes);
    const Result<RepairReport> report = repairCatalogue(folder(), quiet_, {});
    ASSERT_TRUE(report) << "page " << at / store::kPageBytes + 1 << ": "
                        << report.error().sentence();
    const Result<std::string> content = catalogue::contentOf(folder());
    ASSERT_TRUE(content) << "page " << at / store::kPageBytes + 1 << ": "
                         << content.error().sentence();
    const Project open = catalogue::valueIn(Project::open(folder()));
    EXPECT_EQ(sherds::Sherds(open.catalogue()).rows({}, {})->size(), 30u)
        << "page " << at / store::kPageBytes + 1;
    for (const char* part : {"-wal", "-shm"}) fs::remove(file().string() + part);
  }
}

TEST_F(Repairing, AnEmptiedCatalogueIsMadeFromTheNewestBackupThatIsWhole) {
  fill(10);
  ASSERT_TRUE(project_->backUp());
  const std::string content = *catalogue::contentOf(catalogue().database());
  fill(1);
  const fs::path newest = *project_->backUp();
  project_.reset();
  fs::resize_file(file(), 0);
  catalogue::writeBytes(newest, std::string(8192, 'x'));
  const RepairReport report = repaired();
  EXPECT_TRUE(report.all_from_backup);
  EXPECT_NE(report.backup, newest);
  EXPECT_EQ(*catalogue::contentOf(folder()), content);
}

TEST_F(Repairing, WithoutAWholeBackupNothingIsChanged) {
  fill(5);
  project_.reset();
  fs::remove_all(folder() / "backups");
  const std::string bytes =
      catalogue::bytesOf(file()).substr(0, 3 * store::kPageBytes) + std::string(20000, 'x');
  catalogue::writeBytes(file(), bytes);
  const Result<RepairReport> report = repairCatalogue(folder(), quiet_, {});
  ASSERT_FALSE(report);
  EXPECT_NE(report.error().what.find("none of its backups is intact"), std::string::npos);
  EXPECT_EQ(catalogue::bytesOf(file()), bytes);
  for (const auto& entry : fs::directory_iterator(folder()))
    EXPECT_EQ(entry.path().string().find(".partial"), std::string::npos) << entry.path();
}

TEST_F(Repairing, AProjectThatAnotherProgramHasOpenIsNotRepaired) {
  fill(2);
  project_.reset();
  int ready[2];
  ASSERT_EQ(::pipe(ready), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    const Result<Project> open = Project::open(folder());
    const bool told = open && ::write(ready[1], "x", 1) == 1;
    ::pause();
    ::_exit(told ? 0 : 1);
  }
  char byte = 0;
  ASSERT_EQ(::read(ready[0], &byte, 1), 1);
  const Result<RepairReport> report = repairCatalogue(folder(), quiet_, {});
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  ::close(ready[0]);
  ::close(ready[1]);
  ASSERT_FALSE(report);
  EXPECT_NE(report.error().what.find("has this project open"), std::string::npos);
}

TEST_F(Repairing, PrefersItsOwnBackupToOneOfLater) {
  fill(3);
  fs::copy_file(*project_->backUp(), folder() / "backups/catalogue-20990101-100000-000.sqlite");
  fill(20);
  const fs::path newest = *project_->backUp();
  project_.reset();
  catalogue::writeBytes(file(), {});
  EXPECT_EQ(repaired().backup, newest);
}

// A stranger's view need never end: nothing is read through it.
TEST_F(Repairing, TakesAllFromTheBackupWhereTheTablesAreNotOurs) {
  fill(3);
  const fs::path backup = *project_->backUp();
  catalogue().database().script(
      "CREATE TABLE more AS SELECT * FROM project; PRAGMA foreign_keys = OFF; DROP TABLE project; "
      "CREATE VIEW project AS WITH RECURSIVE c(x) AS (SELECT 1 UNION ALL SELECT x + 1 FROM c) "
      "SELECT more.* FROM more WHERE (SELECT max(x) FROM c) > 0");
  project_.reset();
  ASSERT_FALSE(Project::open(folder()));
  const RepairReport report = repaired();
  EXPECT_EQ(report.backup, backup);
  EXPECT_TRUE(report.all_from_backup);
  EXPECT_TRUE(Project::open(folder()));
}

}  // namespace
}  // namespace ostraka::upkeep
