// One decision from the first file to the last row, on the results of four sherds.
#include "intake/apply_decision.h"

#include <gmock/gmock.h>

#include "catalogue/batches.h"
#include "intake/batch_figures.h"
#include "sherds/pair_decisions.h"
#include "synthetic_out.h"
#include "tests/core/catalogue/small_project.h"

namespace ostraka::intake {
namespace {

using decisions::DecisionKind;
using ::testing::HasSubstr;

class ApplyDecision : public catalogue::SmallProject {
 protected:
  ApplyDecision() : out_(pipeline::writeSyntheticOut(project_->resultsFolder("B0001"), {})) {
    records::BatchRecord batch;
    batch.number = "B0001";
    batch.state = records::BatchState::Review;
    batch_ = catalogue::valueIn(catalogue::Batches(catalogue()).add(batch, anna));
    for (const auto* side : {&out_.table.fronts, &out_.table.backs})
      for (std::size_t i = 0; i < side->size(); ++i) {
        records::ScanRecord scan;
        scan.batch = batch_;
        scan.side = (*side)[i].side;
        scan.index = static_cast<int>(i) + 1;
        scan.name = (*side)[i].id;
        scan.plate_x_mm = (*side)[i].place_mm.x();
        scan.plate_y_mm = (*side)[i].place_mm.y();
        scan.path = "results/B0001/scans/" + scan.name + ".ply";
        EXPECT_TRUE(catalogue::Batches(catalogue()).save(scan, anna));
      }
  }
  decisions::PairDecision pair(std::size_t front, std::size_t back) const {
    decisions::PairDecision d;
    d.kind = DecisionKind::Pair;
    d.by = "AP";
    d.scans = {out_.table.fronts.at(front), out_.table.backs.at(back)};
    return d;
  }
  Result<AppliedDecision> apply(const decisions::PairDecision& d) {
    return applyDecision(catalogue(), "B0001", out_.output, d);
  }
  decisions::Decisions onDisk() const {
    return catalogue::valueIn(decisions::readDecisions(out_.output));
  }
  std::vector<records::PairDecision> rows() {
    return catalogue::valueIn(sherds::PairDecisions(catalogue()).all(batch_));
  }
  records::BatchState state() { return catalogue::Batches(catalogue()).get(batch_)->state; }
  int decided() { return keptFigures(catalogue(), "B0001").value_or(BatchFigures{}).decided; }

  pipeline::SyntheticOut out_;
  store::BatchRow batch_;
};

TEST_F(ApplyDecision, WritesOneDecisionWithOneIdInFileAndCatalogue) {
  const AppliedDecision applied = catalogue::valueIn(apply(pair(0, 0)));
  EXPECT_THAT(applied.errors, testing::IsEmpty());
  ASSERT_EQ(onDisk().size(), 1u);
  ASSERT_EQ(rows().size(), 1u);
  EXPECT_EQ(onDisk()[0].id, applied.decision.id);
  EXPECT_EQ(rows()[0].decision, applied.decision.id);
  EXPECT_EQ(rows()[0].by, anna.person);
  EXPECT_EQ(decided(), 1);
  EXPECT_TRUE(applied.wants_computing) << "the program had paired this front with the other back";
  EXPECT_EQ(state(), records::BatchState::Review);
}

TEST_F(ApplyDecision, SettlesABatchThatWaitsForNobodyAnyMore) {
  for (const std::size_t i : {0u, 1u}) EXPECT_TRUE(apply(pair(i, 1 - i)));
  EXPECT_EQ(decided(), 2);
  EXPECT_EQ(keptFigures(catalogue(), "B0001")->ask, 0);
  EXPECT_EQ(state(), records::BatchState::Done) << "both are as the program has them";
}

TEST_F(ApplyDecision, AWithdrawalTakesBackWhatItsDecisionDid) {
  const AppliedDecision taken = catalogue::valueIn(apply(pair(0, 0)));
  decisions::PairDecision back;
  back.kind = DecisionKind::Withdraw;
  back.by = "AP";
  back.scans = taken.decision.scans;
  back.replaces = {taken.decision.id};
  const AppliedDecision withdrawn = catalogue::valueIn(apply(back));
  EXPECT_THAT(withdrawn.errors, testing::IsEmpty());
  EXPECT_FALSE(withdrawn.wants_computing);
  EXPECT_EQ(decided(), 0);
  ASSERT_EQ(rows().size(), 2u) << "nothing is deleted";
  EXPECT_EQ(rows()[1].decision, withdrawn.decision.id);
  EXPECT_EQ(rows()[1].replaces, rows()[0].row);
  EXPECT_TRUE(sherds::PairDecisions(catalogue()).current(batch_)->empty());
}

TEST_F(ApplyDecision, HoldsThoughTheCatalogueCannotFollow) {
  std::filesystem::rename(out_.output, project_->resultsFolder("B0077"));
  const AppliedDecision applied = catalogue::valueIn(
      applyDecision(catalogue(), "B0077", project_->resultsFolder("B0077"), pair(0, 0)));
  ASSERT_THAT(applied.errors, testing::Not(testing::IsEmpty()));
  EXPECT_EQ(decisions::readDecisions(project_->resultsFolder("B0077"))->size(), 1u);
  EXPECT_TRUE(rows().empty());
}

TEST_F(ApplyDecision, TakesResultsThatCannotBeReadForOnesThatDoNotFollowIt) {
  std::filesystem::remove(out_.output / "work/pairs/candidates.json");
  const AppliedDecision applied = catalogue::valueIn(apply(pair(0, 0)));
  EXPECT_THAT(applied.errors, testing::Not(testing::IsEmpty()));
  EXPECT_TRUE(applied.wants_computing);
  EXPECT_EQ(onDisk().size(), 1u) << "the decision holds";
}

TEST_F(ApplyDecision, ChangesNothingWhenItsFileRefusesIt) {
  decisions::PairDecision nobodys = pair(0, 0);
  nobodys.by.clear();
  const Result<AppliedDecision> refused = apply(nobodys);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().sentence(), HasSubstr("name of the person"));
  EXPECT_TRUE(onDisk().empty());
  EXPECT_TRUE(rows().empty());
  EXPECT_FALSE(keptFigures(catalogue(), "B0001"));
}

}  // namespace
}  // namespace ostraka::intake
