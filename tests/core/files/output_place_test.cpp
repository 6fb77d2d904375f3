#include "files/output_place.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

namespace ostraka {
namespace {

namespace fs = std::filesystem;

// A project, an archive with a catalogue in it, as the program makes them, and a folder beside.
struct OutputPlaces : testing::Test {
  fs::path root = fs::canonical(fs::path(testing::TempDir())) /
                  ("ostraka_places_" + std::to_string(::getpid()));
  fs::path project = root / "Grabung ü 1", archive = root / "archive", beside = root / "beside";
  fs::path before = fs::current_path();

  void SetUp() override {
    fs::remove_all(root);
    for (const fs::path& folder :
         {project / "batches" / "B0001", project / "results", archive / "data" / "batches", beside})
      fs::create_directories(folder);
    for (const fs::path& file : {project / "catalogue.sqlite", archive / "bagit.txt",
                                 archive / "data" / "catalogue.sqlite"})
      std::ofstream(file) << "x";
  }
  void TearDown() override {
    fs::current_path(before);
    fs::remove_all(root);
  }

  static void refused(const fs::path& target, const fs::path& owner, std::string_view filled = {}) {
    const Result<void> checked = checkOutputPlace(target, filled);
    ASSERT_FALSE(checked) << target;
    EXPECT_EQ(checked.error().code, ErrorCode::UnusableInput);
    EXPECT_EQ(checked.error().where, target.string());
    EXPECT_NE(checked.error().what.english().find("'" + owner.string() + "'"), std::string::npos)
        << checked.error().what;
  }
  static void allowed(const fs::path& target, std::string_view filled = {}) {
    const Result<void> checked = checkOutputPlace(target, filled);
    EXPECT_TRUE(checked) << checked.error().sentence();
  }
};

TEST_F(OutputPlaces, AreRefusedInAProjectAndInAnArchive) {
  for (const char* below : {"", "new", "batches/B0001/new", "not/there/yet", "new/"}) {
    refused(project / below, project);
    refused(archive / below, archive);
    refused(archive / "data" / below, archive);
  }
}

// Whatever name an input goes by, and where nothing is there yet.
TEST_F(OutputPlaces, OfAFileHaveItsEndingAndAreNoInput) {
  const fs::path model = beside / "model.ply", link = beside / "link.ply";
  std::ofstream(model) << "ply";
  fs::create_symlink(model, link);
  fs::create_directories(beside / "folder.ply");
  EXPECT_TRUE(checkOutputFile(beside / "new.ply", {".ply"}, {model}));
  EXPECT_TRUE(checkOutputFile(beside / "new.PLY", {".pdf", ".ply"}, {model}));
  EXPECT_TRUE(checkOutputFile(model, {".ply"}, {beside / "other.ply"}));
  for (const fs::path& wrong : {beside / "new.pdf", beside / "new", beside / "", model,
                                beside / "folder.ply/../model.ply", link, beside / "folder.ply"}) {
    const Result<void> checked = checkOutputFile(wrong, {".ply"}, {beside / "other.ply", model});
    ASSERT_FALSE(checked) << wrong;
    EXPECT_EQ(checked.error().code, ErrorCode::UnusableInput);
    EXPECT_EQ(checked.error().where, wrong.string());
  }
  EXPECT_FALSE(checkOutputFile(project / "new.ply", {".ply"}));
}

TEST_F(OutputPlaces, AreGoodEverywhereElse) {
  for (const char* place : {"beside", "beside/new", "not/there/yet", "Grabung ü 10", "archive2/"})
    allowed(root / place);
  allowed({});
  allowed("/");
}

TEST_F(OutputPlaces, AreFoundBehindDotsAndFromTheCurrentFolder) {
  refused(beside / ".." / "archive" / "new", archive);
  refused(root / "absent" / ".." / "archive" / "new", archive);
  allowed(project / ".." / "beside" / "new");
  fs::current_path(project / "batches");
  refused("new", project);
  refused("../../archive/new", archive);
  refused(".", project);
  allowed("../../beside/new");
}

TEST_F(OutputPlaces, AreFoundBehindLinks) {
  fs::create_directory_symlink(project / "batches", beside / "link");
  refused(beside / "link" / "new", project);
  refused(root / "absent" / ".." / "beside" / "link" / "new", project);
  fs::create_symlink(archive / "not yet" / "there", beside / "dangling");
  refused(beside / "dangling", archive);
  refused(beside / "dangling" / "new", archive);
  fs::create_symlink("../Grabung ü 1/plate.pdf", beside / "plate.pdf");
  refused(beside / "plate.pdf", project);
  fs::create_directory_symlink(beside, project / "out");
  allowed(project / "out" / "new");
  fs::create_symlink(beside / "round", beside / "round");
  allowed(beside / "round");  // who writes there says that it is one
}

TEST_F(OutputPlaces, OfWhatFillsAProjectAreItsOwnFoldersAlone) {
  allowed(project / "results" / "B0001", "results");
  allowed(project / "results" / "B0001" / "", "results");
  allowed(project / "batches" / "B0001", "batches");
  for (const char* below :
       {"", "results", "results/", "results/B0001/more", "batches/B0002", "new"})
    refused(project / below, project, "results");
  refused(archive / "data" / "results" / "B0001", archive, "results");
  allowed(beside / "out", "results");
}

TEST_F(OutputPlaces, OfWhatFillsAProjectAreNoLinks) {
  const fs::path link = project / "results" / "B0001";
  fs::create_directories(project / "results" / "B0002");
  for (const fs::path& target : {beside, project / "results" / "B0002", beside / "not yet"}) {
    fs::create_symlink(target, link);
    for (const fs::path& place : {link, link / ""}) {
      const Result<void> out = checkOutputPlace(place, "results");
      ASSERT_FALSE(out) << target;
      EXPECT_EQ(out.error().where, link.string());
    }
    fs::remove(link);
  }
  EXPECT_TRUE(checkNoLinkInProject(link)) << "nothing is there yet";
  fs::remove_all(project / "batches");
  fs::create_directory_symlink(beside, project / "batches");
  const Result<void> batch = checkNoLinkInProject(project / "batches" / "B0001");
  ASSERT_FALSE(batch);
  EXPECT_EQ(batch.error().where, (project / "batches").string());
  fs::create_directory_symlink(beside, root / "linked");
  EXPECT_TRUE(checkNoLinkInProject(root / "linked" / "out")) << "in no project";
  fs::create_directory_symlink(project, root / "way");
  EXPECT_TRUE(checkNoLinkInProject(root / "way" / "results" / "B0003")) << "a link to a project";
}

TEST_F(OutputPlaces, OfAProjectAreNotReachedThroughAnotherProject) {
  std::ofstream(beside / "catalogue.sqlite") << "another project's";
  fs::create_directories(project / "models");
  const fs::path link = project / "models" / "B0001";
  fs::create_directory_symlink(beside, link);
  for (const fs::path& place : {link, link / "results", link / "results" / "B0001"}) {
    const Result<void> reached = checkNoLinkInProject(place);
    ASSERT_FALSE(reached) << place;
    EXPECT_EQ(reached.error().where, link.string());
  }
}

TEST_F(OutputPlaces, FoldersThatAreEmptiedAreNoLinks) {
  constexpr std::string_view kNames[] = {"work", "sherds", "not/there"};
  const fs::path out = root / "out", thesis = beside / "thesis.txt";
  std::ofstream(thesis) << "mine";
  fs::create_directories(out / "work" / "masks");
  fs::create_directories(out / "sherds");
  fs::create_symlink(thesis, out / "work" / "photograph.jpg");
  fs::create_directory_symlink(beside, out / "mine");
  EXPECT_TRUE(checkNoLinkedFolder(out, kNames, LinkedFolders::AndBelow))
      << "a link to a file, and one that is none of these names";
  const Result<void> file = checkNoLinkedFolder(out, kNames, LinkedFolders::AndLinksToFiles);
  ASSERT_FALSE(file);
  EXPECT_EQ(file.error().where, (out / "work" / "photograph.jpg").string());
  fs::create_directory_symlink(beside, out / "work" / "masks" / "more");
  EXPECT_TRUE(checkNoLinkedFolder(out, kNames, LinkedFolders::OfTheseNames));
  const Result<void> below = checkNoLinkedFolder(out, kNames, LinkedFolders::AndBelow);
  ASSERT_FALSE(below);
  EXPECT_EQ(below.error().where, (out / "work" / "masks" / "more").string());
  fs::remove(out / "sherds");
  fs::create_directory_symlink(beside, out / "sherds");
  const Result<void> itself = checkNoLinkedFolder(out, kNames, LinkedFolders::OfTheseNames);
  ASSERT_FALSE(itself);
  EXPECT_EQ(itself.error().where, (out / "sherds").string());
}

}  // namespace
}  // namespace ostraka
