// Runs the built program as a person does, and looks at what it says and its exit status.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "cloud/ply.h"
#include "program.h"

namespace {

namespace fs = std::filesystem;

using ostraka::Outcome;
using ostraka::run;

bool says(const Outcome& outcome, const std::string& words) {
  return outcome.text.find(words) != std::string::npos;
}

class CommandLine : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / ("ostraka_app_" + std::to_string(::getpid()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  void write(const std::string& name, const std::string& text) const {
    fs::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }
  fs::path folder_;
};

TEST_F(CommandLine, ALimitOfFileSizesIsToldAsAFullDisk) {
  struct rlimit before {};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  for (const std::string& command :
       {"plate -o " + path("plate.pdf"), "catalogue new -o " + path("new") + " --code NEW"}) {
    struct rlimit small = before;
    small.rlim_cur = 512;
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
    const Outcome full = run(command);
    ::setrlimit(RLIMIT_FSIZE, &before);
    EXPECT_EQ(full.status, 1) << full.text;
    EXPECT_TRUE(says(full, "The disk is full")) << full.text;
  }
}

TEST_F(CommandLine, HelpOfEachCommandNamesAllItsOptions) {
  const Outcome root = run("--help");
  EXPECT_EQ(root.status, 0);
  for (const char* word :
       {"process", "register", "dense", "evaluate", "completion", "--json", "Exit status"})
    EXPECT_TRUE(says(root, word)) << word;
  const std::pair<const char*, std::vector<const char*>> commands[] = {
      {"process",
       {"PHOTOGRAPHS", "BACK", "--sheet", "--output", "--rig", "--threads", "--dense", "--masks",
        "--pairing", "--registration", "--boundary"}},
      {"register",
       {"--front", "--back", "--output", "--scale", "--pairing", "--registration", "--boundary"}},
      {"dense", {"IMAGES", "--cameras", "--masks", "--output"}},
      {"evaluate", {"OUT", "--truth", "--align"}},
      {"draw", {"MODEL.ply", "--output", "--scale", "--rim", "--plates", "--surface", "--dpi"}},
      {"plate", {"--output", "--sheet", "--diameter", "--paper", "--ruler-measured"}},
      {"catalogue merge",
       {"A", "B", "--settle", "--dry-run", "For example", "ostraka catalogue merge Hill"}},
      {"rig calibrate", {"FOLDER", "--output", "--length"}},
      {"rig predict", {"RIG.json", "--width", "extrapolated"}},
      {"rig simulate",
       {"--output", "--seed", "--sherds", "--fault", "--touching", "--gloss", "--fstop",
        "--hand-held", "--sheet", "--table", "--light", "--camera", "--bend", "--clutter"}},
      {"completion", {"bash", "zsh", "fish"}}};
  for (const auto& [command, options] : commands) {
    const Outcome help = run(std::string(command) + " --help");
    EXPECT_EQ(help.status, 0) << command;
    for (const char* option : options) EXPECT_TRUE(says(help, option)) << command << " " << option;
    EXPECT_TRUE(says(help, "Exit status: 0")) << command;
  }
  EXPECT_TRUE(says(run("--version"), "ostraka "));
}

TEST_F(CommandLine, AResultThatStandardOutputDoesNotTakeIsAFailure) {
  for (const char* command :
       {"--help", "--version", "completion bash", "dense /tmp --json -o x.ply"}) {
    const Outcome full = run(command, "2>&1 >/dev/full");
    EXPECT_EQ(full.status, 1) << command;
    EXPECT_TRUE(says(full, "could not be written to standard output")) << full.text;
  }
  EXPECT_EQ(run("--version", "2>&1 >/dev/null").status, 0);
}

TEST_F(CommandLine, ABoundaryIsForTheOneMethodThatHasIt) {
  const std::string scans = "register --front . --back . --output " + path("out");
  const Outcome other = run(scans + " --boundary paper --registration trimmed");
  EXPECT_EQ(other.status, 2);
  EXPECT_TRUE(says(other, "--registration bbicp")) << other.text;
  const Outcome bbicp = run(scans + " --boundary paper --registration bbicp");
  EXPECT_FALSE(says(bbicp, "needs --registration bbicp")) << bbicp.text;
}

TEST_F(CommandLine, WithoutACommandAndWithoutADisplayItSaysWhatToDo) {
  const Outcome alone = run("");
  EXPECT_EQ(alone.status, 2);
  EXPECT_TRUE(says(alone, OSTRAKA_WITHOUT_DISPLAY)) << alone.text;
  EXPECT_EQ(run(path("")).status, 2);
}

TEST_F(CommandLine, TheDoctorNamesWhatItLookedAt) {
  const Outcome doctor = run("doctor " + path("") + " --json", "2>/dev/null");
  const auto json = nlohmann::json::parse(doctor.text);
  EXPECT_EQ(json.at("exit_status"), doctor.status);
  std::string subjects;
  for (const auto& finding : json.at("findings")) {
    subjects += finding.at("subject").get<std::string>() + "; ";
    EXPECT_FALSE(finding.at("words").get<std::string>().empty());
  }
  for (const char* subject : {"processors", "memory", "disk", "OpenGL", "colmap", "turntables"})
    EXPECT_NE(subjects.find(subject), std::string::npos) << subject << " in " << subjects;
  EXPECT_TRUE(says(run("doctor /nowhere/at/all"), "nowhere"));
}

TEST_F(CommandLine, ACommandLineThatCannotBeUsedIsUnusableInput) {
  for (const char* arguments : {"", "fly", "process", "process x", "process x -o y --dense magic",
                                "register --front a -o b", "evaluate /", "dense /tmp -o x.ply"})
    EXPECT_EQ(run(arguments).status, 2) << arguments;
}

TEST_F(CommandLine, WhatCannotBeACommandLineGetsOneSentenceThatNamesIt) {
  const std::pair<const char*, std::vector<const char*>> lines[] = {
      {"process A B extra -o x", {"not expected: extra", "ostraka process --help"}},
      {"process A B extra", {"not expected: extra"}},
      {"fly", {"'fly' is neither a command nor a project"}},
      {"process -o x", {"PHOTOGRAPHS is required"}},
      {"process A -o x --dense magic", {"--dense takes builtin, colmap, openmvs; not 'magic'"}},
      {"completion tcsh", {"SHELL takes bash, zsh, fish; not 'tcsh'"}},
      {"process A -o", {"--output needs a value"}},
      {"plate -o x.pdf --diameter wide", {"--diameter takes a number; not 'wide'"}},
      {"plate -o x.txt", {"x.txt", "must end in .pdf"}},
      {"draw x.ply -o x.ply", {"x.ply", "must end in .pdf, .svg"}},
      {"dense . --cameras x.json -o x.json", {"x.json", "must end in .ply"}},
      {"rig calibrate . -o photo.jpg", {"photo.jpg", "must end in .json"}},
      {"catalogue new -o x --cod KL3",
       {"'--cod' is not an option of ostraka catalogue new; the nearest is '--code'"}},
      {"process A -o x --zzzzzzzz 3", {"'--zzzzzzzz' is not an option of ostraka process. See"}},
      {"catalogue imprt P", {"not expected: imprt; the nearest command is 'import'"}},
      {"proces A", {"the nearest command is 'process'"}},
      {"process A -o x --marker-mm zwanzig",
       {"--marker-mm takes a number from", "'zwanzig' is not a number"}},
      {"process A -o x --marker-mm 5000", {"takes a number from 0.5 to 1000; not '5000'"}},
      {"rig", {"ostraka rig needs one of its commands: calibrate, predict, simulate"}}};
  for (const auto& [line, words] : lines) {
    const Outcome refused = run(line);
    EXPECT_EQ(refused.status, 2) << line;
    EXPECT_EQ(std::count(refused.text.begin(), refused.text.end(), '\n'), 1) << refused.text;
    for (const char* word : words) EXPECT_TRUE(says(refused, word)) << refused.text;
    const auto json = nlohmann::json::parse(run("--json " + std::string(line), "2>/dev/null").text,
                                            nullptr, false);
    ASSERT_TRUE(json.is_object()) << line;
    EXPECT_EQ(json.at("exit_status"), 2);
    EXPECT_FALSE(json.at("error").get<std::string>().empty());
  }
}

// A direction mark is spelled for a terminal, and stays one in JSON.
TEST_F(CommandLine, NamesOfStrangersAreSpelledAndStillJson) {
  const std::string named = path(
      "\xe2\x80\xae"
      "a\x7f"
      "b.ply");
  const Outcome said = run("draw '" + named + "' --output " + path("sheet.svg"));
  EXPECT_TRUE(says(said, "\\xe2\\x80\\xaea\\x7fb.ply")) << said.text;
  EXPECT_FALSE(says(said, "\x7f"));
  const Outcome json =
      run("--json draw '" + named + "' --output " + path("sheet.svg"), "2>/dev/null");
  const auto read = nlohmann::json::parse(json.text, nullptr, false);
  ASSERT_TRUE(read.is_object()) << json.text;
  EXPECT_NE(read.at("error").get<std::string>().find(named), std::string::npos);
}

TEST_F(CommandLine, HelpAndManualPagesSpeakOfWordsNotOfNumbersForThem) {
  const Outcome help = run("process --help");
  EXPECT_TRUE(says(help, "--dense builtin|colmap|openmvs")) << help.text;
  EXPECT_FALSE(says(help, "->")) << help.text;
  const Outcome made = run("man-pages " + path("man") + " --json", "2>/dev/null");
  EXPECT_EQ(nlohmann::json::parse(made.text).at("exit_status"), 0);
  int pages = 0;
  for (const auto& entry : fs::directory_iterator(path("man"))) {
    std::ifstream file(entry.path());
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    EXPECT_TRUE(text.starts_with(".TH OSTRAKA")) << entry.path();
    EXPECT_NE(text.find(".SH EXIT STATUS"), std::string::npos) << entry.path();
    EXPECT_EQ(text.find("->"), std::string::npos) << entry.path();
    ++pages;
  }
  EXPECT_EQ(nlohmann::json::parse(made.text).at("pages"), pages);
  EXPECT_TRUE(fs::exists(path("man/ostraka-rig-simulate.1")));
}

TEST_F(CommandLine, BadInputGetsOneSentenceWithTheFilesName) {
  const Outcome absent = run("process " + path("nowhere") + " -o " + path("out") + " --quiet");
  EXPECT_EQ(absent.status, 2);
  EXPECT_TRUE(says(absent, "nowhere")) << absent.text;
  EXPECT_EQ(std::count(absent.text.begin(), absent.text.end(), '\n'), 1) << absent.text;
  EXPECT_FALSE(fs::exists(path("out/pairs.json")));

  write("front/a.ply", "ply\nformat ascii 1.0\nelement vertex 99999999\nend_header\n");
  write("back/a.ply", "no ply");
  const Outcome scans =
      run("register --front " + path("front") + " --back " + path("back") + " -o " + path("out"));
  EXPECT_EQ(scans.status, 2) << scans.text;
  EXPECT_TRUE(says(scans, "a.ply")) << scans.text;
}

// The heads of PNG images of 800 x 600 pixels: enough to be counted.
TEST_F(CommandLine, ProcessRefusesTheSamePhotographsForBothSides) {
  const std::string png(
      "\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR\0\0\x03\x20\0\0\x02\x58\x08\x02\0\0\0"
      "\0\0\0\0\0\0\0\0IEND\0\0\0\0",
      45);
  for (const char* side : {"up/", "down/"})
    for (const char* name : {"IMG_1.png", "IMG_2.png", "IMG_3.png"})
      write(std::string(side) + name, png + name);
  const Outcome same = run("process " + path("up") + " " + path("down") + " -o " + path("out"));
  EXPECT_EQ(same.status, 2) << same.text;
  EXPECT_TRUE(says(same, path("down") + ": 3 of the 3 photographs of the back side are identical"))
      << same.text;
  EXPECT_FALSE(fs::exists(path("out/pairs.json")));
}

TEST_F(CommandLine, DenseSaysWhichPhotographIsMissing) {
  write("cameras.json",
        R"({"unit":"mm","images":[{"file":"gone.jpg","width":64,"height":48,
        "K":[[100,0,32],[0,100,24],[0,0,1]],"dist":[],
        "R":[[1,0,0],[0,1,0],[0,0,1]],"t":[0,0,100]}]})");
  const Outcome dense = run("dense " + folder_.string() + " --cameras " + path("cameras.json") +
                            " -o " + path("c.ply"));
  EXPECT_EQ(dense.status, 2);
  EXPECT_TRUE(says(dense, "gone.jpg")) << dense.text;
  EXPECT_FALSE(fs::exists(path("c.ply")));
  EXPECT_EQ(
      run("dense " + folder_.string() + " --cameras " + path("none.json") + " -o x.ply").status, 2);
}

