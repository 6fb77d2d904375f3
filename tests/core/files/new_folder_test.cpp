#include "files/new_folder.h"

#include <gtest/gtest.h>

#include <fstream>

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
