#include "stages/stage.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <cstdlib>
#include <set>

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

  static std::set<std::string> namesIn(const fs::path& folder) {
    std::set<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
      names.insert(entry.path().filename().string());
    return names;
  }

  // Runs the stage 'count' with this key; each real run adds one to runs_.
  Result<StageRecord> run(const std::string& key) {
    QuietProgress quiet;
    const Result<FolderLock> held = FolderLock::take(folder_);
    return runStage(
        *held, "count", {{"option", key}},
        [&](const fs::path& folder) -> Result<StageNotes> {
          ++runs_;
          EXPECT_EQ(namesIn(folder), std::set<std::string>{"begun.json"});
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

TEST_F(Stage, KilledAtWorkIsDoneAgainFromAnEmptyFolder) {
  ASSERT_TRUE(run("a").has_value());
  EXPECT_EQ(namesIn(folder_ / "count"),
            (std::set<std::string>{"begun.json", "stage.json", "value.txt"}));
  const auto killed = [&] {
    QuietProgress quiet;
    const Result<FolderLock> held = FolderLock::take(folder_);
    static_cast<void>(runStage(
        *held, "count", {{"option", "b"}},
        [](const fs::path& folder) -> Result<StageNotes> {
          static_cast<void>(writeFileAtomically(folder / "half.txt", "half"));
          ::_exit(9);
        },
        quiet));
  };
  EXPECT_EXIT(killed(), testing::ExitedWithCode(9), "");
  EXPECT_EQ(namesIn(folder_ / "count"), (std::set<std::string>{"begun.json", "half.txt"}));
  ASSERT_TRUE(run("a").has_value());
  EXPECT_EQ(runs_, 2);
  EXPECT_EQ(namesIn(folder_ / "count"),
            (std::set<std::string>{"begun.json", "stage.json", "value.txt"}));
}

TEST_F(Stage, KilledAtItsFirstRecordGoesOn) {
  fs::create_directories(folder_ / "count");
  ASSERT_TRUE(writeFileAtomically(folder_ / "count" / ".begun.json.0123456789ab.partial", "{"));
  ASSERT_TRUE(run("a").has_value());
  ASSERT_TRUE(run("a").has_value());
  EXPECT_EQ(runs_, 1);
  EXPECT_EQ(namesIn(folder_ / "count"),
            (std::set<std::string>{"begun.json", "stage.json", "value.txt"}));
}

TEST_F(Stage, RefusesAFolderOfItsNameThatIsAPersonsAndLeavesItAsItIs) {
  for (const std::string record : {"", R"({"stage": "another"})", "no JSON"}) {
    const fs::path notes = folder_ / "count" / "notes.txt";
    ASSERT_TRUE(writeFileAtomically(notes, "of a person"));
    if (!record.empty()) {
      ASSERT_TRUE(writeFileAtomically(folder_ / "count" / "stage.json", record));
    }
    const Result<StageRecord> refused = run("a");
    ASSERT_FALSE(refused.has_value()) << record;
    EXPECT_EQ(refused.error().code, ErrorCode::UnusableInput);
    EXPECT_EQ(refused.error().where, (folder_ / "count").string());
    EXPECT_EQ(*readFile(notes), "of a person");
  }
  EXPECT_EQ(runs_, 0);
}

TEST_F(Stage, WhoseOutputFolderWasExchangedLeavesTheStageOfTheOther) {
  QuietProgress quiet;
  const Result<FolderLock> held = FolderLock::take(folder_);
  const fs::path moved = folder_.string() + "_moved", other = folder_ / "count";
  const Result<StageRecord> gone = runStage(
      *held, "count", {},
      [&](const fs::path&) -> Result<StageNotes> {
        fs::rename(folder_, moved);
        EXPECT_TRUE(writeFileAtomically(other / "stage.json", "of another run"));
        EXPECT_TRUE(writeFileAtomically(other / "value.txt", "of another run"));
        return StageNotes{};
      },
      quiet);
  fs::remove_all(moved);
  ASSERT_FALSE(gone.has_value());
  EXPECT_EQ(gone.error().code, ErrorCode::CannotWrite);
  EXPECT_EQ(*readFile(other / "value.txt"), "of another run");
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
