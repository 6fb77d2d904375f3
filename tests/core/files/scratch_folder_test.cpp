#include "files/scratch_folder.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>
#include <optional>
#include <string>
#include <utility>

namespace ostraka {
namespace {

namespace fs = std::filesystem;

TEST(ScratchFolders, AreNewAndForTheirOwnerAloneAndGoWithAllThatTheyHold) {
  fs::path path;
  {
    Result<ScratchFolder> first = ScratchFolder::make("ostraka-test");
    const Result<ScratchFolder> second = ScratchFolder::make("ostraka-test");
    ASSERT_TRUE(first.has_value() && second.has_value());
    EXPECT_NE(first->path(), second->path());
    struct stat info {};
    ASSERT_EQ(::stat(first->path().c_str(), &info), 0);
    EXPECT_EQ(info.st_mode & 0777, 0700U);
    const ScratchFolder moved = std::move(*first);
    path = moved.path();
    fs::create_directories(path / "deep");
    std::ofstream(path / "deep/file") << "x";
    EXPECT_TRUE(path.filename().string().starts_with("ostraka-test-"));
  }
  EXPECT_FALSE(fs::exists(path));
}

TEST(ScratchFolders, AreRefusedWhereNoneCanBeMadeAndRemoveNothingThere) {
  const fs::path file = fs::path(testing::TempDir()) / ("ostraka_s_" + std::to_string(::getpid()));
  std::ofstream(file) << "x";
  const Result<ScratchFolder> made = ScratchFolder::make("ostraka-test", file);
  ASSERT_FALSE(made.has_value());
  EXPECT_EQ(made.error().code, ErrorCode::CannotWrite);
  EXPECT_TRUE(fs::exists(file));
  fs::remove(file);
}

}  // namespace
}  // namespace ostraka
