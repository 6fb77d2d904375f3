#include "stages/publish.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "files/files.h"

namespace ostraka::stages {
namespace {

namespace fs = std::filesystem;

TEST(Publish, RemovesOfStaleSherdsOnlyWhatTheProgramWrote) {
  std::string pattern = (fs::temp_directory_path() / "ostraka_publish_XXXXXX").string();
  const fs::path out = ::mkdtemp(pattern.data()), sherds = out / "sherds";
  for (const char* name : {"01/model.ply", "02/model.ply", "02/.back.ply.0123456789ab.partial",
                           "03/merged.ply", "03/note.txt", "anna/model.ply"})
    ASSERT_TRUE(writeFileAtomically(sherds / name, "x")) << name;
  removeStaleSherds(out, {"01"});
  EXPECT_TRUE(fs::exists(sherds / "01/model.ply")) << "a sherd of this run";
  EXPECT_FALSE(fs::exists(sherds / "02"));
  EXPECT_FALSE(fs::exists(sherds / "03/merged.ply"));
  EXPECT_TRUE(fs::exists(sherds / "03/note.txt")) << "a person's";
  EXPECT_TRUE(fs::exists(sherds / "anna/model.ply")) << "no sherd's number";
  fs::remove_all(out);
}

}  // namespace
}  // namespace ostraka::stages
