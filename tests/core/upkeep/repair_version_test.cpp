// A repair by an older Ostraka leaves the catalogue of a newer one alone.
#include <sys/wait.h>
#include <unistd.h>

#include <map>

#include "store/database.h"
#include "store/page_checksums.h"
#include "tests/core/catalogue/flipped_bits.h"
#include "tests/core/catalogue/small_project.h"
#include "upkeep/repair.h"

namespace ostraka::upkeep {
namespace {

namespace fs = std::filesystem;

class RepairVersion : public catalogue::SmallProject {
 protected:
  fs::path folder() const { return folder_.path() / "project"; }
  fs::path file() const { return folder() / "catalogue.sqlite"; }
  static void makeNewer(const fs::path& catalogue) {
    const auto database =
        catalogue::valueIn(store::Database::open(catalogue, store::Database::Mode::ReadWrite));
    database->script(
        "CREATE TABLE newer_thing(a TEXT) STRICT; INSERT INTO newer_thing VALUES('work'); "
        "PRAGMA user_version = 99");
  }
  void destroyPage(std::size_t number) const {
    std::string bytes = catalogue::bytesOf(file());
    ASSERT_GE(bytes.size(), number * store::kPageBytes);
    std::mt19937_64 random(7);
    for (std::size_t i = 0; i < store::kPageBytes; ++i)
      bytes[(number - 1) * store::kPageBytes + i] = static_cast<char>(random());
    catalogue::writeBytes(file(), bytes);
  }
  std::map<std::string, std::string> content() const {
    std::map<std::string, std::string> all;
    for (const auto& entry : fs::recursive_directory_iterator(folder()))
      if (entry.is_regular_file()) all[entry.path().string()] = catalogue::bytesOf(entry.path());
    return all;
  }
  void expectRefused() {
    const std::map<std::string, std::string> before = content();
    const Result<RepairReport> report = repairCatalogue(folder(), quiet_, {});
    ASSERT_FALSE(report);
    EXPECT_EQ(report.error().code, ErrorCode::UnusableInput);
    EXPECT_NE(report.error().what.english().find("A newer Ostraka made this project (catalogue "
                                                 "version 99"),
              std::string::npos)
        << report.error().sentence();
    EXPECT_EQ(report.error().where, file().string());
    EXPECT_TRUE(content() == before) << "a file was changed";
  }
  QuietProgress quiet_;
};

TEST_F(RepairVersion, ANewerCatalogueThatIsWholeIsRefusedAsByOpening) {
  project_.reset();
  makeNewer(file());
  const Result<Project> opened = Project::open(folder());
  ASSERT_FALSE(opened);
  expectRefused();
  EXPECT_EQ(repairCatalogue(folder(), quiet_, {}).error().what, opened.error().what);
}

TEST_F(RepairVersion, ANewerCatalogueThatIsDamagedDoesNotBecomeAnOlderBackup) {
  ASSERT_TRUE(project_->backUp());
  numbered(context12);
  project_.reset();
  makeNewer(file());
  destroyPage(5);
  expectRefused();
}

TEST_F(RepairVersion, OneFlippedBitInTheFirstPageDoesNotHideTheVersion) {
  ASSERT_TRUE(project_->backUp());
  project_.reset();
  makeNewer(file());
  std::string bytes = catalogue::bytesOf(file());
  bytes[63] ^= 64;  // its bytes say 35
  catalogue::writeBytes(file(), bytes);
  expectRefused();
}

TEST_F(RepairVersion, TheWalOfAKilledProcessTellsTheVersion) {
  ASSERT_TRUE(project_->backUp());
  project_.reset();
  const pid_t child = ::fork();
  if (child == 0) {
    const auto database = store::Database::open(file(), store::Database::Mode::ReadWrite);
    (*database)->script("PRAGMA user_version = 99");
    ::_exit(0);
  }
  ::waitpid(child, nullptr, 0);
  ASSERT_GT(fs::file_size(file().string() + "-wal"), 0u);
  destroyPage(5);
  expectRefused();
}

TEST_F(RepairVersion, AnInterruptedRepairOfANewerProgramIsLeftToIt) {
  project_.reset();
  fs::copy_file(file(), file().string() + ".repaired");
  makeNewer(file().string() + ".repaired");
  expectRefused();
}

TEST_F(RepairVersion, ANewerBackupTellsItWhereTheCatalogueDoesNot) {
  ASSERT_TRUE(project_->backUp());
  numbered(context12);
  makeNewer(*project_->backUp());
  project_.reset();
  destroyPage(1);
  expectRefused();
}

TEST_F(RepairVersion, TheReportSaysThatTheVersionCouldNotBeRead) {
  numbered(context12);
  const fs::path backup = *project_->backUp();
  project_.reset();
  destroyPage(5);
  EXPECT_TRUE(catalogue::valueIn(repairCatalogue(folder(), quiet_, {})).warning.empty());
  destroyPage(1);
  const RepairReport report = catalogue::valueIn(repairCatalogue(folder(), quiet_, {}));
  EXPECT_NE(
      report.warning.english().find("relies on the backup " + report.backup.filename().string()),
      std::string::npos)
      << report.warning;
  EXPECT_TRUE(Project::open(folder()));
}

TEST_F(RepairVersion, WithoutBackupsNothingIsDoneWhereTheVersionCannotBeRead) {
  project_.reset();
  fs::remove_all(folder() / "backups");
  destroyPage(1);
  const std::map<std::string, std::string> before = content();
  const Result<RepairReport> report = repairCatalogue(folder(), quiet_, {});
  ASSERT_FALSE(report);
  EXPECT_EQ(report.error().code, ErrorCode::Damaged);
  EXPECT_TRUE(content() == before);
}

}  // namespace
}  // namespace ostraka::upkeep
