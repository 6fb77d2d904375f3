#include "upkeep/archived_project.h"

#include <gtest/gtest.h>

#include "files/files.h"
#include "tests/core/files/temporary_folder.h"

namespace ostraka::upkeep {
namespace {

namespace fs = std::filesystem;

class ArchiveAt : public testing::Test {
 protected:
  ArchiveAt() {
    put("bag/bagit.txt");
    put("bag/data/catalogue.sqlite");
    put("project/catalogue.sqlite");
  }
  void put(const std::string& path) const {
    ASSERT_TRUE(writeFileAtomically(at(path), "x").has_value());
  }
  fs::path at(const std::string& path) const { return folder_.path() / path; }
  fs::path bag() const { return fs::canonical(at("bag")); }
  TemporaryFolder folder_;
};

TEST_F(ArchiveAt, IsTheBagOfItsFolderAndOfItsData) {
  for (const char* name : {"bag", "bag/", "bag/data", "bag/data/", "bag/data/..", "project/../bag"})
    EXPECT_EQ(archiveAt(at(name)), bag()) << name;
}

TEST_F(ArchiveAt, IsNoneOfAProjectOrOfNothing) {
  for (const char* name : {"project", "", "nowhere", "bag/data/catalogue.sqlite", "bag/bagit.txt"})
    EXPECT_EQ(archiveAt(at(name)), fs::path()) << name;
}

// A project in a folder that is called data, beside no bagit.txt; and a bag of something else.
TEST_F(ArchiveAt, IsNotToldByOneNameAlone) {
  put("data/catalogue.sqlite");
  EXPECT_EQ(archiveAt(at("data")), fs::path());
  put("other/bagit.txt");
  put("other/data/text.txt");
  EXPECT_EQ(archiveAt(at("other")), fs::path());
  put("other/catalogue.sqlite");
  EXPECT_EQ(archiveAt(at("other")), fs::path()) << "a project that somebody put a bagit.txt into";
}

TEST_F(ArchiveAt, IsFoundThroughLinks) {
  fs::create_directory_symlink(at("bag"), at("to_bag"));
  fs::create_directory_symlink(at("bag/data"), at("to_data"));
  fs::create_directories(at("beside"));
  fs::create_symlink(at("bag/data/catalogue.sqlite"), at("beside/catalogue.sqlite"));
  for (const char* name : {"to_bag", "to_data", "to_bag/data", "beside"})
    EXPECT_EQ(archiveAt(at(name)), bag()) << name;
  fs::remove(at("beside/catalogue.sqlite"));
  fs::create_symlink(at("gone"), at("beside/catalogue.sqlite"));
  EXPECT_EQ(archiveAt(at("beside")), fs::path());
}

}  // namespace
}  // namespace ostraka::upkeep
