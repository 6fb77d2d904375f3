// Reads the sources themselves: the order of the folders and the length of files are promises of
// the README that no compiler checks.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

// In the order of the work: a folder may use only those before it.
const std::vector<std::string> kOrder = {
    "base",    "files",       "images",    "paper",    "cloud",     "batch",
    "rig",     "calibration", "colmap",    "ground",   "hull",      "segmentation",
    "mask",    "stereo",      "scan",      "pairing",  "baselines", "registration",
    "model",   "colour",      "texture",   "drawing",  "decisions", "checks",
    "stages",  "pipeline",    "scansets",  "review",   "evaluate",  "devices",
    "cameras", "turntables",  "capture",   "vessels",  "rendering", "virtualrig",
    "store",   "records",     "catalogue", "sherds",   "upkeep",    "intake",
    "cluster", "archive",     "tables",    "metadata", "exchange",  "merge",
    "api"};
// The window's folders likewise; all of them may use core.
const std::vector<std::string> kUiOrder = {
    "words",  "jobs",    "look",   "widgets",   "frame",  "viewport", "import",
    "wizard", "capture", "masks",  "queue",     "pairs",  "review",   "map",
    "sherds", "merge",   "tables", "catalogue", "export", "settings", "main"};
constexpr int kMostLines = 500, kMostHeaderLines = 150;

fs::path root() {
  return OSTRAKA_SOURCE_DIR;
}

int rankOf(const std::string& folder) {
  const auto found = std::find(kOrder.begin(), kOrder.end(), folder);
  return found == kOrder.end() ? -1 : static_cast<int>(found - kOrder.begin());
}

bool isSource(const fs::path& file) {
  return file.extension() == ".h" || file.extension() == ".cpp";
}

