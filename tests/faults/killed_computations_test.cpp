// What computes from photographs, killed at any moment and started again: the same bytes as when
// nobody disturbs it. kills.h says how to kill it more often.
#include <stdlib.h>

#include "batch_for_faults.h"
#include "kills.h"

namespace ostraka::test {
namespace {

class KilledComputations : public BatchForFaults {
 protected:
  void SetUp() override { std::filesystem::remove_all(out()); }
  static std::filesystem::path out() { return root() / "out"; }
};

TEST_F(KilledComputations, ABatchIsProcessedToTheSameBytes) {
  // It takes ten times as long as the others.
  killedWithTheSameBytes({"process", root() / "batch", "--output", out(), "--threads", "2"}, out(),
                         "report.json", errors(), (kills() + 3) / 4);
}

TEST_F(KilledComputations, ARigIsCalibratedToTheSameBytes) {
  killedWithTheSameBytes({"rig", "calibrate", root() / "batch", "--output", out() / "RIG.json"},
                         out(), "RIG.json", errors());
}

TEST_F(KilledComputations, ACloudIsComputedToTheSameBytes) {
  killedWithTheSameBytes(denseTo(out() / "cloud.ply"), out(), "cloud.ply", errors());
}

TEST_F(KilledComputations, ScansAreRegisteredToTheSameBytes) {
  killedWithTheSameBytes({"register", "--front", root() / "scans" / "front", "--back",
                          root() / "scans" / "back", "--output", out()},
                         out(), "report.json", errors());
}

TEST_F(KilledComputations, ModelsAreDrawnToTheSameBytes) {
  for (const std::string sheet : {"sheet.svg", "sheet.pdf"})
    killedWithTheSameBytes(
        {"draw", root() / "batch" / "truth" / "sherd00.ply", "--output", out() / sheet}, out(),
        sheet, errors());
}

TEST_F(KilledComputations, APlateIsPrintedToTheSameBytes) {
  killedWithTheSameBytes({"plate", "--output", out() / "plate.pdf"}, out(), "plate.pdf", errors());
}

TEST_F(KilledComputations, ABatchIsSimulatedToTheSameBytes) {
  killedWithTheSameBytes({"rig", "simulate", "--output", out(), "--sherds", "1", "--width", "160",
                          "--stops", "4", "--threads", "1", "--seed", "5"},
                         out(), "board.json", errors(), 2 * kills());
}

}  // namespace
}  // namespace ostraka::test
