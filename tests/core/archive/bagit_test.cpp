#include "archive/bagit.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "files/files.h"
#include "tests/core/archive/written_bag.h"

namespace ostraka::archive {
namespace {

namespace fs = std::filesystem;

using Bag = WrittenBag;

TEST_F(Bag, IsWholeForUsAndForTheWorld) {
  write();
  const auto files = check();
  ASSERT_TRUE(files) << files.error().sentence();
  EXPECT_EQ(files->size(), 2u);
  EXPECT_FALSE(fs::exists(target.string() + ".partial"));
  const std::string command =
      "cd '" + target.string() +
      "' && sha256sum --quiet --strict -c manifest-sha256.txt tagmanifest-sha256.txt";
  EXPECT_EQ(std::system(command.c_str()), 0);
  const std::string info = *readFile(target / "bag-info.txt");
  EXPECT_NE(info.find("External-Description: two lines\n"), std::string::npos);
  EXPECT_NE(info.find("Payload-Oxum: 9.2\n"), std::string::npos);
}

TEST_F(Bag, WithoutItsEndLeavesNothing) {
  {
    Result<BagWriter> bag = BagWriter::begin(target);
    ASSERT_TRUE(bag);
    ASSERT_TRUE(bag->add("a", "b"));
    EXPECT_TRUE(fs::exists(target.string() + ".partial"));
  }
  EXPECT_FALSE(fs::exists(target));
  EXPECT_FALSE(fs::exists(target.string() + ".partial"));
}

// Of a stranger that happens to bear the name, and of a link that was planted there.
TEST_F(Bag, LeavesAFolderOfItsUnfinishedNameAloneThatItDidNotMake) {
  const fs::path partial = target.string() + ".partial";
  fs::create_directories(partial);
  std::ofstream(partial / "letter.txt") << "mine";
  EXPECT_FALSE(BagWriter::begin(target));
  EXPECT_EQ(*readFile(partial / "letter.txt"), "mine");
  fs::rename(partial, folder.path() / "mine");
  fs::create_directories(folder.path() / "mine/content");
  std::ofstream(folder.path() / "mine/content/letter.txt") << "mine";
  fs::remove(folder.path() / "mine/letter.txt");
  fs::create_directory_symlink(folder.path() / "mine", partial);
  EXPECT_FALSE(BagWriter::begin(target));
  EXPECT_EQ(*readFile(folder.path() / "mine/content/letter.txt"), "mine");
}

TEST_F(Bag, TakesANameWithASlashAtItsEnd) {
  target /= "";
  write();
  EXPECT_EQ(why(), "accepted");
}

TEST_F(Bag, NeverWritesOverAnotherFolder) {
  write();
  EXPECT_FALSE(BagWriter::begin(target));
}

TEST_F(Bag, NamesThatCouldBeMistakenAreRefused) {
  Result<BagWriter> bag = BagWriter::begin(target);
  ASSERT_TRUE(bag->add("a/B.txt", "1"));
  EXPECT_FALSE(bag->add("a/b.TXT", "2")) << "the same file on other systems";
  for (const char* name : {"../x", "/x", "a\nb", "a\\b", "\xFF.jpg", "", "a/../b"})
    EXPECT_FALSE(bag->add(name, "2")) << name;
  EXPECT_FALSE(bag->addFile("c", folder.path() / "not there", {}));
}

TEST_F(Bag, NamesWithPerCentSignsAreEncodedInTheManifestAlone) {
  Result<BagWriter> bag = BagWriter::begin(target);
  const std::vector<std::string> names = {"%.jpg", "%25.jpg", "50%/%2525%0A.jpg"};
  for (const std::string& name : names) {
    ASSERT_TRUE(bag->add(name, name)) << name;
    EXPECT_EQ(fromManifest(inManifest(name)), name);
  }
  ASSERT_TRUE(bag->finish({}));
  const auto files = check();
  ASSERT_TRUE(files) << files.error().sentence();
  ASSERT_EQ(files->size(), names.size());
  for (const BagFile& file : *files) EXPECT_EQ("data/" + *readFile(target / file.path), file.path);
  const std::string manifest = *readFile(target / "manifest-sha256.txt");
  EXPECT_NE(manifest.find("  data/50%25/%252525%250A.jpg\n"), std::string::npos) << manifest;
  for (const char* name : {"data/50%.jpg", "data/%41", "%"})
    EXPECT_EQ(fromManifest(name), name) << "of a program that encodes nothing";
  EXPECT_EQ(fromManifest("a%0D%0a"), "a\r\n");
}

TEST_F(Bag, ARefusedNameIsNamedAndItsTwinToo) {
  Result<BagWriter> bag = BagWriter::begin(target);
  ASSERT_TRUE(bag->add("front/a.jpg", "1"));
  const auto twin = bag->add("front/A.jpg", "2");
  ASSERT_FALSE(twin);
  EXPECT_EQ(twin.error().where, "front/A.jpg");
  EXPECT_NE(twin.error().what.english().find("front/a.jpg"), std::string::npos);
  EXPECT_EQ(bag->add("front/\xFF.jpg", "3").error().where, "front/\xFF.jpg");
}

}  // namespace
}  // namespace ostraka::archive
