#include "files/open_folder.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>

#include "files/files.h"
#include "tests/core/files/temporary_folder.h"

namespace ostraka {
namespace {

namespace fs = std::filesystem;

class AnOpenFolder : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(root_ / "inside/below");
    std::ofstream(root_ / "inside/below/file.txt") << "inside";
    fs::create_directories(root_ / "outside");
    std::ofstream(root_ / "outside/file.txt") << "outside";
  }
  OpenFolder inside() const { return std::move(*OpenFolder::open(root_ / "inside")); }
  static ContainedPath path(const std::string& text) { return *ContainedPath::parse(text); }
  std::string textOf(const std::string& name) const {
    Result<OpenFile> file = inside().read(path(name));
    if (!file) return file.error().sentence().english();
    std::string text(100, '\0');
    text.resize(*file->read(text));
    return text;
  }
  static Result<void> write(const OpenFolder& folder, const std::string& name) {
    Result<NewFile> made = folder.create(path(name));
    if (!made) return made.error();
    if (Result<void> written = made->write("new"); !written) return written;
    return made->finish();
  }
  std::size_t entries(const fs::path& folder) const {
    return static_cast<std::size_t>(std::distance(fs::recursive_directory_iterator(root_ / folder),
                                                  fs::recursive_directory_iterator()));
  }
  TemporaryFolder temporary_;
  fs::path root_ = temporary_.path();
};

TEST_F(AnOpenFolder, ReadsAndMakesFilesBelowItself) {
  EXPECT_EQ(textOf("below/file.txt"), "inside");
  const OpenFolder folder = inside();
  ASSERT_TRUE(write(folder, "new/folders/file.txt"));
  EXPECT_EQ(*readFile(root_ / "inside/new/folders/file.txt"), "new");
  EXPECT_TRUE(folder.has(path("new/folders")));
  EXPECT_FALSE(folder.has(path("new/file.txt")));
}

// /proc answers as exfat-fuse does of a name with ':': the folder is there, but no such file.
TEST_F(AnOpenFolder, SaysThatTheDiskRefusesAName) {
  const Result<void> refused = write(*OpenFolder::open("/proc"), "notes.txt");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::UnusableInput);
  EXPECT_NE(refused.error().what.english().find("does not accept this name"), std::string::npos);
  EXPECT_EQ(refused.error().where, "/proc/notes.txt");
}

TEST_F(AnOpenFolder, FollowsNoLinkOnTheWayNorAtItsEnd) {
  fs::create_directory_symlink(root_ / "outside", root_ / "inside/folder");
  fs::create_symlink(root_ / "outside/file.txt", root_ / "inside/below/link.txt");
  for (const char* name : {"folder/file.txt", "below/link.txt"}) {
    EXPECT_NE(textOf(name).find("A link or a file has taken"), std::string::npos) << textOf(name);
    EXPECT_FALSE(write(inside(), name)) << name;
  }
  EXPECT_FALSE(write(inside(), "folder/new.txt"));
  EXPECT_FALSE(write(inside(), "folder/new/deep.txt"));
  EXPECT_EQ(entries("outside"), 1u);
  EXPECT_EQ(*readFile(root_ / "outside/file.txt"), "outside");
}

TEST_F(AnOpenFolder, MovesAFileOnlyWithinItself) {
  fs::create_directory_symlink(root_ / "outside", root_ / "inside/folder");
  const OpenFolder folder = inside();
  EXPECT_FALSE(folder.move(path("below/file.txt"), path("folder/moved.txt")));
  EXPECT_FALSE(folder.move(path("folder/file.txt"), path("below/moved.txt")));
  EXPECT_EQ(textOf("below/file.txt"), "inside");
  EXPECT_EQ(entries("outside"), 1u);
  ASSERT_TRUE(write(folder, "new.txt"));
  ASSERT_TRUE(folder.move(path("new.txt"), path("below/file.txt")));
  EXPECT_EQ(textOf("below/file.txt"), "new") << "what was there is replaced";
  ASSERT_TRUE(folder.move(path("below/file.txt"), path("made/on/the/way.txt")));
  EXPECT_EQ(textOf("made/on/the/way.txt"), "new");
}

