// The disk fills at a write of a command: it says so, and goes on when there is room again.
// OSTRAKA_EVERY_WRITE=1 tries each write of each command, which takes many minutes.
#include "batch_for_faults.h"
#include "small_disk.h"
#include "undisturbed.h"

namespace ostraka::test {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

class FullDisk : public BatchForFaults {
 protected:
  void SetUp() override { empty(); }
  static fs::path disk() { return root() / "disk"; }
  static void empty() {
    fs::remove_all(disk());
    fs::create_directories(disk());
  }

  // Each trial begins without anything and goes on when there is room: the same bytes. What has
  // its last name, seal, on a full disk is whole.
  static void fills(const Words& command, const std::string& seal, long some) {
    const Undisturbed undisturbed(command, disk(), errors());
    ASSERT_TRUE(undisturbed.whole().contains(seal)) << seal;
    empty();
    const long writes = writesOf(disk(), command, errors());
    int said = 0;
    for (const long room : roomsBelow(writes, some)) {
      SCOPED_TRACE("room for " + std::to_string(room) + " of " + std::to_string(writes));
      empty();
      const Ended full = runWithRoomFor(room, disk(), command, errors());
      if (full.status != undisturbed.status()) {
        ++said;
        expectDiskFull(full, disk());
        if (fs::exists(disk() / seal)) {
          EXPECT_EQ(undisturbed.now(), undisturbed.whole());
        }
        const Ended again = runProgram(command, errors());
        EXPECT_EQ(again.status, undisturbed.status()) << again.errors;
      }
      EXPECT_EQ(undisturbed.now(), undisturbed.whole());
      if (HasFailure()) return;
    }
    EXPECT_GT(said, 0);
    std::printf("%s: full at %d of %ld writes\n", command[0].c_str(), said, writes);
  }
};

TEST_F(FullDisk, SimulateLeavesNoHalfBatch) {
  fills({"rig", "simulate", "--output", disk() / "batch", "--sherds", "1", "--width", "160",
         "--stops", "2", "--threads", "1", "--seed", "5"},
        "batch/board.json", 3);
}

TEST_F(FullDisk, DenseLeavesNoCloud) {
  fills(denseTo(disk() / "cloud.ply"), "cloud.ply", 3);
}

TEST_F(FullDisk, DrawLeavesNoHalfSheet) {
  for (const std::string sheet : {"sheet.pdf", "sheet.svg"})
    fills({"draw", root() / "batch" / "truth" / "sherd00.ply", "--output", disk() / sheet}, sheet,
          3);
}

TEST_F(FullDisk, APlateIsPrintedWholeOrNotAtAll) {
  fills({"plate", "--output", disk() / "plate.pdf"}, "plate.pdf", 3);
}

TEST_F(FullDisk, CalibrateKeepsNoHalfRig) {
  fills({"rig", "calibrate", root() / "batch", "--output", disk() / "RIG.json"}, "RIG.json", 3);
}

TEST_F(FullDisk, RegisterIsRepeatedWithTheSameBytes) {
  fills({"register", "--front", root() / "scans" / "front", "--back", root() / "scans" / "back",
         "--output", disk() / "out"},
        "out/report.json", 4);
}

// Each run gets a little more room than the one before and goes on from its whole stages.
TEST_F(FullDisk, ProcessGoesOnFromItsLastWholeStage) {
  const fs::path out = disk() / "out";
  const Words command{"process", root() / "batch", "--output", out, "--threads", "2"};
  const Undisturbed undisturbed(command, disk(), errors());
  empty();
  int trials = 0;
  for (long room = 0;; ++trials) {
    const Ended full = runWithRoomFor(room, disk(), command, errors());
    if (full.status == undisturbed.status() && fs::exists(out / "report.json")) break;
    SCOPED_TRACE("room for " + std::to_string(room) + " writes");
    expectDiskFull(full, disk());
    EXPECT_FALSE(fs::exists(out / "report.json"));
    ASSERT_FALSE(HasFailure());
    room = std::getenv("OSTRAKA_EVERY_WRITE") != nullptr ? room + 1 : 4 * room + 10;
  }
  EXPECT_EQ(undisturbed.now(), undisturbed.whole());
  EXPECT_GT(trials, 0);
  std::printf("process: full %d times\n", trials);
}

}  // namespace
}  // namespace ostraka::test
