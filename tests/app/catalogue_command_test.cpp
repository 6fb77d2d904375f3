// `ostraka catalogue` as a person uses it, from an empty project to an archive that comes back.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include <string>

#include "catalogue/batches.h"
#include "catalogue/catalogue.h"
#include "catalogue/files.h"
#include "catalogue/settings.h"
#include "files/files.h"
#include "records/sherd.h"
#include "store/database.h"
#include "tests/core/catalogue/result_folder.h"
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
  /// What it says to a person.
  std::string words(const std::string& arguments) {
    const std::string command =
        std::string(OSTRAKA_PROGRAM) + " --quiet catalogue " + arguments + " 2>&1";
    std::FILE* pipe = ::popen(command.c_str(), "r");
    std::string text;
    std::array<char, 4096> buffer;
    while (const std::size_t n = std::fread(buffer.data(), 1, buffer.size(), pipe))
      text.append(buffer.data(), n);
    ::pclose(pipe);
    return text;
  }
  void put(const std::string& name, const std::string& text) {
    fs::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }
  std::string bytesOf(const std::string& name) { return *ostraka::readFile(folder_ / name); }
  std::string import(const std::string& table) {
    return "import " + at("p") + " " + at(table) + " --make-places ";
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

TEST_F(CatalogueCommand, PrintsTheFirstRefusalsAndCountsTheOthers) {
  std::string table = "number,site,trench,context,part\n";
  for (int i = 0; i < 50; ++i) table += "X-" + std::to_string(i) + ",ARM1,T3,0012,wing\n";
  put("many.csv", table);
  const std::string told = words(import("many.csv") + "--refusals " + at("why.csv"));
  EXPECT_NE(told.find("line 21, part 'wing'"), std::string::npos) << told;
  EXPECT_EQ(told.find("line 22, "), std::string::npos) << told;
  EXPECT_NE(told.find("30 more reasons"), std::string::npos) << told;
  EXPECT_NE(bytesOf("why.csv").find(",X-49,ARM1,T3,0012,wing\r\n"), std::string::npos);
  EXPECT_EQ(run(import("many.csv")), 1);
  EXPECT_EQ(said_["refusals"].size(), 50u);
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

TEST_F(CatalogueCommand, CallsNoCatalogueWholeThatItCouldNotRestore) {
  {
    auto opened = upkeep::Project::open(folder_ / "p");
    ASSERT_TRUE(opened);
    opened->catalogue().database().script("UPDATE project SET title = CAST(x'ff' AS TEXT)");
  }
  EXPECT_EQ(run("check " + at("p")), 2);
  EXPECT_NE(words("check " + at("p")).find("project.title"), std::string::npos);
  EXPECT_EQ(run("archive " + at("p") + " -o " + at("archive")), 2);
  EXPECT_FALSE(fs::exists(folder_ / "archive"));
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

TEST_F(CatalogueCommand, WritesRefusedRowsOverNothing) {
  put("photo.jpg", "JPEG");
  put("empty.csv", "");
  fs::create_directories(folder_ / "folder");
  ASSERT_EQ(run("export " + at("p") + " -o " + at("out") + " --forms csv"), 2) << "no sherds yet";
  ASSERT_EQ(run(import("sherds.csv") + "--enter"), 1);
  ASSERT_EQ(run("export " + at("p") + " -o " + at("out") + " --forms csv"), 0);
  put("second.csv", "number,site,trench,context\nX-9,ARM1,T3,0012\n");
  const std::string catalogue = bytesOf("p/catalogue.sqlite");
  const std::string manifest = bytesOf("out/manifest-sha256.txt");
  for (const char* target :
       {"photo.jpg", "empty.csv", "folder", "second.csv", "p/catalogue.sqlite", "p/new.csv",
        "out/manifest-sha256.txt", "out/data/new.csv", "none/new.csv"}) {
    EXPECT_EQ(run(import("second.csv") + "--enter --refusals " + at(target)), 2) << target;
    const std::string name =
        fs::path(target).parent_path() == "none" ? "none" : fs::path(target).filename().string();
    EXPECT_NE(said_["error"].get<std::string>().find(name), std::string::npos) << said_["error"];
  }
  EXPECT_EQ(run(import("second.csv") + "--refusals " + at("photo.jpg")), 2) << "nor a preview";
  EXPECT_EQ(bytesOf("photo.jpg"), "JPEG");
  EXPECT_EQ(bytesOf("p/catalogue.sqlite"), catalogue) << "nothing was entered";
  EXPECT_EQ(bytesOf("out/manifest-sha256.txt"), manifest);
  EXPECT_FALSE(fs::exists(folder_ / "none"));
  EXPECT_FALSE(fs::exists(folder_ / "p/new.csv"));
  EXPECT_EQ(run(import("sherds.csv") + "--refusals " + at("why.csv")), 1);
  EXPECT_NE(bytesOf("why.csv").find("wing"), std::string::npos);
  EXPECT_NE(bytesOf("why.csv").find("Ostraka: why this row was not imported"), std::string::npos);
  EXPECT_EQ(run(import("second.csv") + "--refusals " + at("why.csv")), 2)
      << "it may be corrected by now";
}

TEST_F(CatalogueCommand, TakesNoTableOfSherdsWithoutNumbersForBags) {
  put("bags.csv", "site,trench,context,bag,weight_g,part\nARM1,T3,0012,4,23,rim\n");
  EXPECT_EQ(run(import("bags.csv") + "--enter"), 2);
  EXPECT_NE(said_["error"].get<std::string>().find("'part' is a column of sherds"),
            std::string::npos)
      << said_["error"];
  EXPECT_EQ(run(import("bags.csv") + "--map part=-"), 0);
}

TEST_F(CatalogueCommand, EntersNoGuessedUnit) {
  const std::string head = "number;site;trench;context;Gewicht\n";
  put("kg.csv", head + "X-1;ARM1;T3;0012;0,02\nX-2;ARM1;T3;0012;0,4\n");
  put("g.csv", head + "X-3;ARM1;T3;0012;12,5\nX-4;ARM1;T3;0012;19\n");
  EXPECT_EQ(run(import("kg.csv")), 3);
  EXPECT_EQ(run(import("kg.csv") + "--enter"), 3);
  EXPECT_EQ(said_["entered"], false);
  EXPECT_EQ(said_["columns"][4]["unit_guessed"], true);
  EXPECT_EQ(said_["units_to_state"].size(), 1u);
  const std::string told = words(import("kg.csv") + "--enter");
  EXPECT_NE(told.find("--map 'Gewicht=weight_g:kg' (or g, kg, mg)"), std::string::npos) << told;
  EXPECT_NE(told.find("nothing was entered"), std::string::npos) << told;
  EXPECT_EQ(run(import("kg.csv") + "--enter --map Gewicht=weight:kg"), 0);
  EXPECT_EQ(said_["new"], 2);
  EXPECT_EQ(run(import("g.csv") + "--enter --map Gewicht=weight:g"), 0);
  EXPECT_EQ(said_["new"], 2);
}

TEST_F(CatalogueCommand, AsksAboutImplausibleMeasurements) {
  put("rims.csv",
      "number,site,trench,context,rim_diameter_mm\nX-1,ARM1,T3,0012,24\n"
      "X-2,ARM1,T3,0012,240\nX-3,ARM1,T3,0012,0.24\n");
  EXPECT_EQ(run(import("rims.csv") + "--enter"), 3);
  EXPECT_EQ(said_["to_confirm"], 3);
  EXPECT_EQ(run(import("rims.csv") + "--enter --confirm 3"), 3);
  EXPECT_EQ(said_["new"], 1);
}

TEST_F(CatalogueCommand, SaysWhichValuesChange) {
  std::string table = "number,site,trench,context,ware\n", other = table;
  for (int i = 10; i < 35; ++i) {
    const std::string row = "X-" + std::to_string(i) + ",ARM1,T3,0012,";
    table += row + "grey\n";
    other += row + "cooking\n";
  }
  put("first.csv", table);
  put("other.csv", other);
  ASSERT_EQ(run(import("first.csv") + "--enter"), 0);
  const std::string told = words(import("other.csv"));
  EXPECT_NE(told.find("X-10, ware: 'grey' becomes 'cooking'"), std::string::npos) << told;
  EXPECT_NE(told.find("5 more values change"), std::string::npos) << told;
  EXPECT_EQ(run(import("other.csv")), 0);
  EXPECT_EQ(said_["changes"].size(), 25u);
  EXPECT_EQ(said_["changes"][0]["old"], "grey");
  EXPECT_EQ(said_["changes"][0]["line"], 2);
}

TEST_F(CatalogueCommand, ThatIsInterruptedIsNotWhole) {
  std::string table = "number,site,trench,context,ware\n";
  for (int i = 0; i < 40'000; ++i) table += "X-" + std::to_string(i) + ",ARM1,T3,0012,grey\n";
  put("long.csv", table);
  const std::string project = (folder_ / "p").string(), file = (folder_ / "long.csv").string();
  const pid_t program = ::fork();
  if (program == 0) {
    ::execl(OSTRAKA_PROGRAM, OSTRAKA_PROGRAM, "--quiet", "catalogue", "import", project.c_str(),
            file.c_str(), "--enter", "--make-places", nullptr);
    ::_exit(127);
  }
  ASSERT_GT(program, 0);
  const auto begun = [&] {  // the first rows are in
    const auto opened = upkeep::Project::connect(folder_ / "p");
    const auto kept = opened ? catalogue::Settings(*opened).value("import.unfinished")
                             : ostraka::Result<std::string>(std::string());
    return kept && !kept->empty();
  };
  int status = 0;
  bool ended = false;
  while (!ended && !begun()) {
    ::usleep(20'000);
    ended = ::waitpid(program, &status, WNOHANG) != 0;
  }
  ASSERT_FALSE(ended) << status;
  ::kill(program, SIGINT);
  ASSERT_EQ(::waitpid(program, &status, 0), program);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 1);
}

// A batch of the project, with results of two sherds.
void makeResults(const fs::path& project) {
  auto opened = upkeep::Project::open(project);
  ASSERT_TRUE(opened);
  ASSERT_TRUE(catalogue::Batches(opened->catalogue()).add({}, {}));
  catalogue::ResultFolder(opened->resultsFolder("B0001"), 2);
}

TEST_F(CatalogueCommand, BacksUpBeforeAndAfterResultsAreEntered) {
  makeResults(folder_ / "p");
  EXPECT_EQ(run("enter " + at("p") + " B0001"), 0) << said_;
  EXPECT_EQ(said_["new_sherds"], 2);
  EXPECT_EQ(said_["warnings"].size(), 0u);
  EXPECT_EQ(upkeep::Project::open(folder_ / "p")->backups().size(), 2u);
}

TEST_F(CatalogueCommand, EntersTheSamePhotographsTwiceOnlyWithKeepBoth) {
  makeResults(folder_ / "p");
  put("p/batches/B0001/front/a.jpg", "the same");
  catalogue::ResultFolder::noteInputs(folder_ / "p/results/B0001", folder_ / "p/batches/B0001");
  ASSERT_EQ(run("enter " + at("p") + " B0001"), 0) << said_;
  {
    auto opened = upkeep::Project::open(folder_ / "p");
    ASSERT_TRUE(opened);
    ASSERT_TRUE(catalogue::Batches(opened->catalogue()).add({}, {}));
    catalogue::ResultFolder(opened->resultsFolder("B0002"), 2);
  }
  put("p/batches/B0002/back/b.jpg", "the same");
  catalogue::ResultFolder::noteInputs(folder_ / "p/results/B0002", folder_ / "p/batches/B0002");
  EXPECT_EQ(run("enter " + at("p") + " B0002"), 2);
  EXPECT_EQ(run("enter " + at("p") + " B0002 --keep-both"), 0) << said_;
  EXPECT_EQ(said_["new_sherds"], 2);
}

// Whichever page is damaged, also one that entering does not read.
TEST_F(CatalogueCommand, EntersNothingIntoADamagedCatalogue) {
  constexpr std::size_t kPage = 4096;
  makeResults(folder_ / "p");
  const std::string whole = bytesOf("p/catalogue.sqlite");
  for (std::size_t at_byte = 0; at_byte < whole.size(); at_byte += 6 * kPage) {
    std::string bytes = whole;
    for (std::size_t i = 2000; i < 2040; ++i) bytes[at_byte + i] ^= 0x5A;
    put("p/catalogue.sqlite", bytes);
    EXPECT_EQ(run("enter " + at("p") + " B0001"), 2) << "page " << at_byte / kPage + 1;
    EXPECT_EQ(bytesOf("p/catalogue.sqlite"), bytes) << "page " << at_byte / kPage + 1;
  }
}

TEST_F(CatalogueCommand, NamesTheFormsWithoutAnyFile) {
  ASSERT_EQ(run(import("sherds.csv") + "--enter"), 1);
  EXPECT_EQ(run("export " + at("p") + " -o " + at("both") + " --forms csv,ply,glb"), 0);
  EXPECT_EQ(said_["forms_without_file"], nlohmann::json({"glb", "ply"}));
  EXPECT_EQ(said_["without_model"].size(), said_["sherds"].get<std::size_t>());
  EXPECT_EQ(run("export " + at("p") + " -o " + at("none") + " --forms ply,glb"), 1);
  const std::string told = words("export " + at("p") + " -o " + at("once") + " --forms csv,ply");
  EXPECT_NE(told.find("No files in these formats, since the sherds have none: ply."),
            std::string::npos)
      << told;
}

TEST_F(CatalogueCommand, TwoProjectsBecomeOne) {
  run("import " + at("p") + " " + at("sherds.csv") + " --enter --make-places");
  ASSERT_EQ(run("new -o " + at("q") + " --code ARM"), 0);
  EXPECT_EQ(run("merge --dry-run " + at("q") + " " + at("p")), 0);
  EXPECT_EQ(said_["merged"], false);
  EXPECT_EQ(run("merge " + at("q") + " " + at("p")), 0);
  EXPECT_EQ(said_["merged"], true);
  EXPECT_GT(said_["added"], 0);
  EXPECT_EQ(run("merge " + at("q") + " " + at("p")), 0);
  EXPECT_EQ(said_["added"], 0);
  EXPECT_EQ(said_["changed"], 0);
  EXPECT_EQ(run("merge " + at("p") + " " + at("p")), 2);
}

}  // namespace