TEST_F(AnOpenFolder, GivesWhatACatalogueNamesOnlyFromWithin) {
  Result<OpenFile> file = OpenFile::within(root_ / "inside", "below/file.txt");
  ASSERT_TRUE(file) << file.error().sentence();
  EXPECT_EQ(*file->readAll(), "inside");
  EXPECT_FALSE(OpenFile::within(root_ / "inside", "below/file.txt")->readAll(5)) << "too large";
  fs::create_symlink(root_ / "outside/file.txt", root_ / "inside/link.txt");
  for (const std::string& path : {std::string("link.txt"), std::string("../outside/file.txt"),
                                  (root_ / "outside/file.txt").string(), std::string()})
    EXPECT_FALSE(OpenFile::within(root_ / "inside", path)) << path;
}

TEST_F(AnOpenFolder, IsTheSameFolderWhateverTakesItsPlace) {
  const OpenFolder folder = inside();
  fs::rename(root_ / "inside", root_ / "moved");
  fs::create_directory_symlink(root_ / "outside", root_ / "inside");
  ASSERT_TRUE(write(folder, "new.txt"));
  EXPECT_TRUE(fs::exists(root_ / "moved/new.txt"));
  EXPECT_EQ(entries("outside"), 1u);
}

TEST_F(AnOpenFolder, NeverWritesOverAFileAndLeavesNothingHalf) {
  const OpenFolder folder = inside();
  const Result<void> over = write(folder, "below/file.txt");
  ASSERT_FALSE(over);
  EXPECT_EQ(over.error().code, ErrorCode::UnusableInput);
  {
    Result<NewFile> left = folder.create(path("below/left.txt"));
    ASSERT_TRUE(left && left->write("half"));
  }
  {
    Result<NewFile> late = folder.create(path("below/late.txt"));
    ASSERT_TRUE(late && late->write("late"));
    std::ofstream(root_ / "inside/below/late.txt") << "first";
    EXPECT_FALSE(late->finish()) << "somebody was faster";
  }
  EXPECT_EQ(*readFile(root_ / "inside/below/late.txt"), "first");
  EXPECT_EQ(entries("inside/below"), 2u);
}

TEST_F(AnOpenFolder, RemovesWhatAKilledProgramLeftOfAFileThatIsMadeAgain) {
  const OpenFolder folder = *OpenFolder::open(root_ / "inside");
  const fs::path dead = root_ / "inside/below/.new.txt.0123456789ab.partial",
                 others = root_ / "inside/below/.other.txt.0123456789ab.partial";
  for (const fs::path& left : {dead, others}) std::ofstream(left) << "half";
  Result<NewFile> made = folder.create(path("below/new.txt"));
  ASSERT_TRUE(made);
  EXPECT_FALSE(fs::exists(dead));
  EXPECT_TRUE(fs::exists(others)) << "somebody may be at it";
}

TEST_F(AnOpenFolder, WaitsForNoPipe) {
  ASSERT_EQ(::mkfifo((root_ / "inside/pipe").c_str(), 0600), 0);
  EXPECT_NE(textOf("pipe").find("This is a pipe, not a file"), std::string::npos) << textOf("pipe");
  EXPECT_FALSE(OpenFile::open(root_ / "inside/pipe"));
  EXPECT_FALSE(OpenFile::open("/dev/zero"));
  EXPECT_FALSE(OpenFile::open(root_ / "inside"));
}

TEST_F(AnOpenFolder, ListsWhatLiesBelowAndTellsLinksFromFiles) {
  fs::create_directory_symlink(root_ / "outside", root_ / "inside/below/folder");
  std::ofstream(root_ / "inside/below/a.txt") << "a";
  const auto files = inside().filesBelow(path("below"));
  ASSERT_TRUE(files) << files.error().sentence();
  ASSERT_EQ(files->size(), 3u);
  EXPECT_EQ((*files)[0].path, "below/a.txt");
  EXPECT_TRUE((*files)[0].is_regular);
  EXPECT_EQ((*files)[2].path, "below/folder");
  EXPECT_FALSE((*files)[2].is_regular);
  EXPECT_FALSE(inside().filesBelow(path("below/folder"))) << "not through a link";
  EXPECT_FALSE(inside().filesBelow(path("nowhere")));
  fs::path deep = root_ / "inside/deep";
  for (int i = 0; i < 70; ++i) deep /= "d";
  fs::create_directories(deep);
  EXPECT_FALSE(inside().filesBelow(path("deep")));
}

}  // namespace
}  // namespace ostraka
