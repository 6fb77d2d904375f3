// Files that are no catalogue of a project, and the copies that must outlive them.
#include <fstream>

#include "flipped_bits.h"
#include "records/records.h"
#include "small_project.h"
#include "store/database.h"

namespace ostraka::catalogue {
namespace {

namespace fs = std::filesystem;

class RefusedFiles : public SmallProject {
 protected:
  fs::path folder() const { return folder_.path() / "project"; }
  fs::path file() const { return folder() / "catalogue.sqlite"; }
  void expectRefused(const char* why) {
    const Result<upkeep::Project> opened = upkeep::Project::open(folder());
    ASSERT_FALSE(opened) << why;
    EXPECT_EQ(opened.error().code, ErrorCode::Damaged) << opened.error().sentence();
    EXPECT_NE(opened.error().what.english().find(why), std::string::npos)
        << opened.error().sentence();
    EXPECT_NE(opened.error().what.english().find("catalogue repair"), std::string::npos);
    EXPECT_FALSE(upkeep::Project::connect(folder())) << why;
  }
};

TEST_F(RefusedFiles, AnEmptiedCatalogueStaysRefusedAndItsBackupsStay) {
  for (int i = 0; i < 30; ++i) numbered(context12);
  for (int i = 0; i < 5; ++i) ASSERT_TRUE(project_->backUp());
  const std::vector<fs::path> good = project_->backups();
  project_.reset();
  fs::resize_file(file(), 0);
  for (int i = 0; i < 21; ++i) {
    expectRefused("the file is empty");
    EXPECT_EQ(fs::file_size(file()), 0u) << "no schema is made in it";
  }
  for (const fs::path& backup : good) EXPECT_TRUE(fs::exists(backup)) << backup;
}

TEST_F(RefusedFiles, EmptiedUnderAnOpenProjectItTakesNoGoodBackupAway) {
  for (int i = 0; i < 30; ++i) numbered(context12);
  ASSERT_TRUE(project_->backUp());
  const fs::path good = project_->backups()[0];
  const std::string bytes = bytesOf(good);
  fs::resize_file(file(), 0);
  for (int i = 0; i < 21; ++i)
    EXPECT_FALSE(project_->backUp()) << "what is in memory is not the file";
  EXPECT_EQ(bytesOf(good), bytes);
}

TEST_F(RefusedFiles, ACatalogueWithoutAProjectIsRefused) {
  catalogue().database().script("DELETE FROM project");
  project_.reset();
  expectRefused("it contains no project");
}

TEST_F(RefusedFiles, AFileThatNobodyMadeACatalogueOfIsRefused) {
  project_.reset();
  fs::remove(file());
  store::Database::open(file(), store::Database::Mode::Create)
      .value()
      ->script("PRAGMA application_id = 1330861138");
  expectRefused("the file contains no catalogue");
}

TEST_F(RefusedFiles, TheFileOfAnotherProgramIsRefused) {
  project_.reset();
  fs::remove(file());
  store::Database::open(file(), store::Database::Mode::Create)
      .value()
      ->script("CREATE TABLE song (name TEXT); PRAGMA user_version = 1; PRAGMA application_id = 7");
  expectRefused("the file belongs to another program");
}

TEST_F(RefusedFiles, TextIsNoDatabase) {
  project_.reset();
  std::ofstream(file()) << std::string(5000, 'x');
  expectRefused("the file is not a database");
}

// Nothing is ever deleted from a catalogue: one that shrank lost something.
TEST_F(RefusedFiles, BackupsOfAMuchLargerCatalogueNeverMakeRoom) {
  for (int i = 0; i < 200; ++i) numbered(context12);
  const fs::path large = *project_->backUp();
  project_.reset();
  fs::remove(file());
  records::ProjectRecord record;
  record.code = "NEW";
  for (const char* name : {"batches", "results"}) fs::remove_all(folder() / name);
  ASSERT_TRUE(upkeep::Project::create(folder_.path() / "other", record));
  fs::copy_file(folder_.path() / "other/catalogue.sqlite", file());
  upkeep::Project small = valueIn(upkeep::Project::open(folder()));
  for (int i = 0; i < 25; ++i) ASSERT_TRUE(small.backUp(3, 0));
  EXPECT_TRUE(fs::exists(large));
  EXPECT_EQ(small.backups().size(), 4u);
}

TEST_F(RefusedFiles, AFileWithALaterTimeNeitherStopsBackupsNorTakesTheirPlace) {
  fs::create_directories(folder() / "backups");
  for (int i = 0; i < 4; ++i)
    std::ofstream(folder() / "backups" /
                  ("catalogue-99990101-000000-00" + std::to_string(i) + ".sqlite"))
        << "x";
  EXPECT_EQ(*project_->backUpIfChanged(std::chrono::milliseconds(0)), true);
  const Result<fs::path> made = project_->backUp(2, 0);
  ASSERT_TRUE(made);
  EXPECT_TRUE(fs::exists(*made)) << "the one that was read back stays";
}

}  // namespace
}  // namespace ostraka::catalogue