TEST_F(CommandLine, DenseOpensPhotographsInTheFolderAlone) {
  write("photographs/a.jpg", "no image");
  write("a.jpg", "no image");
  const auto dense = [&](const std::string& file) {
    write("cameras.json",
          R"({"unit":"mm","images":[{"file":")" + file + R"(","width":64,"height":48,
        "K":[[100,0,32],[0,100,24],[0,0,1]],"dist":[],
        "R":[[1,0,0],[0,1,0],[0,0,1]],"t":[0,0,100]}]})");
    const Outcome outcome = run("dense " + path("photographs/") + " --cameras " +
                                path("cameras.json") + " -o " + path("c.ply"));
    EXPECT_EQ(outcome.status, 2) << outcome.text;
    return outcome;
  };
  const char* const refused = "is not a path inside its folder";
  EXPECT_TRUE(says(dense("../a.jpg"), refused));
  EXPECT_TRUE(says(dense(path("a.jpg")), refused));
  // `process` names photographs absolutely.
  for (const std::string& inside : {std::string("./a.jpg"), path("photographs/a.jpg")}) {
    const Outcome opened = dense(inside);
    EXPECT_FALSE(says(opened, refused)) << opened.text;
    EXPECT_FALSE(says(opened, "no such file")) << opened.text;
  }
}

