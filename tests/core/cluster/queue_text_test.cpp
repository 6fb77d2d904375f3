#include "cluster/queue_text.h"

#include <gmock/gmock.h>

namespace ostraka::cluster {
namespace {

constexpr const char* kJob = "ostraka-0123456789ab";

Queue queueOf(const std::string& text) {
  Queue queue;
  readQueue(text, queue);
  return queue;
}

TEST(QueueText, TellsWaitingRunningAndEnded) {
  const Queue queue = queueOf(
      "ostraka-0123456789ab|1|PENDING|Resources\nostraka-0123456789ab|2|RUNNING|None\n"
      "ostraka-0123456789ab|3|OUT_OF_MEMORY|OutOfMemory\nostraka-0123456789ab|4|TIMEOUT|TimeLimit\n"
      "ostraka-0123456789ab|5|NODE_FAIL|NodeDown\nostraka-0123456789ab|6|COMPLETED|None\n"
      "ostraka-0123456789ab|7|A_STATE_OF_NEXT_YEAR|None\n");
  ASSERT_EQ(queue.size(), 7u);
  EXPECT_EQ(queue.at({kJob, 1}).state, QueueState::Waiting);
  EXPECT_EQ(queue.at({kJob, 1}).reason, "Resources");
  EXPECT_EQ(queue.at({kJob, 2}).state, QueueState::Running);
  EXPECT_EQ(queue.at({kJob, 2}).reason, "");
  EXPECT_EQ(queue.at({kJob, 3}).state, QueueState::NoMemory);
  EXPECT_EQ(queue.at({kJob, 4}).state, QueueState::TimeLimit);
  EXPECT_EQ(queue.at({kJob, 5}).state, QueueState::NodeFailed);
  EXPECT_EQ(queue.at({kJob, 6}).state, QueueState::Ended);
  EXPECT_EQ(queue.at({kJob, 7}).state, QueueState::Running) << "Slurm still holds it";
}

// What is between or behind the lines is of the login computer, or of somebody's job.
TEST(QueueText, PassesOverAllThatIsNoTaskOfOurs) {
  for (const char* line :
       {"", "|||", "Welcome | to | the | cluster", "ostraka-0123456789ab|1|PENDING",
        "ostraka-0123456789ab|-1|PENDING|None", "ostraka-0123456789ab|99999999999999|PENDING|None",
        "ostraka-0123456789ab|1x|PENDING|None", "ostraka-0123456789ab|N/A|PENDING|None",
        "ostraka-0123456789AB|1|PENDING|None", "ostraka-|1|PENDING|None",
        "ostraka-0123456789ab'|1|PENDING|None", "ostraka-0123456789ab|1|PEN\x1B[2J|None",
        "ostraka-0123456789ab|1|PENDING|None|more", "ostraka-0123456789ab|[1-4%2]|PENDING|None"})
    EXPECT_TRUE(queueOf(line).empty()) << line;
  EXPECT_TRUE(queueOf(std::string(1 << 20, '|')).empty());
  EXPECT_TRUE(queueOf(std::string("ostraka-0123456789ab|1|\0|x", 26)).empty());
  const Queue hostile = queueOf("ostraka-0123456789ab|1|PENDING|\x1B]0;owned\x07\n");
  EXPECT_EQ(hostile.at({kJob, 1}).reason, "") << "no control characters";
}

TEST(QueueText, AccountsOnlyAddWhatTheQueueHasForgotten) {
  Queue queue = queueOf("ostraka-0123456789ab|1|RUNNING|None");
  readAccounting(
      "Slurm accounting storage is disabled\nostraka-0123456789ab|12_1|FAILED\n"
      "ostraka-0123456789ab|12_2|CANCELLED by 1000\nostraka-0123456789ab|12_[3-5]|PENDING\n"
      "ostraka-0123456789ab|12|COMPLETED\n|_|\n",
      queue);
  ASSERT_EQ(queue.size(), 2u);
  EXPECT_EQ(queue.at({kJob, 1}).state, QueueState::Running);
  EXPECT_EQ(queue.at({kJob, 2}).state, QueueState::Cancelled);
}

TEST(QueueText, ReadsFreeSpaceAndTheNumberOfAJob) {
  EXPECT_NEAR(*readFreeSpace_mb("Filesystem 1024-blocks Used Available Capacity Mounted on\n"
                                "nas:/dig   100000000 1 5000000 99% /dig\n"),
              5120, 1e-6);
  EXPECT_FALSE(readFreeSpace_mb("df: cannot read\n"));
  EXPECT_FALSE(readFreeSpace_mb("a b c -5 9% /\n"));
  EXPECT_EQ(readJobId("Welcome!\n4711\n"), "4711");
  EXPECT_EQ(readJobId("4711;hpc\n"), "4711");
  EXPECT_FALSE(readJobId("sbatch: error: 12 nodes\n"));
}

TEST(QueueText, ReadsANoteOfAJobAndNothingElse) {
  EXPECT_FALSE(readStateNote("ostraka-0123456789ab began      \n")->ended);
  const auto note = readStateNote("ostraka-0123456789ab ended 137 time no yes    \n");
  ASSERT_TRUE(note);
  EXPECT_TRUE(note->ended && note->time_up && !note->room && note->whole);
  EXPECT_EQ(note->exit_status, 137);
  for (const char* text :
       {"", "began", "ostraka-0123456789ab", "ostraka-0123456789ab ended",
        "ostraka-0123456789ab ended x none yes yes", "ostraka-0123456789ab ended -1 none yes yes",
        "ostraka-0123456789ab ended 0 none yes yes more", "../../etc began"})
    EXPECT_FALSE(readStateNote(text)) << text;
}

TEST(QueueText, NamesOfJobsAreTheirOwn) {
  const std::string one = newJobName(), other = newJobName();
  EXPECT_TRUE(isJobName(one));
  EXPECT_NE(one, other);
}

}  // namespace
}  // namespace ostraka::cluster
