#include "files/folder_lock.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace ostraka {
namespace {

struct Notes final : Progress {
  void report(std::int64_t, std::int64_t) override {}
  void note(NoteLevel, const Message& text) override { all.emplace_back(text.english()); }
  std::vector<std::string> all;
};

struct FolderLocks : testing::Test {
  std::filesystem::path folder =
      std::filesystem::path(testing::TempDir()) / ("ostraka_lock_" + std::to_string(::getpid()));
  void TearDown() override { std::filesystem::remove_all(folder); }
};

TEST_F(FolderLocks, OneHolderAtATimeAndTheSecondIsToldWhich) {
  std::optional<Result<FolderLock>> first = FolderLock::take(folder);
  ASSERT_TRUE(first->has_value());
  const Result<FolderLock> second = FolderLock::take(folder);
  ASSERT_FALSE(second.has_value());
  EXPECT_NE(second.error().sentence().english().find(folder.string()), std::string::npos);
  first.reset();
  EXPECT_TRUE(FolderLock::take(folder).has_value());
}

TEST_F(FolderLocks, WhoWaitsGetsItWhenTheHolderEndsOrIsStopped) {
  std::optional<Result<FolderLock>> first = FolderLock::take(folder);
  std::stop_source stop;
  std::thread person([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(80));
    stop.request_stop();
  });
  Notes notes;
  const Result<FolderLock> stopped =
      FolderLock::waitFor(folder, "For Anna.", notes, stop.get_token());
  person.join();
  ASSERT_FALSE(stopped.has_value());
  EXPECT_EQ(stopped.error().code, ErrorCode::Cancelled);
  EXPECT_EQ(notes.all, std::vector<std::string>{"For Anna."}) << "once, however long";
  std::thread holder([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(80));
    first.reset();
  });
  const Result<FolderLock> next = FolderLock::waitFor(folder, "For Anna.", notes, {});
  holder.join();
  ASSERT_TRUE(next.has_value());
  EXPECT_TRUE(next->stands());
  EXPECT_FALSE(FolderLock::take(folder).has_value());
}

TEST_F(FolderLocks, WhoNeedsNotWaitSaysNothing) {
  Notes notes;
  ASSERT_TRUE(FolderLock::waitFor(folder, "For Anna.", notes, {}).has_value());
  EXPECT_TRUE(notes.all.empty());
}

TEST_F(FolderLocks, ALinkInThePlaceOfTheLockIsRefusedAndNotFollowed) {
  std::filesystem::create_directories(folder);
  std::filesystem::create_symlink(folder / "elsewhere", folder / "lock");
  const Result<FolderLock> held = FolderLock::take(folder);
  ASSERT_FALSE(held.has_value());
  EXPECT_NE(held.error().sentence().english().find("lock"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(folder / "elsewhere"));
}

TEST_F(FolderLocks, AProcessThatDiesLetsGo) {
  std::filesystem::create_directories(folder);
  int ready[2];
  ASSERT_EQ(::pipe(ready), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    const Result<FolderLock> held = FolderLock::take(folder);
    const char answer = held.has_value() ? 'y' : 'n';
    (void)!::write(ready[1], &answer, 1);
    ::pause();
  }
  char answer = 0;
  ASSERT_EQ(::read(ready[0], &answer, 1), 1);
  ASSERT_EQ(answer, 'y');
  EXPECT_FALSE(FolderLock::take(folder).has_value());
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  EXPECT_TRUE(FolderLock::take(folder).has_value());
  ::close(ready[0]);
  ::close(ready[1]);
}

TEST_F(FolderLocks, OneThatEndsWithoutTraceLeavesNoFileAndNeverThatOfAnother) {
  Result<FolderLock> first = FolderLock::take(folder);
  ASSERT_TRUE(first.has_value());
  first->endWithoutTrace();
  EXPECT_TRUE(std::filesystem::is_empty(folder));
  const Result<FolderLock> second = FolderLock::take(folder);
  ASSERT_TRUE(second.has_value());
  first->endWithoutTrace();
  EXPECT_TRUE(second->stands());
}

TEST_F(FolderLocks, AFolderThatWasDeletedDoesNotStandThoughOneOfItsNameIsThere) {
  const Result<FolderLock> held = FolderLock::take(folder);
  ASSERT_TRUE(held.has_value());
  EXPECT_TRUE(held->stands());
  std::filesystem::remove_all(folder);
  EXPECT_FALSE(held->stands());
  const Result<FolderLock> another = FolderLock::take(folder);  // may get the same inode
  EXPECT_TRUE(another->stands());
  EXPECT_FALSE(held->stands());
}

}  // namespace
}  // namespace ostraka
