#include "stages/publish.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "files/files.h"
#include "files/json.h"
#include "stages/output_folder.h"

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

TEST(Publish, TellsFilesThatNoRunWritesFromThoseOfARun) {
  std::string pattern = (fs::temp_directory_path() / "ostraka_publish_XXXXXX").string();
  const fs::path out = ::mkdtemp(pattern.data());
  ASSERT_TRUE(writeFileAtomically(out / "work/rig/stage.json",
                                  R"({"stage": "rig", "files": {"rig.json": "", "a/b.txt": ""}})"));
  for (const char* name : {"report.json", "log.txt", "plate.json", "decisions.json",
                           "unpaired/f001.ply", "sherds/01/model.ply", "work/batch.json",
                           "work/reports.json", "work/rig/rig.json", "work/rig/a/b.txt"})
    ASSERT_TRUE(writeFileAtomically(out / name, "x")) << name;
  EXPECT_EQ(filesOfOthers(out), std::vector<std::string>());
  std::vector<std::string> others = {"a.desktop",        "sherds/01/x.txt", "sherds/anna/model.ply",
                                     "unpaired/x.ply",   "work/notes.txt",  "work/rig/c.txt",
                                     "work/pairs/a.json"};
  for (const std::string& name : others) ASSERT_TRUE(writeFileAtomically(out / name, "x"));
  fs::create_symlink("/etc/passwd", out / "pairs.json");
  others.push_back("pairs.json");
  std::sort(others.begin(), others.end());
  EXPECT_EQ(filesOfOthers(out), others);
  fs::remove_all(out);
}

// An edited figure would be taken for the program's.
TEST(Publish, NotesWhatTheReportsHoldAndWithdrawsThatWithThem) {
  std::string pattern = (fs::temp_directory_path() / "ostraka_publish_XXXXXX").string();
  const fs::path out = ::mkdtemp(pattern.data());
  ASSERT_TRUE(writeFileAtomically(out / kInputsRecord, R"({"front/a.jpg": "12ab"})"));
  ASSERT_TRUE(publishReports(out, {{"pairs", {1}}}, "<html></html>", {{"sherds", {2}}}));
  EXPECT_EQ(*readJson(out / "report.json"), nlohmann::json({{"sherds", {2}}}));
  const nlohmann::json hashes = readJson(out / kReportsRecord)->at("files");
  ASSERT_EQ(hashes.size(), 4u);
  for (const auto& [name, hash] : hashes.items())
    EXPECT_EQ(hash, sha256(*readFile(out / name))) << name;
  EXPECT_EQ(filesOfOthers(out), std::vector<std::string>());
  withdrawResults(out);
  EXPECT_EQ(std::distance(fs::directory_iterator(out / "work"), fs::directory_iterator()), 1)
      << "what was read";
  fs::remove_all(out);
}

}  // namespace
}  // namespace ostraka::stages
