// The disk fills at a write of a command: it says so, and goes on when there is room again.
// OSTRAKA_EVERY_WRITE=1 tries each write of each command, which takes many minutes.
#include <gtest/gtest.h>
#include <stdlib.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/json.h"
#include "program.h"

namespace ostraka::test {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

class FullDisk : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    std::string pattern = (fs::temp_directory_path() / "ostraka_full_XXXXXX").string();
    root = ::mkdtemp(pattern.data());
    errors = root / "errors";
    disk = root / "disk";
    fs::create_directories(disk);
    ASSERT_EQ(runProgram(simulate(root / "batch", {}), errors).status, 0);
    ASSERT_EQ(runProgram(simulate(root / "scans", {"--scans-only"}), errors).status, 0);
    layOutForDense();
  }
  static void TearDownTestSuite() { fs::remove_all(root); }

  // The cameras and masks of one side, where dense looks for them.
  static void layOutForDense() {
    const fs::path truth = root / "batch" / "truth";
    nlohmann::json cameras = *readJson(truth / "cameras.json");
    nlohmann::json fronts = nlohmann::json::array();
    fs::create_directories(root / "masks" / "front");
    for (const nlohmann::json& image : cameras["images"]) {
      if (image["side"] != "front") continue;
      fronts.push_back(image);
      const std::string stem = fs::path(image["file"].get<std::string>()).stem().string();
      fs::copy(truth / "masks" / ("front_" + stem + ".png"),
               root / "masks" / "front" / (stem + ".png"));
    }
    ASSERT_TRUE(writeJson(root / "cameras.json", {{"unit", "mm"}, {"images", fronts}}));
  }

  static Words simulate(const fs::path& output, const Words& more) {
    Words words{"rig", "simulate", "--output", output.string(), "--sherds", "2",         "--width",
                "480", "--stops",  "6",        "--seed",        "7",        "--threads", "2"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }

  static Ended runWithRoomFor(int writes, const Words& command) {
    return runProgram(
        command, errors,
        {"LD_PRELOAD=" OSTRAKA_SMALL_DISK_LIBRARY, "OSTRAKA_SMALL_DISK=" + disk.string(),
         "OSTRAKA_SMALL_DISK_WRITES=" + std::to_string(writes),
         "ASAN_OPTIONS=verify_asan_link_order=0"});
  }

  // One sentence, of the target and of what to do.
  static void expectSentence(const Ended& ended, const fs::path& target, int writes) {
    SCOPED_TRACE("room for " + std::to_string(writes) + " writes: " + ended.errors);
    EXPECT_EQ(ended.status, 1);
    const std::size_t at = ended.errors.find("ostraka: ");
    ASSERT_NE(at, std::string::npos);
    const std::string last = ended.errors.substr(at);
    EXPECT_EQ(std::count(last.begin(), last.end(), '\n'), 1);
    EXPECT_NE(last.find(target.string()), std::string::npos);
    EXPECT_NE(last.find("The disk is full; free some space and start the same command again."),
              std::string::npos);
  }

  // Each trial begins without anything and goes on when there is room: the same bytes.
  static void fillsAtWrites(const Words& command, const fs::path& target, int step,
                            const Words& not_compared = {}) {
    if (std::getenv("OSTRAKA_EVERY_WRITE") != nullptr) step = 1;
    fs::remove_all(disk);
    fs::create_directories(disk);
    const Ended first = runProgram(command, errors);
    ASSERT_EQ(first.status, 0) << first.errors;
    const auto whole = digests(disk, not_compared);
    int trials = 0;
    for (int writes = 0;; writes += step, ++trials) {
      fs::remove_all(disk);
      fs::create_directories(disk);
      const Ended full = runWithRoomFor(writes, command);
      if (full.status == 0) break;
      expectSentence(full, target, writes);
      EXPECT_NE(digests(disk, not_compared), whole);
      const Ended again = runProgram(command, errors);
      ASSERT_EQ(again.status, 0) << again.errors;
      EXPECT_EQ(digests(disk, not_compared), whole) << "room for " << writes << " writes";
    }
    EXPECT_GT(trials, 0);
    std::printf("%d trials of %s\n", trials, command[0].c_str());
  }

  static fs::path root, disk, errors;
};
fs::path FullDisk::root, FullDisk::disk, FullDisk::errors;

TEST_F(FullDisk, SimulateLeavesNoHalfBatch) {
  const fs::path batch = disk / "batch";
  const Words command{
      "rig", "simulate", "--output", batch.string(), "--sherds", "1",      "--width",
      "160", "--stops",  "4",        "--threads",    "1",        "--seed", "5"};
  fillsAtWrites(command, batch, 40);
  const Ended full =
      (fs::remove_all(disk), fs::create_directories(disk), runWithRoomFor(90, command));
  EXPECT_EQ(full.status, 1);
  EXPECT_TRUE(fs::is_empty(disk)) << "neither a batch nor a part of one";
}

TEST_F(FullDisk, DenseLeavesNoCloud) {
  fillsAtWrites({"dense", root / "batch", "--cameras", root / "cameras.json", "--masks",
                 root / "masks", "--output", disk / "cloud.ply"},
                disk / "cloud.ply", 1);
}

TEST_F(FullDisk, DrawLeavesNoHalfSheet) {
  const std::string model = root / "batch" / "truth" / "sherd00.ply";
  fillsAtWrites({"draw", model, "--output", disk / "sheet.pdf"}, disk / "sheet.pdf", 1);
  fillsAtWrites({"draw", model, "--output", disk / "sheet.svg"}, disk / "sheet.svg", 1);
}

TEST_F(FullDisk, RegisterIsRepeatedWithTheSameBytes) {
  fillsAtWrites({"register", "--front", root / "scans" / "front", "--back", root / "scans" / "back",
                 "--output", disk / "out"},
                disk / "out", 4, {"report.json"});
}

// Each run gets a little more room than the one before and goes on from its whole stages.
TEST_F(FullDisk, ProcessGoesOnFromItsLastWholeStage) {
  const fs::path out = disk / "out";
  const Words not_compared{"report.json", "report.html", "stage.json", "log.txt"};
  const Words command{"process", root / "batch", "--output", out, "--threads", "2"};
  fs::remove_all(disk);
  const Ended first = runProgram(command, errors);
  ASSERT_NE(first.status, 2) << first.errors;
  const auto whole = digests(disk, not_compared);
  fs::remove_all(disk);
  fs::create_directories(disk);
  const int step = std::getenv("OSTRAKA_EVERY_WRITE") != nullptr ? 1 : 40;
  int trials = 0;
  for (int writes = 0;; writes += step, ++trials) {
    const Ended full = runWithRoomFor(writes, command);
    if (full.status == first.status && fs::exists(out / "report.json")) break;
    expectSentence(full, out, writes);
    EXPECT_FALSE(fs::exists(out / "report.json"));
  }
  EXPECT_EQ(digests(disk, not_compared), whole);
  EXPECT_GT(trials, 0);
  std::printf("%d trials of process\n", trials);
}

}  // namespace
}  // namespace ostraka::test
