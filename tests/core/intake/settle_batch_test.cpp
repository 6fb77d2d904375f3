#include "intake/settle_batch.h"

#include <gtest/gtest.h>

#include "catalogue/batches.h"
#include "intake/batch_figures.h"
#include "synthetic_out.h"
#include "tests/core/catalogue/small_project.h"

namespace ostraka::intake {
namespace {

class SettleBatch : public catalogue::SmallProject {
 protected:
  SettleBatch() : batch(newBatch({bag4})) {}
  store::BatchRow batch;
};

TEST_F(SettleBatch, ABatchIsSettledUnlessItsScaleIsInDoubt) {
  ASSERT_TRUE(catalogue::Batches(catalogue()).setState(batch, records::BatchState::Review, {}));
  ASSERT_TRUE(settleBatch(catalogue(), "B0001", "AP", true));
  EXPECT_EQ(catalogue::Batches(catalogue()).get(batch)->state, records::BatchState::Done);
  ASSERT_TRUE(settleBatch(catalogue(), "B0001", "", false)) << "nobody said a name";
  EXPECT_EQ(catalogue::Batches(catalogue()).get(batch)->state, records::BatchState::Review);
  records::BatchRecord doubtful = *catalogue::Batches(catalogue()).get(batch);
  doubtful.scale_doubts = {"The scale is wrong: 50 mm measure 49.5 mm."};
  ASSERT_TRUE(catalogue::Batches(catalogue()).save(doubtful, {}));
  ASSERT_TRUE(settleBatch(catalogue(), "B0001", "AP", true));
  EXPECT_EQ(catalogue::Batches(catalogue()).get(batch)->state, records::BatchState::Review);
}

TEST_F(SettleBatch, TheResultsSayWhatWaitsForAPerson) {
  ASSERT_TRUE(catalogue::Batches(catalogue()).setState(batch, records::BatchState::Done, {}));
  EXPECT_FALSE(settleByResults(project_->folder(), "B0001", "AP")) << "there are no results";
  EXPECT_EQ(catalogue::Batches(catalogue()).get(batch)->state, records::BatchState::Done);
  pipeline::writeSyntheticOut(project_->resultsFolder("B0001"), {});
  const Result<bool> wants_computing = settleByResults(project_->folder(), "B0001", "AP");
  ASSERT_TRUE(wants_computing) << wants_computing.error().sentence();
  EXPECT_FALSE(*wants_computing);
  EXPECT_EQ(catalogue::Batches(catalogue()).get(batch)->state, records::BatchState::Review);
  const auto kept = keptFigures(catalogue(), "B0001");
  ASSERT_TRUE(kept);
  EXPECT_EQ(kept->ask, 2) << "the near-duplicates";
  EXPECT_EQ(kept->sure, 2);
}

}  // namespace
}  // namespace ostraka::intake
