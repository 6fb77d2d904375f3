#include "upkeep/repair.h"

#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <random>
#include <utility>

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
  // Its exit status; it ends without closing anything, as a killed one does.
  template <class Work>
  static int inAnotherProcess(Work work) {
    const pid_t child = ::fork();
    if (child == 0) ::_exit(work());
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  // Saves more sherds and leaves them in the WAL.
  void fillInAKilledProcess(int sherds) {
    ASSERT_EQ(inAnotherProcess([&] {
                project_ = std::make_unique<Project>(*Project::open(folder()));
                fill(sherds);
                return 0;
              }),
              0);
    ASSERT_GT(fs::file_size(file().string() + "-wal"), 0u);
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

TEST_F(Repairing, WhatLeadsOutsideTheProjectIsRefusedAsByOpening) {
  newBatch({bag4});
  fill(2);
  ASSERT_TRUE(project_->backUp());
  catalogue().database().script("UPDATE sherd SET model_path = '../../elsewhere/model.ply'");
  project_.reset();
  const std::string before = catalogue::bytesOf(file());
  const Result<Project> opened = Project::open(folder());
  const Result<RepairReport> repaired = repairCatalogue(folder(), quiet_, {});
  ASSERT_FALSE(opened);
  ASSERT_FALSE(repaired);
  EXPECT_EQ(repaired.error().sentence(), opened.error().sentence());
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
  EXPECT_NE(report.error().what.english().find("none of its backups is intact"), std::string::npos);
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
  EXPECT_NE(report.error().what.english().find("has this project open"), std::string::npos);
}

// A damaged catalogue with a backup, and later transactions in the WAL of a killed process.
class KilledRepair : public Repairing {
 protected:
  void SetUp() override {
    fill(60);
    ASSERT_TRUE(project_->backUp());
    const store::SherdRow changed = *sherds::Sherds(catalogue()).byNumber("ARM1-T3-0012-0003");
    const std::string uuid = sherds::Sherds(catalogue()).get(changed)->id;
    ASSERT_TRUE(set(changed, "vessel", "V3"));
    project_.reset();
    const int status = inAnotherProcess([&] {
      project_ = std::make_unique<Project>(*Project::open(folder()));
      numbered(context13);
      return 0;
    });
    ASSERT_EQ(status, 0);
    ASSERT_EQ(destroyPagesWith({"V3", uuid}), 1);
    ASSERT_TRUE(fs::exists(file().string() + "-wal"));
    fs::copy(folder(), damaged_, fs::copy_options::recursive);
  }
  void damageAgain() const {
    fs::remove_all(folder());
    fs::copy(damaged_, folder(), fs::copy_options::recursive);
  }
  std::size_t sherds() const {
    const Project open = catalogue::valueIn(Project::open(folder()));
    EXPECT_TRUE(open.catalogue().checkIntegrity());
    return sherds::Sherds(open.catalogue()).rows({}, {})->size();
  }
  const fs::path damaged_ = folder_.path() / "damaged";
};

TEST_F(KilledRepair, IsEndedByTheNextOnceTheRepairedFileIsReady) {
  repaired();
  const std::string made = catalogue::bytesOf(file());
  for (const bool wal_is_left : {true, false}) {
    const auto kill = [&] {  // before or after it removed the WAL
      catalogue::writeBytes(file(), catalogue::bytesOf(damaged_ / "catalogue.sqlite"));
      const std::string wal = file().string() + "-wal";
      fs::remove(wal);
      if (wal_is_left) fs::copy_file(damaged_ / "catalogue.sqlite-wal", wal);
      catalogue::writeBytes(file().string() + ".repaired", made);
    };
    kill();
    const Result<Project> open = Project::open(folder());
    ASSERT_FALSE(open);
    EXPECT_EQ(open.error().code, ErrorCode::Damaged);
    kill();
    const RepairReport report = repaired();
    EXPECT_TRUE(report.interrupted);
    EXPECT_TRUE(fs::exists(report.damaged)) << report.damaged;
    EXPECT_EQ(catalogue::bytesOf(file()), made);
    EXPECT_FALSE(fs::exists(file().string() + "-wal"));
    EXPECT_FALSE(fs::exists(file().string() + ".repaired"));
    EXPECT_EQ(sherds(), 61u);
  }
}

TEST_F(KilledRepair, LosesNothingWhereverTheRepairReadsTheClock) {
  int readings = 0;
  ASSERT_TRUE(repairCatalogue(folder(), quiet_, {}, [&] { return now_ms + ++readings; }));
  ASSERT_EQ(sherds(), 61u);
  for (int last = std::max(1, readings - 4); last <= readings; ++last) {
    damageAgain();
    const int status = inAnotherProcess([&] {
      int read = 0;
      const auto clock = [&]() -> std::int64_t {
        if (++read == last) ::_exit(9);
        return now_ms + read;
      };
      return repairCatalogue(folder(), quiet_, {}, clock) ? 0 : 1;
    });
    ASSERT_EQ(status, 9) << last;
    const Result<RepairReport> again = repairCatalogue(folder(), quiet_, {});
    ASSERT_TRUE(again) << again.error().sentence();
    EXPECT_EQ(sherds(), 61u) << last;
  }
}

TEST_F(KilledRepair, ARepairedFileThatIsNotWholeIsSetAside) {
  catalogue::writeBytes(file().string() + ".repaired", std::string(8192, 'x'));
  ASSERT_FALSE(Project::open(folder()));
  const RepairReport report = repaired();
  EXPECT_FALSE(report.interrupted);
  EXPECT_FALSE(fs::exists(file().string() + ".repaired"));
  EXPECT_EQ(sherds(), 61u);
}

TEST_F(KilledRepair, LeavesTheCatalogueThatSomebodyPutBackSince) {
  repaired();
  const std::string made = catalogue::bytesOf(file());
  project_ = std::make_unique<Project>(*Project::open(folder()));
  numbered(context13);
  project_.reset();
  catalogue::writeBytes(file().string() + ".repaired", made);
  const RepairReport report = repaired();
  EXPECT_FALSE(report.interrupted);
  EXPECT_FALSE(fs::exists(file().string() + ".repaired"));
  EXPECT_EQ(sherds(), 62u);
}

TEST_F(KilledRepair, TakesNoLinkForTheCatalogue) {
  // Its WAL lies beside what the link leads to and would be left out.
  fs::rename(file(), folder_.path() / "elsewhere.sqlite");
  fs::rename(file().string() + "-wal", folder_.path() / "elsewhere.sqlite-wal");
  fs::create_symlink(folder_.path() / "elsewhere.sqlite", file());
  const Result<RepairReport> report = repairCatalogue(folder(), quiet_, {});
  ASSERT_FALSE(report);
  EXPECT_EQ(report.error().code, ErrorCode::UnusableInput);
  EXPECT_TRUE(fs::is_symlink(file()));
}

// Who asks to open it meanwhile waits and is refused, or comes after it; no saved sherd is lost.
TEST_F(KilledRepair, NobodyWritesWhileItRuns) {
  int go[2], saved[2];
  ASSERT_EQ(::pipe(go), 0);
  ASSERT_EQ(::pipe(saved), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    char byte = 0;
    bool added = ::read(go[0], &byte, 1) == 1;
    {
      Result<Project> open = Project::open(folder());
      added = added && open && sherds::Sherds(open->catalogue()).add({}, anna).has_value();
    }
    if (added) added = ::write(saved[1], "x", 1) == 1;
    ::_exit(added ? 0 : 1);
  }
  bool saved_meanwhile = false, told = false;
  const Result<RepairReport> report = repairCatalogue(folder(), quiet_, {}, [&] {
    if (!std::exchange(told, true)) {  // it has copied the damaged file
      EXPECT_EQ(::write(go[1], "x", 1), 1);
      struct pollfd answer {
        saved[0], POLLIN, 0
      };
      saved_meanwhile = ::poll(&answer, 1, 700) == 1;
    }
    return now_ms += 1;
  });
  int status = -1;
  ::waitpid(child, &status, 0);
  for (const int end : {go[0], go[1], saved[0], saved[1]}) ::close(end);
  ASSERT_TRUE(report) << report.error().sentence();
  EXPECT_FALSE(saved_meanwhile);
  EXPECT_EQ(sherds(), WIFEXITED(status) && WEXITSTATUS(status) == 0 ? 62u : 61u);
}

TEST_F(Repairing, WhatFollowsADamagedPageOfTheWalIsKept) {
  project_.reset();
  fillInAKilledProcess(4);
  const fs::path wal = file().string() + "-wal";
  const std::string main = catalogue::bytesOf(file()), whole = catalogue::bytesOf(wal);
  const std::string content = *catalogue::contentOf(folder());
  // A page that a later transaction saved again, and more than one bit of it.
  const std::size_t frame = store::kPageBytes + 24, frames = (whole.size() - 32) / frame;
  const auto pageOf = [&](std::size_t i) { return whole.substr(32 + i * frame, 4); };
  std::size_t damaged = frames / 4;
  const auto isSavedAgain = [&] {
    for (std::size_t i = damaged + 1; i < frames; ++i)
      if (pageOf(i) == pageOf(damaged)) return true;
    return false;
  };
  while (damaged < frames && !isSavedAgain()) ++damaged;
  ASSERT_LT(damaged, frames);
  std::string bytes = whole;
  for (std::size_t i = 100; i < 140; ++i) bytes[32 + damaged * frame + 24 + i] ^= 0x5A;
  catalogue::writeBytes(file(), main);
  catalogue::writeBytes(wal, bytes);
  ASSERT_FALSE(catalogue::contentOf(folder()));
  const RepairReport report = repaired();
  EXPECT_EQ(*catalogue::contentOf(folder()), content);
  EXPECT_EQ(catalogue::bytesOf(report.damaged.string() + "-wal"), bytes) << "it is kept";
}

TEST_F(Repairing, TakesTheWalOfAKilledProcessFromABackupThatWasPutBack) {
  fill(4);
  const fs::path backup = *project_->backUp();
  const std::string content = *catalogue::contentOf(folder());
  fill(2);
  project_.reset();
  fillInAKilledProcess(3);
  fs::copy_file(backup, file(), fs::copy_options::overwrite_existing);
  const std::string put_back = catalogue::bytesOf(file());
  const std::string wal = catalogue::bytesOf(file().string() + "-wal");
  const Result<Project> open = Project::open(folder());
  ASSERT_FALSE(open);
  EXPECT_EQ(open.error().code, ErrorCode::Damaged);
  EXPECT_NE(open.error().what.english().find("it is a backup"), std::string::npos)
      << open.error().what;
  EXPECT_FALSE(store::Database::open(file(), store::Database::Mode::ReadOnly));
  EXPECT_EQ(catalogue::bytesOf(file()), put_back);
  const RepairReport report = repaired();
  ASSERT_EQ(report.rows.size(), 1u);
  EXPECT_EQ(report.rows[0].table, "catalogue.sqlite-wal");
  EXPECT_EQ(report.rows[0].from, RepairedRow::From::Nowhere);
  EXPECT_EQ(catalogue::bytesOf(report.damaged.string() + "-wal"), wal) << "it is kept";
  EXPECT_EQ(*catalogue::contentOf(folder()), content);
  EXPECT_TRUE(repaired().damaged.empty());
}

TEST_F(Repairing, LosesNothingThatAKilledProcessSavedInABackupThatWasPutBack) {
  fill(4);
  const fs::path backup = *project_->backUp();
  project_.reset();
  fs::copy_file(backup, file(), fs::copy_options::overwrite_existing);
  fillInAKilledProcess(3);
  EXPECT_TRUE(repaired().damaged.empty());
  const Result<Project> open = Project::open(folder());
  ASSERT_TRUE(open) << open.error().sentence();
  EXPECT_EQ(sherds::Sherds(open->catalogue()).rows({}, {})->size(), 7u);
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