TEST_F(CommandLine, ErrorsComeAsJsonToo) {
  const Outcome outcome = run(
      "evaluate " + folder_.string() + " --truth " + folder_.string() + " --json", "2>/dev/null");
  EXPECT_EQ(outcome.status, 2);
  const auto value = nlohmann::json::parse(outcome.text, nullptr, false);
  ASSERT_TRUE(value.is_object()) << outcome.text;
  EXPECT_EQ(value["exit_status"], 2);
  EXPECT_NE(value["error"].get<std::string>().find("truth"), std::string::npos);
}

TEST_F(CommandLine, EvaluateMeasuresAModelAndGates) {
  ostraka::TriangleMesh mesh;  // a tetrahedron of 30 mm, and the same 1 mm higher
  mesh.vertices = {{0, 0, 0}, {30, 0, 0}, {0, 30, 0}, {0, 0, 30}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  ASSERT_TRUE(ostraka::writePly(folder_ / "truth.ply", mesh, "model").has_value());
  for (auto& v : mesh.vertices) v.z() += 1;
  ASSERT_TRUE(ostraka::writePly(folder_ / "model.ply", mesh, "model").has_value());
  const std::string truth = " --truth " + path("truth.ply");
  const Outcome good =
      run("evaluate " + path("truth.ply") + truth + " --gate --json", "2>/dev/null");
  EXPECT_EQ(good.status, 0);
  const auto value = nlohmann::json::parse(good.text, nullptr, false);
  ASSERT_TRUE(value.is_object()) << good.text;
  EXPECT_LT(value["model"]["accuracy_mm"].get<double>(), 1e-5);
  EXPECT_TRUE(value["goals_met"].get<bool>());
  EXPECT_EQ(run("evaluate " + path("model.ply") + truth + " --gate").status, 1);
  EXPECT_EQ(run("evaluate " + path("model.ply") + truth).status, 0) << "measuring is no failure";
}

TEST_F(CommandLine, PlateWritesItsPdfAndTheFilesThatDescribeItIntoAnyFolder) {
  const std::string folder = path("Tafel \xC3\xBC 1");
  const Outcome made = run("plate -o '" + folder + "/plate.pdf' --diameter 200");
  EXPECT_EQ(made.status, 0) << made.text;
  EXPECT_TRUE(says(made, "100 %")) << made.text;
  for (const char* name : {"plate.pdf", "plate.json", "board.json"})
    EXPECT_TRUE(fs::exists(fs::path(folder) / name)) << name;
  const Outcome small = run("plate -o " + path("x.pdf") + " --diameter 60");
  EXPECT_EQ(small.status, 2);
  EXPECT_TRUE(says(small, "Fewer than six markers")) << small.text;
}

TEST_F(CommandLine, NoOutputIsWrittenOverAnInput) {
  fs::create_directories(folder_ / "front");
  for (const char* name : {"board.json", "front/plate.json", "m.pdf"}) write(name, "{}");
  for (const std::string& command :
       {"rig calibrate " + folder_.string() + " -o " + path("board.json"),
        "rig calibrate " + folder_.string() + " -o " + path("front/../front/plate.json"),
        "draw " + path("m.pdf") + " -o " + path("m.pdf")}) {
    const Outcome outcome = run(command);
    EXPECT_EQ(outcome.status, 2) << command;
    EXPECT_TRUE(says(outcome, "one of the input files")) << outcome.text;
  }
  for (const char* name : {"board.json", "front/plate.json", "m.pdf"})
    EXPECT_EQ(fs::file_size(path(name)), 2u) << name;
}

TEST_F(CommandLine, CalibrateSaysWhatIsMissingInAFolderWithoutABoard) {
  const Outcome outcome = run("rig calibrate " + folder_.string() + " -o " + path("rig.json"));
  EXPECT_EQ(outcome.status, 2);
  EXPECT_TRUE(says(outcome, "board.json")) << outcome.text;
  EXPECT_FALSE(fs::exists(path("rig.json")));
  EXPECT_EQ(run("rig calibrate x -o y --length 3").status, 2);
}

TEST_F(CommandLine, SimulateByHandRefusesWhatOnlyARigHasAndARigWhatOnlyAHandHas) {
  const std::string simulate = "rig simulate --output " + path("world") + " ";
  for (const char* wrong :
       {"--sheet a4", "--light sun", "--bend 3", "--clutter 1", "--hand-held 5 --stops 8",
        "--hand-held 5 --fault blur", "--hand-held 5 --light moon", "--hand-held 2",
        "--hand-held 5 --bend 50", "--hand-held 5 --clutter 9", "--gloss 2", "--fstop 0.5"}) {
    EXPECT_EQ(run(simulate + wrong).status, 2) << wrong;
    EXPECT_FALSE(fs::exists(path("world"))) << wrong;
  }
}

TEST_F(CommandLine, DrawMakesSvgAndPdfAndNamesAModelThatIsOpen) {
  ostraka::TriangleMesh mesh;  // a tetrahedron of 30 mm
  mesh.vertices = {{0, 0, 0}, {30, 0, 0}, {0, 30, 0}, {0, 0, 30}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  fs::create_directories(path("07"));
  ASSERT_TRUE(ostraka::writePly(folder_ / "07/model.ply", mesh, "model").has_value());
  mesh.triangles.pop_back();
  ASSERT_TRUE(ostraka::writePly(folder_ / "open.ply", mesh, "model").has_value());
  for (const char* name : {"d.svg", "d.pdf"})
    EXPECT_EQ(run("draw " + path("07/model.ply") + " -o " + path(name) + " --no-rim").status, 0);
  std::ifstream svg(path("d.svg"));
  const std::string text{std::istreambuf_iterator<char>(svg), {}};
  EXPECT_NE(text.find(">07</text>"), std::string::npos) << "named after its folder";
  const Outcome open = run("draw " + path("open.ply") + " -o " + path("o.pdf"));
  EXPECT_EQ(open.status, 2);
  EXPECT_TRUE(says(open, "closed model")) << open.text;
}

TEST_F(CommandLine, CompletionScriptsNameCommandsAndOptions) {
  for (const char* shell : {"bash", "zsh", "fish"}) {
    const Outcome script = run(std::string("completion ") + shell);
    EXPECT_EQ(script.status, 0);
    for (const char* word : {"process", "register", "evaluate", "simulate"})
      EXPECT_TRUE(says(script, word)) << shell << " " << word;
    EXPECT_TRUE(says(script, "cameras")) << shell;
  }
  EXPECT_EQ(run("completion bash > " + path("c.sh")).status, 0);
  const auto completed = [&](const std::string& typed, int at) {
    return run("--version > /dev/null; cd " + folder_.string() + "; bash -c 'source " +
               path("c.sh") + "; COMP_WORDS=(" + typed + "); COMP_CWORD=" + std::to_string(at) +
               "; _ostraka; echo \"${COMPREPLY[@]}\"'")
        .text;
  };
  EXPECT_EQ(completed("ostraka process --de", 2), "--dense\n");
  EXPECT_EQ(completed("ostraka process --dense \"\"", 3), "builtin colmap openmvs\n");
  EXPECT_EQ(completed("ostraka catalogue im", 2), "import\n");
  EXPECT_EQ(completed("ostraka rig simulate --fault m", 4), "missing moved\n");
  EXPECT_EQ(completed("ostraka completion z", 2), "zsh\n");
  EXPECT_EQ(completed("ostraka man", 1), "\n") << "packagers' command";
  EXPECT_EQ(completed("ostraka process c", 2), "c.sh\n") << "a file of this folder";
  EXPECT_EQ(run("completion tcsh").status, 2);
}

}  // namespace
