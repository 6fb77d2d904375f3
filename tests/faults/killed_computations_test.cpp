// What computes from photographs, killed at any moment and started again: the same bytes as when
// nobody disturbs it. kills.h says how to kill it more often.
#include <stdlib.h>

#include "batch_for_faults.h"
#include "killed_at_writes.h"

namespace ostraka::test {
namespace {

class KilledComputations : public BatchForFaults {
 protected:
  void SetUp() override { std::filesystem::remove_all(out()); }
  static std::filesystem::path out() { return root() / "out"; }
  using Words = std::vector<std::string>;
  static void killed(const Words& command, const std::string& seal) {
    const Undisturbed undisturbed(command, out(), errors());
    killedWithTheSameBytes(undisturbed, seal);
    killedAtItsWrites(undisturbed, 2);
  }
};

class KilledProcess : public KilledComputations {
 protected:
  static const Undisturbed& undisturbed() {
    static const Undisturbed undisturbed(
        {"process", root() / "batch", "--output", out(), "--threads", "2"}, out(), errors());
    return undisturbed;
  }
};

TEST_F(KilledProcess, TwoRunsDifferOnlyWhereTheyTellTheTime) {
  const std::set<std::string> tell{"log.txt", "report.html", "report.json", "reports.json",
                                   "stage.json"};
  const Digests whole = undisturbed().whole();
  EXPECT_TRUE(whole.contains("sherds/02/model.ply"));
  for (const auto& [name, digest] : whole)
    if (digest == tells_the_time) {
      EXPECT_TRUE(tell.contains(std::filesystem::path(name).filename())) << name;
    }
}

TEST_F(KilledProcess, ABatchIsProcessedToTheSameBytes) {
  killedAgainAndAgain(undisturbed(), 5 * kills());
}

TEST_F(KilledProcess, ABatchIsProcessedToTheSameBytesAfterKillsAtWrites) {
  killedAtItsWritesAgainAndAgain(undisturbed(), "stage.json");
}

TEST_F(KilledComputations, ARigIsCalibratedToTheSameBytes) {
  killed({"rig", "calibrate", root() / "batch", "--output", out() / "RIG.json"}, "RIG.json");
}

TEST_F(KilledComputations, ACloudIsComputedToTheSameBytes) {
  killed(denseTo(out() / "cloud.ply"), "cloud.ply");
}

TEST_F(KilledComputations, ScansAreRegisteredToTheSameBytes) {
  killed({"register", "--front", root() / "scans" / "front", "--back", root() / "scans" / "back",
          "--output", out()},
         "report.json");
}

TEST_F(KilledComputations, ModelsAreDrawnToTheSameBytes) {
  for (const std::string sheet : {"sheet.svg", "sheet.pdf"})
    killed({"draw", root() / "batch" / "truth" / "sherd00.ply", "--output", out() / sheet}, sheet);
}

TEST_F(KilledComputations, APlateIsPrintedToTheSameBytes) {
  killed({"plate", "--output", out() / "plate.pdf"}, "plate.pdf");
}

TEST_F(KilledComputations, ABatchIsSimulatedToTheSameBytes) {
  killed({"rig", "simulate", "--output", out(), "--sherds", "1", "--width", "160", "--stops", "2",
          "--threads", "1", "--seed", "5"},
         "board.json");
}

TEST_F(KilledComputations, ASideIsPhotographedToTheSameBytes) {
  const Words command{"capture", "--rig",    "virtual", "--side",       "front", "--output",
                      out(),     "--sherds", "1",       "--width",      "160",   "--stops",
                      "4",       "--settle", "0",       "--turn-speed", "0"};
  const Undisturbed undisturbed(command, out(), errors());
  EXPECT_EQ(undisturbed.whole()["front/cam2_pos03.jpg"].size(), 64U)
      << "no photograph or no SHA-256";
  killedAgainAndAgain(undisturbed, 5 * kills());
  killedAtItsWritesAgainAndAgain(undisturbed, "manifest.json");
}

}  // namespace
}  // namespace ostraka::test
