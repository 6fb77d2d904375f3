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
  static Words calibrated() {
    return {"rig", "calibrate", root() / "batch", "--output", out() / "RIG.json"};
  }
  static Words registered() {
    return {"register", "--front", root() / "scans" / "front", "--back", root() / "scans" / "back",
            "--output", out()};
  }
  static Words drawn(const std::string& sheet) {
    return {"draw", root() / "batch" / "truth" / "sherd00.ply", "--output", out() / sheet};
  }
  static Words printed() { return {"plate", "--output", out() / "plate.pdf"}; }
  static Words simulated() {
    return {"rig", "simulate", "--output", out(),       "--sherds", "1",      "--width",
            "160", "--stops",  "4",        "--threads", "1",        "--seed", "5"};
  }
};

class KilledProcess : public KilledComputations {
 protected:
  static std::vector<std::string> command() {
    return {"process", root() / "batch", "--output", out(), "--threads", "2"};
  }
  static const Undisturbed& undisturbed() {
    static const Undisturbed undisturbed(command(), out(), errors());
    return undisturbed;
  }
};

TEST_F(KilledProcess, TwoRunsDifferOnlyWhereTheyTellTheTime) {
  const std::set<std::string> tell{"log.txt", "report.html", "report.json", "stage.json"};
  const Digests whole = undisturbed().whole();
  EXPECT_TRUE(whole.contains("sherds/02/model.ply"));
  for (const auto& [name, digest] : whole)
    if (digest == tells_the_time) {
      EXPECT_TRUE(tell.contains(std::filesystem::path(name).filename())) << name;
    }
}

TEST_F(KilledProcess, ABatchIsProcessedToTheSameBytes) {
  killedAgainAndAgain(undisturbed(), command(), out(), errors(), 5 * kills());
}

TEST_F(KilledProcess, ABatchIsProcessedToTheSameBytesAfterKillsAtWrites) {
  killedAtItsWritesAgainAndAgain(undisturbed(), command(), out(), "stage.json", errors());
}

TEST_F(KilledComputations, ARigIsCalibratedToTheSameBytes) {
  killedWithTheSameBytes(calibrated(), out(), "RIG.json", errors());
}

TEST_F(KilledComputations, ACloudIsComputedToTheSameBytes) {
  killedWithTheSameBytes(denseTo(out() / "cloud.ply"), out(), "cloud.ply", errors());
}

TEST_F(KilledComputations, ScansAreRegisteredToTheSameBytes) {
  killedWithTheSameBytes(registered(), out(), "report.json", errors());
}

TEST_F(KilledComputations, ModelsAreDrawnToTheSameBytes) {
  for (const std::string sheet : {"sheet.svg", "sheet.pdf"})
    killedWithTheSameBytes(drawn(sheet), out(), sheet, errors());
}

TEST_F(KilledComputations, APlateIsPrintedToTheSameBytes) {
  killedWithTheSameBytes(printed(), out(), "plate.pdf", errors());
}

TEST_F(KilledComputations, ABatchIsSimulatedToTheSameBytes) {
  killedWithTheSameBytes(simulated(), out(), "board.json", errors(), 2 * kills());
}

TEST_F(KilledComputations, ASideIsPhotographedToTheSameBytes) {
  const std::vector<std::string> command{
      "capture", "--rig",    "virtual", "--side",       "front", "--output",
      out(),     "--sherds", "1",       "--width",      "160",   "--stops",
      "4",       "--settle", "0",       "--turn-speed", "0"};
  const Undisturbed undisturbed(command, out(), errors());
  EXPECT_EQ(undisturbed.whole()["front/cam2_pos03.jpg"].size(), 64U)
      << "no photograph or no SHA-256";
  killedAgainAndAgain(undisturbed, command, out(), errors(), 5 * kills());
}

class ComputationsKilledAtAWrite : public KilledComputations {};

TEST_F(ComputationsKilledAtAWrite, ARigIsCalibratedToTheSameBytes) {
  killedAtItsWrites(calibrated(), out(), "RIG.json", errors());
}

TEST_F(ComputationsKilledAtAWrite, ACloudIsComputedToTheSameBytes) {
  killedAtItsWrites(denseTo(out() / "cloud.ply"), out(), "cloud.ply", errors());
}

TEST_F(ComputationsKilledAtAWrite, ScansAreRegisteredToTheSameBytes) {
  killedAtItsWrites(registered(), out(), "report.json", errors());
}

TEST_F(ComputationsKilledAtAWrite, ModelsAreDrawnToTheSameBytes) {
  for (const std::string sheet : {"sheet.svg", "sheet.pdf"})
    killedAtItsWrites(drawn(sheet), out(), sheet, errors());
}

TEST_F(ComputationsKilledAtAWrite, APlateIsPrintedToTheSameBytes) {
  killedAtItsWrites(printed(), out(), "plate.pdf", errors());
}

TEST_F(ComputationsKilledAtAWrite, ABatchIsSimulatedToTheSameBytes) {
  killedAtItsWrites(simulated(), out(), "board.json", errors());
}

}  // namespace
}  // namespace ostraka::test
