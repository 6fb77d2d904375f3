#include "files/new_folder.h"

#include <gtest/gtest.h>
#include <sys/inotify.h>

#include <fstream>
#include <vector>

#include "files/file_descriptor.h"

#include "tests/core/files/temporary_folder.h"

namespace ostraka {
namespace {

namespace fs = std::filesystem;

struct NewFolders : testing::Test {
  TemporaryFolder temporary;
  fs::path root = temporary.path();
  fs::path place = root / "batch", partial = root / "batch.partial";
  static void write(const fs::path& file) {
    fs::create_directories(file.parent_path());
    std::ofstream(file) << "x";
  }
};

TEST_F(NewFolders, TakeTheirPlaceWholeAndLeaveNothingBeside) {
  {
    Result<NewFolder> folder = NewFolder::begin(place);
    ASSERT_TRUE(folder) << folder.error().sentence();
    write(folder->path() / "front" / "a.jpg");
    EXPECT_FALSE(fs::exists(place));
    ASSERT_TRUE(folder->finish());
  }
  EXPECT_TRUE(fs::exists(place / "front" / "a.jpg"));
  EXPECT_FALSE(fs::exists(partial));
}

TEST_F(NewFolders, ReplaceAnEmptyFolderButNoFiles) {
  fs::create_directories(place);
  {
    Result<NewFolder> folder = NewFolder::begin(place.string() + "/");
    ASSERT_TRUE(folder) << folder.error().sentence();
    write(folder->path() / "a");
    ASSERT_TRUE(folder->finish());
  }
  EXPECT_TRUE(fs::exists(place / "a"));
  const Result<NewFolder> again = NewFolder::begin(place);
  ASSERT_FALSE(again);
  EXPECT_EQ(again.error().code, ErrorCode::UnusableInput);
  EXPECT_FALSE(fs::exists(partial));
}

TEST_F(NewFolders, ThatAreNotFinishedAreRemoved) {
  {
    Result<NewFolder> folder = NewFolder::begin(place);
    ASSERT_TRUE(folder);
    write(folder->path() / "a");
  }
  EXPECT_TRUE(fs::is_empty(root));
}

TEST_F(NewFolders, RemoveWhatAKilledRunLeftButNothingElse) {
  write(partial / "lock");
  write(partial / "content" / "half");
  {
    Result<NewFolder> folder = NewFolder::begin(place);
    ASSERT_TRUE(folder) << folder.error().sentence();
    EXPECT_TRUE(fs::is_empty(folder->path()));
  }
  EXPECT_FALSE(fs::exists(partial));
  write(partial / "letter.txt");
  const Result<NewFolder> refused = NewFolder::begin(place);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().where, partial.string());
  EXPECT_TRUE(fs::exists(partial / "letter.txt"));
}

// A disk of FUSE keeps a file that is deleted while it is open in its folder until it is closed.
TEST_F(NewFolders, CloseTheirLockBeforeTheFolderAroundItGoes) {
  const FileDescriptor watch(::inotify_init1(IN_NONBLOCK | IN_CLOEXEC));
  ASSERT_TRUE(watch.isOpen());
  {
    Result<NewFolder> folder = NewFolder::begin(place);
    ASSERT_TRUE(folder) << folder.error().sentence();
    ASSERT_TRUE(folder->finish());
    ASSERT_GE(::inotify_add_watch(watch.get(), partial.c_str(), IN_CLOSE_WRITE | IN_DELETE_SELF),
              0);
  }
  std::vector<std::uint32_t> seen;
  alignas(inotify_event) char bytes[4096];
  const ssize_t count = ::read(watch.get(), bytes, sizeof bytes);
  for (const char* at = bytes; at < bytes + count;) {
    const auto* event = reinterpret_cast<const inotify_event*>(at);
    if ((event->mask & IN_IGNORED) == 0) seen.push_back(event->mask);
    at += sizeof(inotify_event) + event->len;
  }
  EXPECT_EQ(seen, (std::vector<std::uint32_t>{IN_CLOSE_WRITE, IN_DELETE_SELF}));
}

// Killed after any step of its end: the lock alone is left, or the folder alone.
TEST_F(NewFolders, RemoveWhatIsLeftOfTheEndOfAKilledRun) {
  for (const bool has_lock : {true, false}) {
    fs::create_directories(partial);
    if (has_lock) write(partial / "lock");
    EXPECT_TRUE(NewFolder::begin(place));
    EXPECT_FALSE(fs::exists(partial)) << has_lock;
  }
}

TEST_F(NewFolders, LeaveTheLockOfWhoeverTookTheirPlace) {
  {
    const Result<NewFolder> folder = NewFolder::begin(place);
    ASSERT_TRUE(folder);
    fs::rename(partial, root / "aside");
    write(partial / "lock");
  }
  EXPECT_TRUE(fs::exists(partial / "lock"));
}

TEST_F(NewFolders, AreFilledByOneRunAtATime) {
  const Result<NewFolder> first = NewFolder::begin(place);
  ASSERT_TRUE(first);
  write(first->path() / "a");
  const Result<NewFolder> second = NewFolder::begin(place);
  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().code, ErrorCode::CannotWrite);
  EXPECT_TRUE(fs::exists(first->path() / "a"));
}

// The folder that a person stands in, and a disk of its own, keep their place.
TEST_F(NewFolders, DoNotReplaceTheFolderThatThePersonIsIn) {
  const fs::path before = fs::current_path();
  fs::create_directories(place);
  fs::current_path(place);
  const Result<NewFolder> here = NewFolder::begin(".");
  fs::current_path(before);
  ASSERT_FALSE(here);
  EXPECT_EQ(here.error().code, ErrorCode::UnusableInput);
}

}  // namespace
}  // namespace ostraka
