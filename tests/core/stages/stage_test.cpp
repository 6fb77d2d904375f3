#include "stages/stage.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "files/files.h"

namespace ostraka::stages {
namespace {

namespace fs = std::filesystem;

class Stage : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "ostraka_stage_XXXXXX").string();
    ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
  }
  void TearDown() override { fs::remove_all(folder_); }

  // Runs the stage 'count' with this key; each real run adds one to runs_.
  Result<StageRecord> run(const std::string& key) {
    QuietProgress quiet;
    const Result<FolderLock> held = FolderLock::take(folder_);
    return runStage(
        *held, "count", {{"option", key}},
        [&](const fs::path& folder) -> Result<StageNotes> {
          ++runs_;
          EXPECT_TRUE(fs::is_empty(folder));
          const Result<void> written = writeFileAtomically(folder / "value.txt", "value of " + key);
          if (!written) return written.error();
          return StageNotes{{{"length", key.size()}}, {"look at " + key}};
        },
        quiet);
  }

  fs::path folder_;
  int runs_ = 0;
};

TEST_F(Stage, RunsOnceAndIsFoundWholeAfterwards) {
  const Result<StageRecord> first = run("a"), second = run("a");
  ASSERT_TRUE(first.has_value() && second.has_value());
  EXPECT_EQ(runs_, 1);
  EXPECT_FALSE(first->resumed);
  EXPECT_TRUE(second->resumed);
  EXPECT_EQ(first->outputs_hash, second->outputs_hash);
  EXPECT_EQ(second->notes.warnings, std::vector<Message>{"look at a"});
  EXPECT_EQ(second->notes.figures.at("length"), 1);
}

TEST_F(Stage, RunsAgainWhenItsInputsChange) {
  const Result<StageRecord> first = run("a"), second = run("bb");
  ASSERT_TRUE(first.has_value() && second.has_value());
  EXPECT_EQ(runs_, 2);
  EXPECT_NE(first->outputs_hash, second->outputs_hash);
}

TEST_F(Stage, RunsAgainWhenAFileItLeftWasChangedOrIsMissing) {
  ASSERT_TRUE(run("a").has_value());
  ASSERT_TRUE(writeFileAtomically(folder_ / "count" / "value.txt", "tampered").has_value());
  ASSERT_TRUE(run("a").has_value());
  EXPECT_EQ(runs_, 2);
  fs::remove(folder_ / "count" / "value.txt");
  ASSERT_TRUE(run("a").has_value());
  EXPECT_EQ(runs_, 3);
}

TEST_F(Stage, KilledBeforeItsRecordIsDoneAgainFromAnEmptyFolder) {
  ASSERT_TRUE(run("a").has_value());
  fs::remove(folder_ / "count" / "stage.json");
  ASSERT_TRUE(writeFileAtomically(folder_ / "count" / "half.txt", "half").has_value());
  ASSERT_TRUE(run("a").has_value());
  EXPECT_EQ(runs_, 2);
  EXPECT_FALSE(fs::exists(folder_ / "count" / "half.txt"));
}

TEST_F(Stage, ThatFailsLeavesNoRecord) {
  QuietProgress quiet;
  const Result<FolderLock> held = FolderLock::take(folder_);
  const Result<StageRecord> failed = runStage(
      *held, "count", {},
      [](const fs::path&) -> Result<StageNotes> {
        return Error{ErrorCode::NotEnough, "Too few.", {}};
      },
      quiet);
  ASSERT_FALSE(failed.has_value());
  EXPECT_EQ(failed.error().code, ErrorCode::NotEnough);
  EXPECT_FALSE(fs::exists(folder_ / "count" / "stage.json"));
}

}  // namespace
}  // namespace ostraka::stages
