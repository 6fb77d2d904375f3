// Which backup a repair begins with.
#include "catalogue/files.h"
#include "catalogue/history.h"
#include "catalogue/settings.h"
#include "tests/core/catalogue/flipped_bits.h"
#include "tests/core/catalogue/small_project.h"
#include "upkeep/backups.h"
#include "upkeep/repair.h"

namespace ostraka::upkeep {
namespace {

namespace fs = std::filesystem;

class RepairBase : public catalogue::SmallProject {
 protected:
  fs::path folder() const { return folder_.path() / "project"; }
  fs::path file() const { return folder() / "catalogue.sqlite"; }
  RepairReport repaired() {
    return catalogue::valueIn(
        repairCatalogue(folder(), quiet_, {}, [this] { return now_ms += 1; }));
  }
  void fill(int sherds) {
    for (int i = 0; i < sherds; ++i) EXPECT_TRUE(set(numbered(context12), "ware", "grey"));
  }
  QuietProgress quiet_;
};

// A laptop whose clock battery is empty starts years ago.
TEST_F(RepairBase, IsTheBackupWithTheLongestHistoryWhateverTheClockSaid) {
  ASSERT_TRUE(project_->backUp());
  fill(10);
  const std::string content = *catalogue::contentOf(catalogue().database());
  const fs::path full = folder() / "backups" / "catalogue-20200101-000000-000.sqlite";
  fs::rename(*project_->backUp(), full);
  project_.reset();
  fs::resize_file(file(), 0);
  EXPECT_EQ(repaired().backup, full);
  EXPECT_EQ(*catalogue::contentOf(folder()), content);
}

TEST_F(RepairBase, IsNoBackupOfAnotherProjectHoweverLongItsHistory) {
  fill(3);
  records::ProjectRecord record;
  record.code = "NEW";
  Project other = catalogue::valueIn(
      Project::create(folder_.path() / "other", record, [this] { return now_ms += 1; }));
  for (int i = 0; i < 100; ++i) {
    record.title = std::to_string(i);
    ASSERT_TRUE(catalogue::Settings(other.catalogue()).setProject(record, {}));
  }
  ASSERT_GT(catalogue::History(other.catalogue()).length(),
            catalogue::History(catalogue()).length());
  const fs::path strange = folder() / "backups" / "catalogue-20260101-000000-000.sqlite";
  fs::copy_file(*other.backUp(), strange);
  records::FileRecord photograph;
  photograph.path = "batches/B0001/front/cam0_pos00.jpg";
  photograph.sha256 = std::string(64, 'a');
  photograph.media_type = "image/jpeg";
  photograph.role = "photo";
  ASSERT_TRUE(catalogue::Files(catalogue()).save(photograph, anna));
  const fs::path own = *project_->backUp();
  // By its name the newest of all.
  fs::rename(strange, folder() / "backups" / ("catalogue-" + timeStamp(now_ms) + ".sqlite"));
  project_.reset();
  fs::resize_file(file(), 0);
  const Result<RepairReport> asked =
      repairCatalogue(folder(), quiet_, {}, [this] { return now_ms += 1; });
  ASSERT_FALSE(asked) << "of neither a file lies here";
  EXPECT_EQ(asked.error().code, ErrorCode::UnusableInput);
  EXPECT_EQ(fs::file_size(file()), 0u);
  fs::create_directories((folder() / photograph.path).parent_path());
  catalogue::writeBytes(folder() / photograph.path, "here");
  EXPECT_EQ(repaired().backup, own);
}

TEST_F(RepairBase, IsTheNewestWhereTheCatalogueIsGone) {
  fill(3);
  const fs::path backup = *project_->backUp();
  const std::string content = *catalogue::contentOf(catalogue().database());
  project_.reset();
  fs::remove(file());
  const RepairReport report = repaired();
  EXPECT_TRUE(report.all_from_backup);
  EXPECT_EQ(report.backup, backup);
  EXPECT_EQ(*catalogue::contentOf(folder()), content);
}

TEST_F(RepairBase, IsMissingWhereNeitherACatalogueNorAWholeBackupIsLeft) {
  fill(3);
  const fs::path backup = *project_->backUp();
  project_.reset();
  fs::remove(file());
  fs::remove_all(folder() / "backups");
  fs::create_directories(folder() / "backups");
  const Result<RepairReport> none = repairCatalogue(folder(), quiet_, {});
  ASSERT_FALSE(none);
  EXPECT_NE(none.error().what.english().find("has no catalogue.sqlite"), std::string::npos);
  catalogue::writeBytes(backup, std::string(8192, 'x'));
  const Result<RepairReport> damaged = repairCatalogue(folder(), quiet_, {});
  ASSERT_FALSE(damaged);
  EXPECT_NE(damaged.error().what.english().find("none of its backups is intact"),
            std::string::npos);
  EXPECT_FALSE(fs::exists(file())) << "everything is as it was";
}

}  // namespace
}  // namespace ostraka::upkeep