std::vector<fs::path> sourcesUnder(const fs::path& folder) {
  std::vector<fs::path> files;
  if (!fs::exists(folder)) return files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && isSource(entry.path())) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<std::string> linesOf(const fs::path& file) {
  std::ifstream in(file);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

// "rig" of `#include "rig/camera.h"`; empty for all other lines.
std::string includedFolder(const std::string& line) {
  const std::string start = "#include \"";
  if (!line.starts_with(start)) return {};
  const std::size_t slash = line.find('/', start.size());
  return slash == std::string::npos ? std::string()
                                    : line.substr(start.size(), slash - start.size());
}

// What the folder's CMakeLists.txt names after DEPENDS, up to LINKS or the closing bracket.
std::vector<std::string> dependsOf(const fs::path& cmake_file) {
  std::vector<std::string> names;
  bool within = false;
  for (const std::string& line : linesOf(cmake_file)) {
    std::string word;
    for (const char c : line + " ") {
      if (!std::isspace(static_cast<unsigned char>(c)) && c != ')') {
        word += c;
        continue;
      }
      if (word == "DEPENDS")
        within = true;
      else if (word == "LINKS" || word == "SOURCES")
        within = false;
      else if (within && !word.empty())
        names.push_back(word);
      if (c == ')') within = false;
      word.clear();
    }
  }
  return names;
}

TEST(Structure, CoreHoldsOnlyTheFoldersOfTheReadme) {
  for (const fs::directory_entry& entry : fs::directory_iterator(root() / "core"))
    if (entry.is_directory() && !fs::is_empty(entry.path())) {
      EXPECT_GE(rankOf(entry.path().filename().string()), 0) << entry.path();
    }
}

TEST(Structure, NoIncludeOfCoreGoesUpwards) {
  int includes = 0;
  for (const fs::path& file : sourcesUnder(root() / "core")) {
    const std::string folder = (*std::next(file.lexically_relative(root()).begin())).string();
    for (const std::string& line : linesOf(file)) {
      const std::string included = includedFolder(line);
      if (included.empty()) continue;
      ++includes;
      EXPECT_GE(rankOf(included), 0) << file << ": " << line;
      EXPECT_LE(rankOf(included), rankOf(folder)) << file << ": " << line;
    }
  }
  EXPECT_GT(includes, 50) << "the includes were not found; is the source folder right?";
}

TEST(Structure, EveryIncludedFolderIsNamedAsADependence) {
  for (const std::string& folder : kOrder) {
    const fs::path cmake_file = root() / "core" / folder / "CMakeLists.txt";
    if (!fs::exists(cmake_file)) continue;
    const std::vector<std::string> direct = dependsOf(cmake_file);
    // What a dependence depends on comes along.
    std::vector<std::string> reached = direct;
    for (std::size_t i = 0; i < reached.size(); ++i)
      for (const std::string& next : dependsOf(root() / "core" / reached[i] / "CMakeLists.txt"))
        if (std::find(reached.begin(), reached.end(), next) == reached.end())
          reached.push_back(next);
    for (const fs::path& file : sourcesUnder(root() / "core" / folder))
      for (const std::string& line : linesOf(file)) {
        const std::string included = includedFolder(line);
        if (included.empty() || included == folder) continue;
        EXPECT_NE(std::find(reached.begin(), reached.end(), included), reached.end())
            << file << " includes " << included << ", which " << cmake_file << " does not name";
      }
  }
}

TEST(Structure, NothingInCoreIncludesTheApplication) {
  for (const fs::path& file : sourcesUnder(root() / "core"))
    for (const std::string& line : linesOf(file)) {
      EXPECT_EQ(line.find("#include \"app/"), std::string::npos) << file << ": " << line;
      EXPECT_EQ(line.find("#include \"ui/"), std::string::npos) << file << ": " << line;
      EXPECT_EQ(line.find("#include <Q"), std::string::npos) << file << ": " << line;
      EXPECT_EQ(line.find("#include <CLI"), std::string::npos) << file << ": " << line;
      EXPECT_EQ(line.find("opencv2/highgui"), std::string::npos) << file << ": " << line;
    }
}

// What the window may show needs a template, or nobody can translate it. What only terminals show
// (judging results, simulating a rig, options that programmers set) is English.
TEST(Structure, CoreRefusesAndWarnsByTemplates) {
  const std::set<std::string> of_terminals = {"evaluate", "rendering", "stereo", "virtualrig"};
  const std::regex plain(
      R"((Error::unusable|\b(refuse|bad|unusable|(sentences|warnings|troubles)\.push_back))\(\s*"|)"
      R"((ErrorCode::\w+|NoteLevel::Warning),\s*")");
  for (const std::string& folder : kOrder) {
    if (of_terminals.contains(folder)) continue;
    for (const fs::path& file : sourcesUnder(root() / "core" / folder)) {
      std::string text;
      for (const std::string& line : linesOf(file)) text += line + "\n";
      std::smatch found;
      EXPECT_FALSE(std::regex_search(text, found, plain)) << file << ": " << found.str();
    }
  }
}

// Duplicate keys, depth and size are refused by its own reader only; and only its own writers and
// openers are known to follow no link and to wait for nobody.
TEST(Structure, JsonIsParsedAndFilesAreOpenedInOneFolderAlone) {
  for (const char* part : {"core", "app", "ui"})
    for (const fs::path& file : sourcesUnder(root() / part)) {
      if (file.parent_path().filename() == "files") continue;
      for (const std::string& line : linesOf(file))
        for (const char* call : {"json::parse(", "Json::parse(", "std::ofstream", "cv::imread(",
                                 "cv::imwrite(", "temp_directory_path("})
          EXPECT_EQ(line.find(call), std::string::npos) << file << ": " << line;
    }
}

int uiRankOf(const std::string& folder) {
  const auto found = std::find(kUiOrder.begin(), kUiOrder.end(), folder);
  return found == kUiOrder.end() ? -1 : static_cast<int>(found - kUiOrder.begin());
}

