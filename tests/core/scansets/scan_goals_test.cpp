// The goals of metrics.md for scans of other programs, on all sets together; 17 CPU s.
#include <gtest/gtest.h>

#include <map>

#include "cloud/ply.h"
#include "evaluate/pairs.h"
#include "scansets/register_scans.h"
#include "tests/core/files/temporary_folder.h"

namespace ostraka::scansets {
namespace {

namespace fs = std::filesystem;
using evaluate::PairsEvaluation;
using evaluate::PairsSummary;

const std::vector<std::string> kOrdinary = {"b01", "b02", "b03", "b04", "b05"};
const std::vector<std::string> kClean = {"b01", "b02", "b03", "b04", "b05", "lookalikes", "uneven"};
const std::vector<std::string> kFlakes = {"flake", "flake_narrow"};
const std::vector<std::string> kStereo = {"stereo"};

class ScanGoals : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    for (const auto& sets : {kClean, kFlakes, kStereo})
      for (const std::string& set : sets) registerSet(set);
  }
  static void TearDownTestSuite() { judged_.clear(); }

  static PairsSummary summaryOf(const std::vector<std::string>& sets) {
    std::vector<PairsEvaluation> chosen;
    for (const std::string& set : sets) chosen.push_back(judged_.at(set));
    return evaluate::summarise(chosen);
  }

  static std::map<std::string, PairsEvaluation> judged_;

 private:
  static void registerSet(const std::string& set) {
    const fs::path scans = fs::path(OSTRAKA_SHARED_DIR) / "scans" / set;
    const TemporaryFolder temporary;
    RegisterOptions options;
    options.front = scans / "front";
    options.back = scans / "back";
    options.output = temporary.path() / "out";
    options.threads = 2;
    QuietProgress quiet;
    const auto summary = registerScans(options, quiet, {});
    ASSERT_TRUE(summary.has_value()) << set << ": " << summary.error().sentence();
    const auto proposal = evaluate::readProposal(summary->pairs_file);
    const auto truth = evaluate::readPairsTruth(scans / "truth.json");
    ASSERT_TRUE(proposal && truth) << set;
    auto judged = evaluate::evaluatePairs(
        *proposal, *truth, [&](const std::string& file) { return readPlyCloud(scans / file); });
    ASSERT_TRUE(judged.has_value()) << set << ": " << judged.error().sentence();
    judged_[set] = std::move(*judged);
  }
};
std::map<std::string, PairsEvaluation> ScanGoals::judged_;

TEST_F(ScanGoals, PairsAreRightAndNoneIsWrongUnflagged) {
  std::vector<std::string> all;
  for (const auto& [set, judged] : judged_) {
    all.push_back(set);
    EXPECT_EQ(evaluate::summarise({judged}).silent_errors, 0) << set;
    EXPECT_TRUE(judged.forgotten.empty()) << set;
  }
  const PairsSummary summary = summaryOf(all);
  EXPECT_EQ(summary.true_pairs, 65);
  EXPECT_GE(summary.right_percent, 98);  // measured: 100
  EXPECT_EQ(summary.lone_right, summary.lone);
}

TEST_F(ScanGoals, OrdinarySetsHardlyNeedAPerson) {
  const PairsSummary summary = summaryOf(kOrdinary);
  EXPECT_LE(summary.flagged, 0.05 * summary.true_pairs);  // measured: 0
}

TEST_F(ScanGoals, CleanScansAreRegisteredToATenthOfAMillimetre) {
  const PairsSummary summary = summaryOf(kClean);
  EXPECT_GE(summary.share_of_true_within_0_10_percent, 95);  // measured: 100
  EXPECT_LE(summary.rms_median_mm, 0.05);                    // measured: 0.041
  EXPECT_LE(summaryOf(kFlakes).rms_max_mm, 0.05);            // measured: 0.003
}

TEST_F(ScanGoals, StripsOfStereoAreRegisteredOrFlagged) {
  EXPECT_LE(summaryOf(kStereo).rms_median_mm, 0.20);  // measured: 0.175
  for (const evaluate::PairVerdict& verdict : judged_.at("stereo").verdicts) {
    if (!verdict.right || verdict.pair.ambiguous) continue;
    EXPECT_EQ(verdict.transform, evaluate::TransformState::Measured) << verdict.pair.front;
    EXPECT_LE(verdict.error.rms_mm, 0.40) << verdict.pair.front;
  }
}

}  // namespace
}  // namespace ostraka::scansets
