// Every command that makes something new, told to make it in a project or in an archive: it refuses
// with one sentence that names the owner of the place, and leaves the folder as it was.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>

#include "files/files.h"

namespace {

namespace fs = std::filesystem;

struct Ran {
  int status = -1;
  std::string text;
};

// @ stands for the test's folder, % for the place.
constexpr const char* kOutputs[] = {
    "catalogue new -o % --code NEW",
    "catalogue restore @/archive -o %",
    "catalogue archive @/other -o %",
    "catalogue archive @/project -o %",
    "catalogue export @/other -o % --forms csv",
    "catalogue export @/project -o % --forms csv",
    "catalogue import @/other @/sherds.csv --refusals %/why.csv",
    "plate -o %/plate.pdf",
    "draw @/model.ply -o %/sheet.svg",
    "rig simulate -o % --sherds 1 --width 160 --stops 4",
    "rig calibrate @/fronts -o %/RIG.json",
    "rig predict @/RIG.json --work %",
    "register --front @/fronts --back @/fronts -o %",
    "dense @/fronts --cameras @/cameras.json -o %/cloud.ply",
    "process @/fronts -o %",
    "capture --rig virtual --side front --sherds 1 --width 160 --stops 4 --settle 0 -o %",
};

class OutputPlace : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::canonical(fs::path(testing::TempDir())) /
              ("ostraka output " + std::to_string(::getpid()));
    fs::remove_all(folder_);
    fs::create_directories(folder_ / "fronts");
    std::ofstream(folder_ / "fronts" / "a.jpg") << "JPEG";
    std::ofstream(folder_ / "sherds.csv") << "number,site,trench,context,part,weight_g\n"
                                             "ARM1-T3-0012-0001,ARM1,T3,0012,rim,23\n";
    for (const char* project : {"project", "other"}) {
      expectDone("catalogue new --code ARM -o @/" + std::string(project));
      expectDone("catalogue import --make-places --enter @/" + std::string(project) +
                 " @/sherds.csv");
    }
    expectDone("catalogue archive @/other -o @/archive");
  }
  void TearDown() override { fs::remove_all(folder_); }

  Ran run(const std::string& words, const std::string& place = {}) const {
    std::string command = OSTRAKA_PROGRAM " ";
    for (const char letter : words)
      command += letter == '@'   ? "'" + folder_.string() + "'"
                 : letter == '%' ? "'" + (folder_ / place).string() + "'"
                                 : std::string(1, letter);
    Ran ran;
    std::FILE* pipe = ::popen((command + " 2>&1").c_str(), "r");
    std::array<char, 4096> buffer;
    while (const std::size_t n = std::fread(buffer.data(), 1, buffer.size(), pipe))
      ran.text.append(buffer.data(), n);
    const int status = ::pclose(pipe);
    ran.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return ran;
  }
  void expectDone(const std::string& words) const {
    const Ran ran = run(words);
    EXPECT_EQ(ran.status, 0) << words << ": " << ran.text;
  }

  // Names and content of all that is there.
  std::map<std::string, std::string> tree() const {
    std::map<std::string, std::string> found;
    for (const auto& entry : fs::recursive_directory_iterator(folder_))
      found[entry.path().lexically_relative(folder_)] =
          entry.is_regular_file() ? ostraka::sha256(*ostraka::readFile(entry.path())) : "";
    return found;
  }
  fs::path folder_;
};

TEST_F(OutputPlace, IsRefusedInAProjectAndInAnArchiveWhichStayAsTheyWere) {
  const std::pair<const char*, const char*> places[] = {{"project/new", "project"},
                                                        {"project/batches/B0007/new", "project"},
                                                        {"archive/new", "archive"},
                                                        {"archive/data/batches/new", "archive"}};
  const auto before = tree();
  for (const auto& [place, owner] : places)
    for (const char* command : kOutputs) {
      const Ran ran = run(command, place);
      EXPECT_EQ(ran.status, 2) << command << " " << place << ": " << ran.text;
      const std::string named = "'" + (folder_ / owner).string() + "'";
      EXPECT_NE(ran.text.find(named), std::string::npos) << command << ": " << ran.text;
      EXPECT_EQ(tree(), before) << command << " " << place;
    }
}

TEST_F(OutputPlace, OfABatchAndItsResultsIsTheirFolderOfAProject) {
  const auto before = tree();
  const std::string process = "process @/fronts -o %";
  const std::string capture = "capture --rig @/none.json --side front -o %";
  for (const std::string& command : {process, capture})
    for (const char* place : {"project", "project/results", "project/batches", "project/models/B1",
                              "project/results/B0001/more", "archive/data/results/B0001"})
      EXPECT_NE(run(command, place).text.find("belongs to"), std::string::npos) << place;
  EXPECT_EQ(tree(), before);
  EXPECT_EQ(run(process, "project/results/B0001").text.find("belongs to"), std::string::npos);
  EXPECT_EQ(run(capture, "project/batches/B0001").text.find("belongs to"), std::string::npos);
  EXPECT_NE(run(process, "project/batches/B0001").text.find("belongs to"), std::string::npos);
}

}  // namespace
