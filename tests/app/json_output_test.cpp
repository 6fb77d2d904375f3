// What each command prints with --json follows its schema in docs/schemas, which is named after the
// command: rig-simulate.json.
#include <gmock/gmock.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <set>
#include <string>
#include <vector>

#include "catalogue/batches.h"
#include "cloud/ply.h"
#include "json_schema.h"
#include "program.h"
#include "tests/core/catalogue/result_folder.h"
#include "upkeep/project.h"

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const fs::path kSchemas = fs::path(OSTRAKA_SOURCE_DIR) / "docs/schemas";

std::string textOf(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string joinedLines(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

std::map<std::string, json> schemas() {
  std::map<std::string, json> all;
  for (const fs::directory_entry& entry : fs::directory_iterator(kSchemas)) {
    EXPECT_EQ(entry.path().extension(), ".json") << entry.path();
    all[entry.path().stem().string()] = json::parse(textOf(entry.path()), nullptr, false);
  }
  return all;
}

// In this order; @ stands for the test's folder.
struct Printed {
  const char* schema;
  const char* arguments;
};
constexpr Printed kQuick[] = {
    {"doctor", "doctor @"},
    {"devices", "devices"},
    {"completion", "completion zsh"},
    {"man-pages", "man-pages @/man"},
    {"plate", "plate -o @/plate.pdf --diameter 200"},
    {"plate", "plate -o @/man/sheet.pdf --sheet a4"},
    {"draw", "draw @/a.ply -o @/a.svg"},
    {"evaluate", "evaluate @/a.ply --truth @/a.ply"},
    {"rig-simulate", "rig simulate --scans-only --sherds 2 -o @/scans"},
    {"register", "register --front @/scans/front --back @/scans/back -o @/registered"},
    {"register", "register --front @/scans/front --back @/scans/back -o @/paper --pairing paper"},
    {"evaluate", "evaluate @/registered --truth @/scans"},
    {"catalogue-new", "catalogue new -o @/p --code ARM"},
    {"catalogue-import", "catalogue import @/p @/sherds.csv --make-places"},
    {"catalogue-import", "catalogue import @/p @/sherds.csv --make-places --enter --confirm all"},
    {"catalogue-import", "catalogue import @/p @/changed.csv"},
    {"catalogue-export", "catalogue export @/p -o @/export --forms csv,json,ply"},
    {"catalogue-export", "catalogue export @/p -o @/web --forms csv,glb --size web"},
    {"catalogue-import", "catalogue import @/p @/export"},
    {"catalogue-repair", "catalogue repair @/p"}};
// Of a project with results, and of the same with a damaged file.
constexpr Printed kWithResults[] = {{"catalogue-enter", "catalogue enter @/p B0001"},
                                    {"catalogue-archive", "catalogue archive @/p -o @/archive"},
                                    {"catalogue-restore", "catalogue restore @/archive -o @/q"},
                                    {"catalogue-check", "catalogue check @/p"}};
constexpr Printed kDamaged[] = {
    {"catalogue-check", "catalogue check @/p"},
    {"catalogue-archive", "catalogue archive @/p -o @/damaged --with-damage"},
    {"catalogue-restore", "catalogue restore @/damaged -o @/r"}};
// Two projects that gave the same numbers, and the merge of them.
constexpr Printed kTwoProjects[] = {
    {"catalogue-new", "catalogue new -o @/a --code ARM"},
    {"catalogue-import", "catalogue import @/a @/sherds.csv --make-places --enter --confirm all"},
    {"catalogue-new", "catalogue new -o @/b --code ARM"},
    {"catalogue-import", "catalogue import @/b @/sherds.csv --make-places --enter --confirm all"}};
constexpr Printed kMerge = {"catalogue-merge", "catalogue merge @/a @/b"};
constexpr Printed kSettledMerge = {"catalogue-merge",
                                   "catalogue merge @/a @/b --settle @/settled.json"};
constexpr Printed kCluster[] = {
    {"cluster-submit", "cluster submit @/p --cores 1 --program @/bin/ostraka-there"},
    {"cluster-status", "cluster status @/p"},
    {"cluster-collect", "cluster collect @/p"}};
constexpr Printed kPhotographs[] = {
    {"capture",
     "capture --rig virtual --side both --width 160 --stops 4 --sherds 1 --settle 0 -o @/small"},
    {"rig-simulate", "rig simulate --sherds 2 --width 400 --stops 5 -o @/batch"}};
constexpr Printed kOfPhotographs[] = {
    {"rig-calibrate", "rig calibrate @/batch -o @/rig.json"},
    {"rig-calibrate", "rig calibrate @/batch -o @/wrong.json --length 0,1,50"},
    {"process", "process @/batch -o @/out"},
    {"evaluate", "evaluate @/out --truth @/batch/truth"},
    {"draw", "draw @/out/sherds/01/model.ply -o @/sherd.svg"},
    {"draw", "draw @/out/sherds/01/model.ply -o @/sherd.tif --surface orthophoto --dpi 600"},
    {"dense", "dense @/batch --cameras @/fronts.json -o @/cloud.ply"},
    {"rig-predict", "rig predict @/rig.json --width 400 --sherds-per-size 1 --moves 0"}};

class JsonOutput : public testing::Test {
 protected:
  void SetUp() override {
    if (const char* path = std::getenv("PATH")) path_ = path;
    folder_ = fs::path(testing::TempDir()) / ("ostraka_json_" + std::to_string(::getpid()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    ostraka::TriangleMesh mesh;  // a tetrahedron of 30 mm
    mesh.vertices = {{0, 0, 0}, {30, 0, 0}, {0, 30, 0}, {0, 0, 30}};
    mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    ASSERT_TRUE(ostraka::writePly(folder_ / "a.ply", mesh, "model"));
    std::ofstream(folder_ / "sherds.csv") << "number,site,trench,context,part,rim_diameter_mm\n"
                                             "X-1,ARM1,T3,0012,rim,180\n"
                                             "X-2,ARM1,T3,0012,wing,\n"
                                             "X-3,ARM1,T3,0012,rim,0.24\n";
    std::ofstream(folder_ / "changed.csv") << "number,part,Gewicht\nX-1,base,0.02\n";
  }
  void TearDown() override {
    ::setenv("PATH", path_.c_str(), 1);
    fs::remove_all(folder_);
  }

  // Results, not errors.
  template <std::size_t N>
  void expectAllFollow(const Printed (&commands)[N]) {
    for (const Printed& command : commands) {
      expectFollows(command);
      EXPECT_FALSE(printed_.contains("error")) << command.arguments << ": " << printed_;
    }
  }

  // And what is spoilt in any place follows it no more.
  void expectFollows(const Printed& command) {
    std::string arguments = command.arguments;
    for (std::size_t at = 0; (at = arguments.find('@')) != std::string::npos;)
      arguments.replace(at, 1, folder_.string());
    const ostraka::Outcome printed = ostraka::run("--json " + arguments, "2>/dev/null");
    const json& value = printed_ = json::parse(printed.text, nullptr, false);
    ASSERT_TRUE(value.is_object()) << arguments << ": " << printed.text;
    EXPECT_EQ(value.value("exit_status", -1), printed.status) << arguments;
    const json schema = json::parse(textOf(kSchemas / (std::string(command.schema) + ".json")));
    const std::vector<std::string> lines = ostraka::schema::violations(schema, value);
    EXPECT_TRUE(lines.empty()) << arguments << ":\n" << joinedLines(lines);
    expectSpoiltFails(schema, value, value, json::json_pointer());
  }

  // Another key, or a value of another kind; of lists in the first item.
  void expectSpoiltFails(const json& schema, const json& whole, const json& part,
                         const json::json_pointer& at) {
    const auto expectFails = [&](const json& spoilt, const json::json_pointer& place) {
      EXPECT_FALSE(ostraka::schema::violations(schema, spoilt).empty())
          << place.to_string() << " may be spoilt: " << spoilt[place].dump();
    };
    if (part.is_array() && !part.empty()) {
      expectSpoiltFails(schema, whole, part[0], at / std::size_t{0});
    } else if (part.is_object()) {
      json strange = whole;
      strange[at / "strange"] = 1;
      expectFails(strange, at / "strange");
      for (const auto& [key, value] : part.items())
        expectSpoiltFails(schema, whole, value, at / key);
    }
    if (at.empty()) return;
    json other = whole;
    other[at] = {{"other", true}};
    expectFails(other, at);
  }

  fs::path folder_;
  std::string path_;
  json printed_;  // by the last command
};

// The manual pages are made from the options of the program: one for each command, also for those
// that only hold others.
std::set<std::string> commandsWithJson(const fs::path& folder) {
  EXPECT_EQ(ostraka::run("man-pages " + folder.string()).status, 0);
  std::set<std::string> pages, commands;
  const std::string program = "ostraka-";
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (const std::string name = entry.path().stem().string();
        name.starts_with(program) && textOf(entry.path()).find("\\-\\-json") != std::string::npos)
      pages.insert(name.substr(program.size()));
  for (const std::string& name : pages) {
    const auto next = pages.upper_bound(name);
    if (next == pages.end() || !next->starts_with(name + "-")) commands.insert(name);
  }
  commands.insert("man-pages");  // for packagers, without a page
  return commands;
}

TEST_F(JsonOutput, EachCommandHasASchemaAndEachSchemaACommandThatIsRunHere) {
  std::set<std::string> named, run;
  for (const auto& [name, schema] : schemas()) named.insert(name);
  EXPECT_GT(named.size(), 10u);
  EXPECT_THAT(named, testing::ContainerEq(commandsWithJson(folder_ / "man")));
  for (const Printed& command : kQuick) run.insert(command.schema);
  for (const Printed& command : kWithResults) run.insert(command.schema);
  run.insert(kMerge.schema);
  for (const Printed& command : kCluster) run.insert(command.schema);
  for (const Printed& command : kPhotographs) run.insert(command.schema);
  for (const Printed& command : kOfPhotographs) run.insert(command.schema);
  EXPECT_THAT(run, testing::ContainerEq(named));
}

// Each property says what it is, and nothing may stand in an object beside its properties; what is
// not required says when it is absent.
void expectDescribed(const json& schema, const std::string& at) {
  if (schema.is_object() && schema.contains("properties") && schema["properties"].is_object()) {
    EXPECT_EQ(schema.value("additionalProperties", json()), false) << at;
    const json required = schema.value("required", json::array());
    for (const auto& [name, property] : schema["properties"].items()) {
      const std::string words = property.value("description", "");
      EXPECT_FALSE(words.empty()) << at << "/" << name;
      if (std::find(required.begin(), required.end(), name) == required.end()) {
        EXPECT_NE(words.find("absent"), std::string::npos) << at << "/" << name;
      }
    }
  }
  if (schema.is_structured())
    for (const auto& [name, part] : schema.items()) expectDescribed(part, at + "/" + name);
}

TEST_F(JsonOutput, SchemasUseOnlyWhatIsCheckedAndDescribeEachProperty) {
  for (const auto& [name, schema] : schemas()) {
    ASSERT_TRUE(schema.is_object()) << name;
    EXPECT_TRUE(schema.contains("$schema")) << name;
    const std::vector<std::string> lines = ostraka::schema::faults(schema);
    EXPECT_TRUE(lines.empty()) << name << ":\n" << joinedLines(lines);
    expectDescribed(schema, name);
  }
}

TEST_F(JsonOutput, ErrorsFollowTheSchemaOfTheirCommandToo) {
  for (const auto& [name, schema] : schemas()) {
    std::string command = name;
    for (const char* group : {"rig-", "catalogue-", "cluster-"})
      if (command.starts_with(group)) command[command.find('-')] = ' ';
    const ostraka::Outcome refused = ostraka::run("--json " + command + " --zz", "2>/dev/null");
    const json value = json::parse(refused.text, nullptr, false);
    ASSERT_TRUE(value.is_object()) << command << ": " << refused.text;
    EXPECT_TRUE(value.contains("error")) << command;
    const std::vector<std::string> lines = ostraka::schema::violations(schema, value);
    EXPECT_TRUE(lines.empty()) << command << ":\n" << joinedLines(lines);
  }
}

// A batch of the project, with results of two sherds.
void makeResults(const fs::path& folder) {
  auto project = ostraka::upkeep::Project::open(folder);
  ASSERT_TRUE(project);
  ASSERT_TRUE(ostraka::catalogue::Batches(project->catalogue()).add({}, {}));
  ostraka::catalogue::ResultFolder(project->resultsFolder("B0001"), 2);
}

TEST_F(JsonOutput, ResultsFollowTheirSchemas) {
  expectAllFollow(kQuick);
  makeResults(folder_ / "p");
  expectAllFollow(kWithResults);
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder_ / "p"))
    if (entry.path().filename() == "preview.png") std::ofstream(entry.path()) << "damaged";
  expectAllFollow(kDamaged);
}

void removeAll(const fs::path& folder, const std::string& name) {
  std::vector<fs::path> found;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().filename() == name) found.push_back(entry.path());
  EXPECT_FALSE(found.empty()) << folder;
  for (const fs::path& file : found) fs::remove(file);
}

TEST_F(JsonOutput, MergesFollowTheirSchemaWithConflictsSettledAndWithout) {
  expectAllFollow(kTwoProjects);
  makeResults(folder_ / "a");
  makeResults(folder_ / "b");
  EXPECT_EQ(ostraka::run("catalogue enter " + (folder_ / "b").string() + " B0001").status, 0);
  removeAll(folder_ / "b/models", "preview.png");

  expectFollows(kMerge);
  EXPECT_EQ(printed_["exit_status"], 3) << printed_;
  ASSERT_FALSE(printed_["conflicts"].empty()) << printed_;
  EXPECT_EQ(printed_["merged"], false);
  json settled = json::array();
  for (const json& conflict : printed_["conflicts"])
    settled.push_back({{"id", conflict.at("id")}, {"take", "a"}});
  std::ofstream(folder_ / "settled.json") << settled;
  expectFollows(kSettledMerge);
  EXPECT_EQ(printed_["exit_status"], 1) << printed_;
  EXPECT_EQ(printed_["missing"].size(), 2u) << printed_;
  EXPECT_EQ(printed_["batches"], json::object({{"B0001", "B0002"}})) << printed_;
  expectFollows(kMerge);
  EXPECT_EQ(printed_["exit_status"], 1) << "they are still missing: " << printed_;
  EXPECT_TRUE(printed_["conflicts"].empty()) << printed_;
}

void program(const fs::path& file, const std::string& text) {
  std::ofstream(file) << "#!/bin/sh\n" << text;
  fs::permissions(file, fs::perms::owner_all);
}

// Of each side of each batch four photographs.
void makeQueuedBatches(const fs::path& project_folder, int count) {
  auto project = ostraka::upkeep::Project::open(project_folder);
  ASSERT_TRUE(project);
  ostraka::catalogue::Batches batches(project->catalogue());
  for (int i = 0; i < count; ++i) {
    const auto row = batches.add({}, {});
    ASSERT_TRUE(row);
    for (const char* side : {"front", "back"}) {
      const fs::path photographs = project->batchFolder(batches.get(*row)->number) / side;
      fs::create_directories(photographs);
      for (int position = 0; position < 4; ++position)
        ASSERT_TRUE(
            cv::imwrite((photographs / ("cam0_pos0" + std::to_string(position) + ".png")).string(),
                        cv::Mat(12, 16, CV_8UC3, cv::Scalar(40 * i, 40 * position, side[0]))));
    }
    ASSERT_TRUE(batches.setState(*row, ostraka::records::BatchState::Queued, {}));
  }
}

// A stand-in for Slurm that runs the first task at once and knows nothing of the others.
TEST_F(JsonOutput, ResultsOfAClusterFollowTheirSchemas) {
  const fs::path bin = folder_ / "bin", prepared = folder_ / "prepared";
  ostraka::run("catalogue new --code ARM -o " + (folder_ / "p").string());
  makeQueuedBatches(folder_ / "p", 2);
  fs::create_directories(bin);
  fs::create_symlink("/usr/bin/env", bin / "env");  // of ostraka::run
  ::setenv("PATH", bin.c_str(), 1);
  expectFollows(kCluster[0]);
  EXPECT_TRUE(printed_.contains("error")) << "without Slurm: " << printed_;

  const ostraka::catalogue::ResultFolder results(prepared, 2);
  ostraka::catalogue::ResultFolder::noteInputs(prepared, folder_ / "p/batches/B0001");
  program(bin / "ostraka-there", "mkdir -p \"$4\" && cp -r '" + prepared.string() + "/.' \"$4\"\n");
  program(bin / "sbatch", "SLURM_ARRAY_TASK_ID=1 bash \"$2\" > /dev/null 2>&1\necho 4711\n");
  for (const char* silent : {"squeue", "sacct"}) program(bin / silent, "exit 0\n");
  program(bin / "df", "echo 'disk 999999999 1 999999999 1% /'\n");
  ::setenv("PATH", (bin.string() + ":" + path_).c_str(), 1);
  expectFollows(kCluster[0]);
  EXPECT_EQ(printed_["batches"], json::array({"B0001", "B0002"})) << printed_;
  expectFollows(kCluster[1]);
  EXPECT_EQ(printed_["done"], 1) << printed_;
  EXPECT_EQ(printed_["failed"], 1) << printed_;
  expectFollows(kCluster[2]);
  EXPECT_EQ(printed_["batches"], json::array({"B0001"})) << printed_;
  EXPECT_EQ(printed_["left"][0]["cause"], "lost") << printed_;
}

// One side's cameras: dense reconstruction of it takes half the time.
void writeFronts(const fs::path& cameras, const fs::path& to) {
  json fronts = json::parse(textOf(cameras));
  json images = json::array();
  for (const json& image : fronts.at("images"))
    if (image.at("file").get<std::string>().starts_with("front/")) images.push_back(image);
  EXPECT_LT(images.size(), fronts["images"].size());
  fronts["images"] = images;
  std::ofstream(to) << fronts;
}

TEST_F(JsonOutput, ResultsFromPhotographsFollowTheirSchemas) {
  expectAllFollow(kPhotographs);
  writeFronts(folder_ / "batch/truth/cameras.json", folder_ / "fronts.json");
  expectAllFollow(kOfPhotographs);
}

}  // namespace
