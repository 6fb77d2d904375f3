#include "intake/computed_again.h"

#include "catalogue/batches.h"
#include "catalogue/history.h"
#include "files/files.h"
#include "tests/core/catalogue/small_project.h"

namespace ostraka::intake {
namespace {

class ComputedAgain : public catalogue::SmallProject {
 protected:
  ComputedAgain() : batch(newBatch({bag4})), output(project_->resultsFolder("B0001")) {}
  void is(records::BatchState state) {
    ASSERT_TRUE(catalogue::Batches(catalogue()).setState(batch, state, {}));
  }
  records::BatchState state() { return catalogue::Batches(catalogue()).get(batch)->state; }
  Result<void> ask() { return queueAgain(catalogue(), "B0001", anna); }
  bool askedMeanwhile() { return catalogue::valueIn(queueIfAsked(catalogue(), "B0001", {})); }
  bool takeOut() { return catalogue::valueIn(takeOutOfQueue(catalogue(), "B0001", output, anna)); }

  store::BatchRow batch;
  std::filesystem::path output;
};

TEST_F(ComputedAgain, ABatchIsQueuedUnlessItIsBeingPhotographed) {
  is(records::BatchState::Flipped);
  EXPECT_FALSE(ask()) << "its back is being photographed again";
  is(records::BatchState::Review);
  ASSERT_TRUE(ask());
  EXPECT_EQ(state(), records::BatchState::Queued);
  EXPECT_EQ(catalogue::History(catalogue()).of("batch", batch.value)->front().by, anna.person);
}

TEST_F(ComputedAgain, WhatACommandIsToProcessOverEnteredResultsIsQueuedAndNothingElse) {
  QuietProgress quiet;
  const std::filesystem::path results = project_->folder() / "results";
  is(records::BatchState::Done);
  for (const std::filesystem::path& other :
       {results / "trial", project_->folder() / "B0001", results / "B0001" / "more"}) {
    ASSERT_TRUE(queueOwnerOf(other, quiet)) << other;
    EXPECT_EQ(state(), records::BatchState::Done) << other;
  }
  ASSERT_TRUE(queueOwnerOf(results / "B0001" / "", quiet));
  EXPECT_EQ(state(), records::BatchState::Queued);
  is(records::BatchState::Flipped);
  ASSERT_TRUE(queueOwnerOf(output, quiet));
  EXPECT_EQ(state(), records::BatchState::Flipped) << "it was not entered";
}

TEST_F(ComputedAgain, WhatIsAskedWhileItIsComputedIsDoneWhenThatEnds) {
  is(records::BatchState::Review);
  ASSERT_TRUE(ask());
  ASSERT_TRUE(beginComputing(catalogue(), "B0001"));
  ASSERT_TRUE(ask());
  is(records::BatchState::Computed);
  is(records::BatchState::Review);  // its results are entered
  EXPECT_TRUE(askedMeanwhile());
  EXPECT_EQ(state(), records::BatchState::Queued);
  ASSERT_TRUE(beginComputing(catalogue(), "B0001"));
  is(records::BatchState::Done);
  EXPECT_FALSE(askedMeanwhile()) << "once";
  EXPECT_EQ(state(), records::BatchState::Done);
}

TEST_F(ComputedAgain, WhatIsAskedTwiceBeforeItBeginsIsDoneOnce) {
  is(records::BatchState::Queued);
  ASSERT_TRUE(ask());
  ASSERT_TRUE(beginComputing(catalogue(), "B0001"));
  is(records::BatchState::Done);
  EXPECT_FALSE(askedMeanwhile());
}

TEST_F(ComputedAgain, WhatIsPhotographedAgainMeanwhileIsNotQueued) {
  is(records::BatchState::Queued);
  ASSERT_TRUE(beginComputing(catalogue(), "B0001"));
  ASSERT_TRUE(ask());
  is(records::BatchState::Flipped);
  EXPECT_FALSE(askedMeanwhile());
  EXPECT_EQ(state(), records::BatchState::Flipped);
}

TEST_F(ComputedAgain, TakenOutOfTheQueueABatchIsWhatItWas) {
  ASSERT_TRUE(writeFileAtomically(output / "report.json", "{}"));
  for (const records::BatchState before :
       {records::BatchState::Review, records::BatchState::Done}) {
    is(before);
    EXPECT_FALSE(takeOut()) << "it does not wait";
    ASSERT_TRUE(ask());
    EXPECT_TRUE(takeOut());
    EXPECT_EQ(state(), before);
  }
}

TEST_F(ComputedAgain, WhatIsNotAsItWasIsNotTakenOutSo) {
  is(records::BatchState::Review);
  ASSERT_TRUE(ask());
  EXPECT_FALSE(takeOut()) << "its results are not whole: a computation of it was stopped";
  ASSERT_TRUE(writeFileAtomically(output / "report.json", "{}"));
  for (const records::BatchState before :
       {records::BatchState::Back, records::BatchState::Failed}) {
    is(before);
    is(records::BatchState::Queued);
    EXPECT_FALSE(takeOut()) << "those results are of other photographs, or were never entered";
    EXPECT_EQ(state(), records::BatchState::Queued);
  }
}

}  // namespace
}  // namespace ostraka::intake