TEST(Structure, NoIncludeOfTheWindowGoesUpwards) {
  int includes = 0;
  const std::string start = "#include \"ui/";
  for (const fs::path& file : sourcesUnder(root() / "ui")) {
    const std::string folder = (*std::next(file.lexically_relative(root()).begin())).string();
    EXPECT_GE(uiRankOf(folder), 0) << file;
    for (const std::string& line : linesOf(file)) {
      EXPECT_EQ(line.find("#include \"app/"), std::string::npos) << file << ": " << line;
      if (!line.starts_with(start)) continue;
      const std::string included =
          line.substr(start.size(), line.find('/', start.size()) - start.size());
      ++includes;
      EXPECT_GE(uiRankOf(included), 0) << file << ": " << line;
      EXPECT_LE(uiRankOf(included), uiRankOf(folder)) << file << ": " << line;
    }
  }
  EXPECT_GT(includes, 50) << "the includes were not found; is the source folder right?";
}

// Words that may stand in one folder of the window only.
TEST(Structure, TheWindowKeepsThreadsVtkAndSqlInTheirFolders) {
  struct Behind {
    const char* word;
    const char* folder;  // "" for none
  };
  const Behind folders[] = {{"#include <vtk", "viewport"},
                            {"std::thread", "jobs"},
                            {"std::jthread", "jobs"},
                            {"QThreadPool", "jobs"},
                            {"QtConcurrent", "jobs"},
                            {"moveToThread", "jobs"},
                            {"processEvents", ""},
                            {"QEventLoop", ""},
                            {"QSqlQuery", ""},
                            {"sqlite3_", ""},
                            {"SIGNAL(", ""}};
  for (const fs::path& file : sourcesUnder(root() / "ui")) {
    const std::string folder = (*std::next(file.lexically_relative(root()).begin())).string();
    for (const std::string& line : linesOf(file))
      for (const Behind& behind : folders)
        if (folder != behind.folder) {
          EXPECT_EQ(line.find(behind.word), std::string::npos) << file << ": " << line;
        }
  }
}

// A folder that grows gets walls.
TEST(Structure, NoFolderHoldsMoreThanThirtyFilesOrThreeAndAHalfThousandLines) {
  for (const char* top : {"core", "ui"})
    for (const fs::directory_entry& entry : fs::directory_iterator(root() / top)) {
      if (!entry.is_directory()) continue;
      const std::string name = top + ("/" + entry.path().filename().string());
      const std::vector<fs::path> files = sourcesUnder(entry.path());
      std::size_t lines = 0;
      for (const fs::path& file : files) lines += linesOf(file).size();
      EXPECT_LE(files.size(), 30u) << name;
      EXPECT_LE(lines, 3500u) << name;
    }
}

TEST(Structure, NoFileIsLongerThanFiveHundredLinesNoHeaderThanAHundredAndFifty) {
  for (const char* top : {"core", "ui", "app", "tests"})
    for (const fs::path& file : sourcesUnder(root() / top)) {
      const auto lines = static_cast<int>(linesOf(file).size());
      EXPECT_LE(lines, file.extension() == ".h" ? kMostHeaderLines : kMostLines) << file;
    }
}

TEST(Structure, LinesKeepWithinAHundredColumns) {
  for (const char* top : {"core", "ui", "app", "tests"})
    for (const fs::path& file : sourcesUnder(root() / top)) {
      const std::vector<std::string> lines = linesOf(file);
      for (std::size_t i = 0; i < lines.size(); ++i) {
        const auto columns = std::count_if(lines[i].begin(), lines[i].end(), [](char c) {
          return (static_cast<unsigned char>(c) & 0xC0) != 0x80;  // not a continuation in UTF-8
        });
        EXPECT_LE(columns, 100) << file << ":" << i + 1;
      }
    }
}

TEST(Structure, SourcesSpeakOfNoMachinesPaths) {
  for (const char* top : {"core", "ui", "app", "tests"})
    for (const fs::path& file : sourcesUnder(root() / top)) {
      if (file.filename() == "structure_test.cpp") continue;
      for (const std::string& line : linesOf(file))
        for (const char* path : {"/work/", "/root/", "/home/"}) {
          const std::size_t at = line.find(path);
          // OUT/work/ and results/B0001/work/ are the program's own folders.
          const bool relative = at != std::string::npos && at > 0 &&
                                std::isalnum(static_cast<unsigned char>(line[at - 1]));
          EXPECT_TRUE(at == std::string::npos || relative) << file << ": " << line;
        }
    }
}

}  // namespace
