#include "stages/output_folder.h"

#include <gmock/gmock.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <vector>

#include "files/files.h"
#include "pipeline/process_batch.h"

namespace ostraka::stages {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class OutputFolder : public testing::Test {
 protected:
  OutputFolder() {
    std::string pattern = (fs::temp_directory_path() / "ostraka_output_XXXXXX").string();
    folder = ::mkdtemp(pattern.data());
  }
  ~OutputFolder() override { fs::remove_all(folder); }

  // A name that ends with '/' is a folder.
  fs::path outputWith(const std::vector<std::string>& names) {
    fs::remove_all(folder / "out");
    fs::create_directories(folder / "out");
    for (const std::string& name : names) {
      if (name.ends_with('/'))
        fs::create_directories(folder / "out" / name);
      else
        EXPECT_TRUE(writeFileAtomically(folder / "out" / name, "x"));
    }
    return folder / "out";
  }

  fs::path folder;
};

TEST_F(OutputFolder, OfARegistrationKilledBeforeItNamedItsScansIsTakenByTheNext) {
  const std::vector<std::vector<std::string>> left = {
      {},
      {"work/"},
      {"work/", "work/lock"},
      {"work/", "work/lock", "work/.scans.json.0123456789ab.partial"}};
  for (const std::vector<std::string>& names : left) {
    const auto held = claimOutput(outputWith(names), "scans");
    ASSERT_TRUE(held.has_value()) << names.size() << ": " << held.error().sentence();
    EXPECT_TRUE(fs::exists(folder / "out/work/scans.json"));
  }
}

TEST_F(OutputFolder, OfSomethingElseIsRefusedByARegistration) {
  const std::vector<std::vector<std::string>> others = {
      {"notes.txt"},
      {"work"},
      {"work/", "notes.txt"},
      {"work/", "work/notes.txt"},
      {"work/", "work/lock", "work/batch.json"},
      {"work/", "work/lock", "work/masks_front/"}};
  for (const std::vector<std::string>& names : others) {
    const auto held = claimOutput(outputWith(names), "scans");
    ASSERT_FALSE(held.has_value()) << names.back();
    EXPECT_THAT(held.error().sentence(), HasSubstr("contains other files"));
    EXPECT_FALSE(fs::exists(folder / "out/work/scans.json"));
  }
}

TEST_F(OutputFolder, OfARegistrationIsKnownWhenAScanWasRenamed) {
  ASSERT_TRUE(claimOutput(outputWith({"work/", "work/lock"}), "scans"));
  ASSERT_TRUE(writeFileAtomically(folder / "out/report.html", "x"));
  EXPECT_TRUE(claimOutput(folder / "out", "scans"));
  const auto held = claimOutput(folder / "out", "renamed");
  ASSERT_FALSE(held.has_value());
  EXPECT_THAT(held.error().what, HasSubstr("the results of other scans"));
}

// Names alone prove no owner: a person's folders may have the same.
TEST_F(OutputFolder, WithNamesOfAResultButNoMarkIsRefusedByABatch) {
  const std::vector<std::vector<std::string>> others = {
      {"work/", "sherds/", "sherds/mine.txt"},
      {"work/", "report.html"},
      {"work/", "work/lock", "unpaired/mine.ply"},
      {"work/", "work/lock", "work/masks_front/"}};
  for (const std::vector<std::string>& names : others) {
    const fs::path out = outputWith(names);
    const auto held = claimOutput(out, batch::Batch{}, nlohmann::ordered_json::object());
    ASSERT_FALSE(held.has_value()) << names.back();
    EXPECT_EQ(held.error().code, ErrorCode::UnusableInput);
    EXPECT_TRUE(fs::exists(out / names.back()));
    EXPECT_FALSE(fs::exists(out / "work/batch.json"));
  }
}

TEST_F(OutputFolder, OfABatchKilledBeforeItsMarkOrEmptiedButForDecisionsIsTaken) {
  const std::vector<std::vector<std::string>> left = {
      {"work/", "work/lock", "work/.batch.json.0123456789ab.partial"}, {"decisions.json"}};
  for (const std::vector<std::string>& names : left) {
    const fs::path out = outputWith(names);
    const auto held = claimOutput(out, batch::Batch{}, nlohmann::ordered_json::object());
    ASSERT_TRUE(held.has_value()) << names.back() << ": " << held.error().sentence();
    EXPECT_TRUE(fs::exists(out / "work/batch.json"));
    EXPECT_EQ(fs::exists(out / "decisions.json"), names.back() == "decisions.json");
  }
}

// What lies behind the link would be removed as scans and sherds of an earlier run.
TEST_F(OutputFolder, WithALinkInPlaceOfAFolderIsRefused) {
  for (const char* name : {"work", "sherds", "sherds/01", "work/masks_front"}) {
    const fs::path out = outputWith({"work/", "work/lock", "sherds/"}), link = out / name;
    fs::remove_all(folder / "mine");
    fs::create_directories(folder / "mine");
    fs::remove_all(link);
    fs::create_directory_symlink(folder / "mine", link);
    const auto held = claimOutput(out, batch::Batch{}, nlohmann::ordered_json::object());
    ASSERT_FALSE(held.has_value()) << name;
    EXPECT_EQ(held.error().code, ErrorCode::UnusableInput) << name;
    EXPECT_EQ(held.error().where, link.string());
    EXPECT_TRUE(fs::is_empty(folder / "mine")) << name;
  }
}

TEST_F(OutputFolder, IsClearedOfAnEarlierRunsResultsAndOfNothingElse) {
  const std::vector<std::string> ours = {"report.json",
                                         "report.html",
                                         "pairs.json",
                                         "unpaired/f001.ply",
                                         "unpaired/b1234.ply",
                                         "unpaired/.f002.ply.0123456789ab.partial"},
                                 others = {"unpaired/mine.ply", "unpaired/front.ply",
                                           "unpaired/f01.ply", "unpaired/.mine.partial"};
  std::vector<std::string> all = ours;
  all.insert(all.end(), others.begin(), others.end());
  const fs::path out = outputWith(all);
  withdrawResults(out);
  for (const std::string& name : ours) EXPECT_FALSE(fs::exists(out / name)) << name;
  for (const std::string& name : others) EXPECT_TRUE(fs::exists(out / name)) << name;
}

TEST_F(OutputFolder, ThatAnotherRunHoldsIsNamedAsThePersonChoseIt) {
  const fs::path output = outputWith({});
  const auto first = claimOutput(output, "scans");
  ASSERT_TRUE(first) << first.error().sentence();
  const auto second = claimOutput(output, "scans");
  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().where, output.string()) << "not OUT/work";
  EXPECT_THAT(second.error().what, HasSubstr("this run has changed nothing"));
}

// What lies behind the link enters no catalogue, so that it is not computed either.
TEST_F(OutputFolder, AndBatchOfAProjectAreNoLinks) {
  const fs::path project = folder / "project", elsewhere = folder / "elsewhere";
  ASSERT_TRUE(writeFileAtomically(project / "catalogue.sqlite", "x"));
  for (const fs::path& place : {project / "batches", elsewhere}) fs::create_directories(place);
  pipeline::ProcessOptions options;
  options.batch = project / "batches" / "B0001";
  options.output = project / "results" / "B0001";
  EXPECT_TRUE(options.check());
  for (const fs::path& link : {options.batch, project / "results"}) {
    fs::create_directory_symlink(elsewhere, link);
    const Result<void> checked = options.check();
    ASSERT_FALSE(checked) << link;
    EXPECT_EQ(checked.error().code, ErrorCode::UnusableInput);
    EXPECT_EQ(checked.error().where, link.string());
    fs::remove(link);
  }
}

}  // namespace
}  // namespace ostraka::stages
