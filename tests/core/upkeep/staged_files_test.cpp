#include "upkeep/staged_files.h"

#include <gmock/gmock.h>

#include "catalogue/file_places.h"
#include "catalogue/settings.h"
#include "files/files.h"
#include "tests/core/catalogue/small_project.h"

namespace ostraka::upkeep {
namespace {

namespace fs = std::filesystem;

class Staged : public catalogue::SmallProject {
 protected:
  void write(const std::string& path, const std::string& bytes) {
    fs::create_directories((project_->folder() / path).parent_path());
    EXPECT_TRUE(writeFileAtomically(project_->folder() / path, bytes));
  }
  std::string at(const std::string& path) const {
    const Result<std::string> bytes = readFile(project_->folder() / path);
    return bytes ? *bytes : "nothing";
  }
  // Waits under a name of its own; over: what lay in its place then.
  void stage(const std::string& to, const std::string& bytes, const std::string& over = {}) {
    const std::string name = std::to_string(files_.size());
    write(std::string(kStagingFolder) + "/" + name, bytes);
    files_[to] = {name, over.empty() ? over : sha256(over)};
    ASSERT_TRUE(noteStaged(catalogue(), files_));
  }
  Result<std::vector<std::string>> place() {
    return placeStaged(catalogue(), project_->folder(), quiet_, {});
  }
  StagedFiles files_;
  QuietProgress quiet_;
};

TEST_F(Staged, ComeToTheirPlacesAndAreForgotten) {
  write("results/B0001/report.json", "of A");
  stage("batches/B0002/front/a.jpg", "JPEG");
  stage("results/B0001/report.json", "of B", "of A");
  const auto kept = place();
  ASSERT_TRUE(kept) << kept.error().sentence();
  EXPECT_TRUE(kept->empty());
  EXPECT_EQ(at("batches/B0002/front/a.jpg"), "JPEG");
  EXPECT_EQ(at("results/B0001/report.json"), "of B");
  EXPECT_FALSE(fs::exists(project_->folder() / kStagingFolder));
  write("results/B0001/report.json", "later");
  ASSERT_TRUE(place());
  EXPECT_EQ(at("results/B0001/report.json"), "later");
}

// A folder with files of two computations belongs to neither.
TEST_F(Staged, LeaveAFolderWholeInWhichOneFileChangedMeanwhile) {
  write("results/B0001/report.json", "of A");
  write("results/B0001/scans/f000.ply", "of A");
  write("results/B0002/report.json", "of A");
  stage("results/B0001/report.json", "of B", "of A");
  stage("results/B0001/scans/f000.ply", "of B", "of A");
  stage("results/B0002/report.json", "of B", "of A");
  write("results/B0001/scans/f000.ply", "computed anew");
  const auto kept = place();
  ASSERT_TRUE(kept) << kept.error().sentence();
  EXPECT_THAT(*kept, testing::ElementsAre("results/B0001"));
  EXPECT_EQ(at("results/B0001/report.json"), "of A");
  EXPECT_EQ(at("results/B0001/scans/f000.ply"), "computed anew");
  EXPECT_EQ(at("results/B0002/report.json"), "of B");
}

TEST_F(Staged, GoOnWhereAKillLeftThem) {
  stage("batches/B0001/front/a.jpg", "A");
  stage("batches/B0001/front/b.jpg", "B");
  fs::create_directories(project_->folder() / "batches/B0001/front");
  fs::rename(project_->folder() / kStagingFolder / files_.at("batches/B0001/front/a.jpg").name,
             project_->folder() / "batches/B0001/front/a.jpg");
  ASSERT_TRUE(place());
  EXPECT_EQ(at("batches/B0001/front/a.jpg"), "A");
  EXPECT_EQ(at("batches/B0001/front/b.jpg"), "B");
}

// A folder in the place of a file, and a file in the place of a folder.
TEST_F(Staged, WaitWhereTheyCannotBeMovedWhileAllOthersComeToTheirPlaces) {
  write("batches/B0001/front/a.jpg/in_the_way", "x");
  write("batches/B0002", "x");
  stage("batches/B0001/front/a.jpg", "A");
  stage("batches/B0001/front/b.jpg", "B");
  stage("batches/B0002/front/c.jpg", "C");
  const auto left = place();
  ASSERT_TRUE(left) << left.error().sentence();
  EXPECT_THAT(*left,
              testing::ElementsAre("batches/B0001/front/a.jpg", "batches/B0002/front/c.jpg"));
  EXPECT_EQ(at("batches/B0001/front/b.jpg"), "B");
  const Result<void> waits = checkNoneWaits(catalogue(), project_->folder());
  ASSERT_FALSE(waits);
  EXPECT_EQ(waits.error().code, ErrorCode::UnusableInput);
  EXPECT_TRUE(Project::open(project_->folder())) << "no file locks the project";

  fs::remove_all(project_->folder() / "batches/B0001/front/a.jpg");
  fs::remove(project_->folder() / "batches/B0002");
  const auto none = place();
  ASSERT_TRUE(none) << none.error().sentence();
  EXPECT_THAT(*none, testing::IsEmpty());
  EXPECT_EQ(at("batches/B0001/front/a.jpg"), "A");
  EXPECT_EQ(at("batches/B0002/front/c.jpg"), "C");
  EXPECT_TRUE(checkNoneWaits(catalogue(), project_->folder()));
  EXPECT_FALSE(fs::exists(project_->folder() / kStagingFolder));
}

TEST_F(Staged, GoNowhereElseThanAMergeMay) {
  using catalogue::isPlaceOfFiles;
  for (const char* place_of : {"batches/B0001/a.jpg", "results/B0001/a", "models/B0001/a.ply"})
    EXPECT_TRUE(isPlaceOfFiles(place_of)) << place_of;
  for (const char* elsewhere : {"catalogue.sqlite", "backups/a", "batches", "batches/a",
                                "batches_of_others/a/b", "", "/batches/a/b"})
    EXPECT_FALSE(isPlaceOfFiles(elsewhere)) << elsewhere;
  stage("batches/B0001/front/a.jpg", "A");
  stage("backups/catalogue-20260101-000000-000.sqlite", "planted");
  const auto refused = place();
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::UnusableInput);
  EXPECT_EQ(at("batches/B0001/front/a.jpg"), "nothing") << "none of them is moved";
}

}  // namespace
}  // namespace ostraka::upkeep
