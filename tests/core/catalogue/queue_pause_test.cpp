#include "catalogue/queue_pause.h"

#include "catalogue/settings.h"
#include "small_project.h"

namespace ostraka::catalogue {
namespace {

using records::BatchState;

class Queue : public SmallProject {
 protected:
  void add(BatchState state) {
    ASSERT_TRUE(Batches(catalogue()).setState(newBatch({bag4}), state, anna));
  }
  QueuePause pause() { return valueIn(queuePause(catalogue())); }
};

TEST_F(Queue, RunsUntilAPersonPausesIt) {
  EXPECT_EQ(pause(), QueuePause::None);
  ASSERT_TRUE(setQueuePause(catalogue(), QueuePause::ByPerson, anna));
  EXPECT_EQ(pause(), QueuePause::ByPerson);
  EXPECT_EQ(valueIn(queuePause(valueIn(upkeep::Project::open(project_->folder())).catalogue())),
            QueuePause::ByPerson)
      << "when the project is opened again";
  ASSERT_TRUE(setQueuePause(catalogue(), QueuePause::None, anna));
  EXPECT_EQ(pause(), QueuePause::None);
}

TEST_F(Queue, HoldsTheBatchesThatWaitAndTheOneThatIsProcessed) {
  EXPECT_EQ(valueIn(batchesInQueue(catalogue())), 0);
  for (const BatchState state :
       {BatchState::Placed, BatchState::Front, BatchState::Flipped, BatchState::Back,
        BatchState::Queued, BatchState::Queued, BatchState::Computed, BatchState::Review,
        BatchState::Done, BatchState::Failed})
    add(state);
  EXPECT_EQ(valueIn(batchesInQueue(catalogue())), 3);
}

TEST_F(Queue, OfARestoredProjectIsPausedOnlyWhereSomethingWouldBegin) {
  add(BatchState::Done);
  ASSERT_TRUE(pauseRestoredQueue(catalogue()));
  EXPECT_EQ(pause(), QueuePause::None);
  ASSERT_TRUE(setQueuePause(catalogue(), QueuePause::ByPerson, anna));
  ASSERT_TRUE(pauseRestoredQueue(catalogue()));
  EXPECT_EQ(pause(), QueuePause::ByPerson) << "left as it is";
  add(BatchState::Computed);  // the archive was made while it was processed
  ASSERT_TRUE(pauseRestoredQueue(catalogue()));
  EXPECT_EQ(pause(), QueuePause::Restored);
}

TEST_F(Queue, IsNotStoppedByAWordOfAnotherProgram) {
  ASSERT_TRUE(Settings(catalogue()).setValue("queue.paused", "perhaps"));
  EXPECT_EQ(pause(), QueuePause::None);
}

}  // namespace
}  // namespace ostraka::catalogue
