#include "files/unfinished_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/stat.h>

#include <cerrno>
#include <fstream>
#include <set>

#include "files/files.h"
#include "tests/core/files/temporary_folder.h"

namespace ostraka {
namespace {

namespace fs = std::filesystem;

class UnfinishedFiles : public testing::Test {
 protected:
  UnfinishedFiles() : open_(::open(folder_.path().c_str(), O_RDONLY | O_DIRECTORY)) {}
  fs::path pathOf(const std::string& name) const { return folder_.path() / name; }
  TemporaryFolder folder_;
  FileDescriptor open_;
};

TEST_F(UnfinishedFiles, OfOneNameAreEachOfItsOwnAndHeld) {
  const UnfinishedFile one = beginFile(open_.get(), "file.txt", 0640),
                       two = beginFile(open_.get(), "file.txt", 0600);
  ASSERT_TRUE(one.file.isOpen() && two.file.isOpen());
  EXPECT_NE(one.name, two.name);
  for (const UnfinishedFile* file : {&one, &two}) {
    // .file.txt. and .partial about 12 hexadecimal digits
    EXPECT_EQ(file->name.size(), 10u + 12 + 8);
    EXPECT_TRUE(file->name.starts_with(".file.txt.") && file->name.ends_with(".partial"));
    const FileDescriptor again(::open(pathOf(file->name).c_str(), O_RDONLY));
    EXPECT_NE(::flock(again.get(), LOCK_EX | LOCK_NB), 0);
    EXPECT_EQ(errno, EWOULDBLOCK);
  }
  EXPECT_EQ(fs::status(pathOf(two.name)).permissions(),
            fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(UnfinishedFiles, ThatNobodyHoldsGoWhenTheNextOfTheNameBegins) {
  std::string left, others;
  {
    left = beginFile(open_.get(), "file.txt", 0600).name;
    others = beginFile(open_.get(), "file", 0600).name;
  }
  ASSERT_TRUE(fs::exists(pathOf(left)) && fs::exists(pathOf(others)));
  // Names that only look alike, and what is no file.
  const std::set<std::string> stay = {".file.txt.0123456789aB.partial", ".file.txt.abc.partial",
                                      ".file.txt.0123456789ab.partial2"};
  for (const std::string& name : stay) std::ofstream(pathOf(name)) << "mine";
  const std::string folder = ".file.txt.0123456789ab.partial",
                    link = ".file.txt.0123456789ac.partial";
  fs::create_directories(pathOf(folder));
  std::ofstream(pathOf("precious")) << "mine";
  fs::create_symlink("precious", pathOf(link));
  ASSERT_TRUE(beginFile(open_.get(), "file.txt", 0600).file.isOpen());
  EXPECT_FALSE(fs::exists(pathOf(left)));
  for (const std::string& name : stay) EXPECT_TRUE(fs::exists(pathOf(name))) << name;
  for (const std::string& name : {folder, others, std::string("precious")})
    EXPECT_TRUE(fs::exists(pathOf(name))) << name;
  EXPECT_TRUE(fs::is_symlink(pathOf(link)));
}

// A name has at most 255 bytes; the 22 about it would not fit.
TEST_F(UnfinishedFiles, OfTheLongestNamesCanBeBegun) {
  const UnfinishedFile file = beginFile(open_.get(), std::string(255, 'n'), 0600);
  EXPECT_TRUE(file.file.isOpen());
  EXPECT_EQ(file.name.size(), 1u + 200 + 1 + 12 + 8);
}

TEST_F(UnfinishedFiles, AreNoneWhereNoFileCanBeMade) {
  fs::remove_all(folder_.path());
  const UnfinishedFile none = beginFile(open_.get(), "file.txt", 0600);
  EXPECT_FALSE(none.file.isOpen());
  EXPECT_EQ(errno, ENOENT);
}

TEST_F(UnfinishedFiles, TakeAllBytesOrSayWhyNot) {
  const UnfinishedFile file = beginFile(open_.get(), "file.txt", 0600);
  const std::string bytes(3'000'000, 'b');
  EXPECT_TRUE(writeAll(file.file.get(), bytes));
  EXPECT_TRUE(writeAll(file.file.get(), ""));
  EXPECT_EQ(*readFile(pathOf(file.name)), bytes);
  const FileDescriptor full(::open("/dev/full", O_WRONLY));
  EXPECT_FALSE(writeAll(full.get(), "x"));
  EXPECT_EQ(errno, ENOSPC);
}

}  // namespace
}  // namespace ostraka
