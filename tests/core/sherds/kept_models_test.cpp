// Models that a sherd lost with its pair or its pieces, and that come back with them.
#include <gmock/gmock.h>

#include "catalogue/batches.h"
#include "catalogue/files.h"
#include "catalogue/history.h"
#include "files/json.h"
#include "intake/enter_results.h"
#include "intake/review_decisions.h"
#include "records/records.h"
#include "records/sherd.h"
#include "review/review.h"
#include "sherds/kept_models.h"
#include "sherds/sherds.h"
#include "store/database.h"
#include "tests/core/catalogue/result_folder.h"
#include "tests/core/catalogue/small_project.h"

namespace ostraka::sherds {
namespace {

using decisions::DecisionKind;

// Three sherds, computed without any decision; those at 40 and 70 mm are fragments of one.
class LostModels : public catalogue::SmallProject {
 protected:
  LostModels()
      : batch(newBatch({bag4})), output(project_->resultsFolder("B0001")), results(output, 3) {
    results.photographs = "first";
    apart();
    enter();
  }
  intake::EnteredResults enter() {
    return catalogue::valueIn(
        intake::enterResults(catalogue(), project_->folder(), batch, output, {}, quiet, {}));
  }
  bool lost() {
    return catalogue::valueIn(intake::enterLostModels(project_->folder(), "B0001", quiet, {}));
  }
  void apart() {
    results.places_mm = {{40, 0}, {70, 0}, {120, 0}};
    results.pairs() = {{1, 1, false}, {2, 2, false}, {3, 3, false}};
    results.gone.clear();
    write({});
  }
  void joined(const std::vector<std::string>& decisions) {
    results.places_mm[0] = {55, 0};
    results.pairs() = {{1, 1, false}, {3, 3, false}};
    results.gone = {2};
    write(decisions);
  }
  // Results that follow these decisions of the file.
  void write(const std::vector<std::string>& decisions) {
    results.write();
    nlohmann::json report = catalogue::valueIn(readJson(output / "report.json"));
    report["decisions"] = decisions;
    ASSERT_TRUE(writeFileAtomically(output / "report.json", report.dump()));
    catalogue::ResultFolder::noteReports(output);
  }
  decisions::PairDecision taken(DecisionKind kind, std::vector<decisions::ScanRef> scans,
                                std::vector<std::string> replaces = {}) {
    decisions::PairDecision d;
    d.kind = kind;
    d.by = "AP";
    d.scans = std::move(scans);
    d.replaces = std::move(replaces);
    d = catalogue::valueIn(decisions::appendDecision(output, d));
    const Result<void> entered = intake::enterDecision(catalogue(), "B0001", d, output);
    EXPECT_TRUE(entered) << entered.error().sentence();
    if (kind == DecisionKind::Withdraw) {
      EXPECT_TRUE(intake::forgetPiecesOf(catalogue(), "B0001", d, output));
    }
    return d;
  }
  std::string join(batch::Side side) {
    const std::string c = side == batch::Side::Front ? "f" : "b";
    return taken(DecisionKind::Join,
                 {{side, c + "001", {40, 0}, "first"}, {side, c + "002", {70, 0}, "first"}})
        .id;
  }
  std::vector<records::SherdRecord> sherds() {
    return catalogue::valueIn(
        Sherds(catalogue()).of(catalogue::valueIn(Sherds(catalogue()).rows(batch))));
  }
  /// With the piece at 40 mm, or with what it was joined to; a draft without a back is void.
  records::SherdRecord first() {
    for (const records::ScanRecord& scan :
         catalogue::valueIn(catalogue::Batches(catalogue()).scans(batch)))
      if (scan.name == "f001")
        for (const records::SherdRecord& sherd : sherds())
          if (sherd.front == scan.row) return sherd;
    return {};
  }
  std::int64_t historyLength() { return catalogue::History(catalogue()).length(); }
  store::BatchRow batch;
  std::filesystem::path output;
  catalogue::ResultFolder results;
  QuietProgress quiet;
};

// It waits to be computed again, or its back lies under the cameras again.
TEST_F(LostModels, ComeBackWithoutChangingWhatBecomesOfTheBatch) {
  for (const records::BatchState state : {records::BatchState::Queued, records::BatchState::Flipped,
                                          records::BatchState::Failed, records::BatchState::Done}) {
    const std::string pair =
        taken(DecisionKind::Pair, {{batch::Side::Front, "f001", {40, 0}, "first"},
                                   {batch::Side::Back, "b003", {120, 0}, "first"}})
            .id;
    taken(DecisionKind::Withdraw, {}, {pair});
    ASSERT_EQ(first().model_path, "");
    ASSERT_TRUE(catalogue::Batches(catalogue()).setState(batch, state, {}));
    EXPECT_TRUE(lost());
    EXPECT_NE(first().model_path, "");
    EXPECT_EQ(catalogue::Batches(catalogue()).get(batch)->state, state);
  }
}

// The same pair is decided again: what was computed of it is its model still.
TEST_F(LostModels, ComeBackWithADecisionThatIsDoneAgain) {
  const std::vector<decisions::ScanRef> scans = {{batch::Side::Front, "f001", {40, 0}, "first"},
                                                 {batch::Side::Back, "b002", {70, 0}, "first"}};
  const std::string pair = taken(DecisionKind::Pair, scans).id;
  results.pairs() = {{1, 2, false, "AP"}, {3, 3, false}};
  write({pair});
  enter();
  ASSERT_NE(first().model_path, "");
  taken(DecisionKind::Withdraw, {}, {pair});
  EXPECT_EQ(first().model_path, "");
  EXPECT_TRUE(review::wantsComputing(output));
  taken(DecisionKind::Pair, scans);
  EXPECT_FALSE(review::wantsComputing(output)) << "so that the review lets models come back";
  EXPECT_TRUE(lost());
  EXPECT_NE(first().model_path, "");
  EXPECT_TRUE(first().measures.contains("length"));
}

TEST_F(LostModels, AreThoseOfAJoinThatWasTakenBackWhileItWasComputed) {
  ASSERT_TRUE(set(first().row, "number", "A-1"));
  const std::string fronts = join(batch::Side::Front), backs = join(batch::Side::Back);
  std::filesystem::remove(output / "report.json");  // it is being computed
  taken(DecisionKind::Withdraw, {}, {fronts});
  taken(DecisionKind::Withdraw, {}, {backs});
  joined({fronts, backs});
  EXPECT_TRUE(enter().decided_meanwhile);
  ASSERT_EQ(first().number, "A-1");
  EXPECT_EQ(first().model_path, "") << "of two pieces that nobody wants joined";
  EXPECT_FALSE(first().measures.contains("length"));
  EXPECT_TRUE(catalogue::Files(catalogue()).of(first().row)->empty());
  EXPECT_EQ(catalogue::Batches(catalogue()).get(batch)->state, records::BatchState::Review);
  for (const records::SherdRecord& sherd : sherds())
    if (sherd.state != records::SherdState::Void && sherd.number.empty()) {
      EXPECT_NE(sherd.model_path, "") << "that of the third";
    }
  const std::int64_t before = historyLength();
  enter();
  EXPECT_EQ(historyLength(), before) << "entered and forgotten each time";

  join(batch::Side::Front);
  join(batch::Side::Back);
  EXPECT_FALSE(review::wantsComputing(output)) << "the results are of this join still";
  EXPECT_TRUE(lost());
  EXPECT_NE(first().model_path, "");
  EXPECT_TRUE(first().measures.contains("length"));
}

TEST_F(LostModels, AreNotRemovedWhereTheNewResultsCannotBeRead) {
  const std::filesystem::path unused =
      project_->folder() / "models" / "B0001" / std::string(16, '0') / "model.ply";
  std::filesystem::create_directories(unused.parent_path());
  ASSERT_TRUE(writeFileAtomically(unused, "of before"));
  results.write();
  ASSERT_TRUE(writeFileAtomically(output / "pairs.json", "{"));
  EXPECT_FALSE(intake::enterResults(catalogue(), project_->folder(), batch, output, {}, quiet, {}));
  EXPECT_TRUE(std::filesystem::exists(unused));
  apart();
  enter();
  EXPECT_FALSE(std::filesystem::exists(unused));
  for (const records::SherdRecord& sherd : sherds())
    EXPECT_TRUE(std::filesystem::exists(project_->folder() / sherd.model_path)) << sherd.model_path;
}

TEST_F(LostModels, AreNeverSoughtOutsideTheProject) {
  const std::filesystem::path others =
      folder_.path() / "others" / std::string(16, '0') / "photograph.jpg";
  std::filesystem::create_directories(others.parent_path());
  ASSERT_TRUE(writeFileAtomically(others, "mine"));
  for (const std::string& number :
       {(folder_.path() / "others").string(), std::string("../../others"), std::string()})
    EXPECT_FALSE(dropUnusedModels(catalogue(), project_->folder(), number, {})) << number;
  EXPECT_TRUE(std::filesystem::exists(others));
}

}  // namespace
}  // namespace ostraka::sherds
