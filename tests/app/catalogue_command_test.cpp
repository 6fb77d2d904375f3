// `ostraka catalogue` as a person uses it, from an empty project to an archive that comes back.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include <string>

#include "catalogue/catalogue.h"
#include "catalogue/files.h"
#include "files/files.h"
#include "records/sherd.h"
#include "upkeep/project.h"

namespace {

namespace fs = std::filesystem;
namespace catalogue = ostraka::catalogue;
namespace records = ostraka::records;
namespace upkeep = ostraka::upkeep;

class CatalogueCommand : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / ("ostraka catalogue " + std::to_string(::getpid()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    std::ofstream(folder_ / "sherds.csv") << "number,site,trench,context,part,weight_g\n"
                                             "ARM1-T3-0012-0001,ARM1,T3,0012,rim,\"23,4\"\n"
                                             "ARM1-T3-0012-0002,ARM1,T3,0012,wing,5\n";
    EXPECT_EQ(run("new -o " + at("p") + " --code ARM"), 0);
  }
  void TearDown() override { fs::remove_all(folder_); }
  std::string at(const std::string& name) const { return "'" + (folder_ / name).string() + "'"; }
  /// The exit status; what it printed as JSON is in said_.
  int run(const std::string& arguments) {
    const std::string command =
        std::string(OSTRAKA_PROGRAM) + " --json catalogue " + arguments + " 2>/dev/null";
    std::FILE* pipe = ::popen(command.c_str(), "r");
    std::string text;
    std::array<char, 4096> buffer;
    while (const std::size_t n = std::fread(buffer.data(), 1, buffer.size(), pipe))
      text.append(buffer.data(), n);
    said_ = nlohmann::json::parse(text, nullptr, false);
    const int status = ::pclose(pipe);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  fs::path folder_;
  nlohmann::json said_;
};

TEST_F(CatalogueCommand, ImportsWithAPreviewAndSaysWhatItRefuses) {
  EXPECT_EQ(run("import " + at("p") + " " + at("sherds.csv") + " --make-places"), 1);
  EXPECT_EQ(said_["new"], 1);
  EXPECT_EQ(said_["entered"], false);
  EXPECT_EQ(said_["refusals"][0]["line"], 3);
  EXPECT_EQ(said_["refusals"][0]["value"], "wing");
  EXPECT_EQ(run("import " + at("p") + " " + at("sherds.csv") +
                " --make-places --enter --refusals " + at("why.csv")),
            1);
  EXPECT_EQ(said_["new"], 1);
  EXPECT_TRUE(fs::exists(folder_ / "why.csv"));
  run("import " + at("p") + " " + at("sherds.csv") + " --enter");
  EXPECT_EQ(said_["same"], 1) << "twice gives once";
  EXPECT_EQ(run("import " + at("p") + " " + at("nothing.csv")), 2);
}

TEST_F(CatalogueCommand, WhatItExportsAndArchivesComesBack) {
  run("import " + at("p") + " " + at("sherds.csv") + " --make-places --enter");
  EXPECT_EQ(run("export " + at("p") + " -o " + at("out") + " --filter part:rim --forms csv,json"),
            0);
  EXPECT_EQ(said_["sherds"], 1);
  EXPECT_TRUE(fs::exists(folder_ / "out/data/sherds/ARM1-T3-0012-0001.json"));
  EXPECT_EQ(run("export " + at("p") + " -o " + at("out")), 2) << "never over another folder";
  EXPECT_EQ(run("export " + at("p") + " -o " + at("none") + " --filter part:lid"), 2);
  EXPECT_EQ(run("new -o " + at("q") + " --code ARM"), 0);
  EXPECT_EQ(run("import " + at("q") + " " + at("out") + " --enter"), 0);
  EXPECT_EQ(said_["new"], 1);
  EXPECT_EQ(run("archive " + at("p") + " -o " + at("archive")), 0);
  EXPECT_EQ(run("restore " + at("archive") + " -o " + at("back")), 0);
  EXPECT_EQ(run("check " + at("back")), 0);
  EXPECT_EQ(said_["whole"], true);
}

// A photograph of the project, as it was entered.
void enterPhotograph(const fs::path& project, const std::string& bytes) {
  auto opened = upkeep::Project::open(project);
  ASSERT_TRUE(opened);
  records::FileRecord file;
  file.path = "batches/B0001/front/cam0_pos00.jpg";
  file.sha256 = ostraka::sha256(bytes);
  file.bytes = static_cast<std::int64_t>(bytes.size());
  file.media_type = "image/jpeg";
  file.role = "photo";
  ASSERT_TRUE(catalogue::Files(opened->catalogue()).save(file, {}));
  ASSERT_TRUE(ostraka::writeFileAtomically(project / file.path, bytes));
}

TEST_F(CatalogueCommand, ChecksWhatIsInTheFiles) {
  enterPhotograph(folder_ / "p", "JPEG");
  const fs::path photograph = folder_ / "p/batches/B0001/front/cam0_pos00.jpg";
  EXPECT_EQ(run("check " + at("p")), 0);
  EXPECT_EQ(said_["files"], 1);
  std::ofstream(photograph) << "JPEH";
  EXPECT_EQ(run("check " + at("p") + " --quick"), 0) << "names and sizes alone";
  EXPECT_EQ(run("check " + at("p")), 1);
  EXPECT_EQ(said_["whole"], false);
  EXPECT_EQ(said_["damaged"][0]["path"], "batches/B0001/front/cam0_pos00.jpg");
  EXPECT_EQ(said_["damaged"][0]["damage"], "changed");
  fs::remove(photograph);
  EXPECT_EQ(run("check " + at("p") + " --quick"), 1);
  EXPECT_EQ(said_["damaged"][0]["damage"], "missing");
}

TEST_F(CatalogueCommand, ArchivesDamageOnlyWhenToldTo) {
  enterPhotograph(folder_ / "p", "JPEG");
  std::ofstream(folder_ / "p/batches/B0001/front/cam0_pos00.jpg") << "JPEH";
  EXPECT_EQ(run("archive " + at("p") + " -o " + at("archive")), 1);
  EXPECT_EQ(said_["sealed"], false);
  EXPECT_EQ(said_["damaged"].size(), 1u);
  EXPECT_FALSE(fs::exists(folder_ / "archive"));
  EXPECT_EQ(run("archive " + at("p") + " -o " + at("archive") + " --with-damage"), 1);
  EXPECT_EQ(said_["sealed"], true);
  EXPECT_TRUE(fs::exists(folder_ / "archive/damage.txt"));
  EXPECT_EQ(run("restore " + at("archive") + " -o " + at("back")), 1);
  EXPECT_EQ(said_["damage"].size(), 1u);
  EXPECT_TRUE(fs::exists(folder_ / "back/catalogue.sqlite"));
}

TEST_F(CatalogueCommand, RefusesAnArchiveThatWouldWriteOutsideItsProject) {
  EXPECT_EQ(run("archive " + at("p") + " -o " + at("archive")), 0);
  const fs::path bag = folder_ / "archive";
  fs::create_directories(bag / ".config/autostart");
  std::ofstream(bag / ".config/autostart/x.desktop") << "[Desktop Entry]";
  const std::string manifest = *ostraka::readFile(bag / "manifest-sha256.txt") +
                               ostraka::sha256("[Desktop Entry]") +
                               "  .config/autostart/x.desktop\n";
  std::ofstream(bag / "manifest-sha256.txt") << manifest;
  std::ofstream tags(bag / "tagmanifest-sha256.txt");
  for (const char* name : {"bagit.txt", "bag-info.txt", "manifest-sha256.txt"})
    tags << ostraka::sha256(*ostraka::readFile(bag / name)) << "  " << name << "\n";
  tags.close();
  EXPECT_EQ(run("restore " + at("archive") + " -o " + at("home/project")), 2);
  EXPECT_FALSE(fs::exists(folder_ / "home"));
}

}  // namespace
