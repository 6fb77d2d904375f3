#include "cluster/task_status.h"

#include <gmock/gmock.h>

#include "cluster/submit.h"

namespace ostraka::cluster {
namespace {

const Task kTask{"B0031", "ostraka-0123456789ab", 3, 4100, 60, {}, false};

TaskStatus judged(std::optional<QueueState> queue, const std::string& note,
                  const std::string& log = {}) {
  const std::optional<StateNote> read = readStateNote("ostraka-0123456789ab " + note);
  const QueueTask task{queue.value_or(QueueState::Waiting), {}};
  return judge(kTask, queue ? &task : nullptr, read ? &*read : nullptr, log);
}

TEST(TaskStatus, WholeResultsAreDoneWhateverSlurmSays) {
  EXPECT_EQ(judged({}, "ended 0 none yes yes").state, TaskState::Done);
  EXPECT_EQ(judged(QueueState::Ended, "ended 3 none yes yes").state, TaskState::Done);
  EXPECT_EQ(judged(QueueState::TimeLimit, "ended 0 none yes yes").state, TaskState::Done);
}

// Requeued after its node failed, or preempted.
TEST(TaskStatus, ATaskThatSlurmHoldsIsNotFailedByItsFirstRun) {
  EXPECT_EQ(judged(QueueState::Waiting, "ended 1 none yes no").state, TaskState::Waiting);
  EXPECT_EQ(judged(QueueState::Running, "began").state, TaskState::Running);
}

TEST(TaskStatus, SaysWhyATaskFailed) {
  EXPECT_EQ(judged(QueueState::NoMemory, "began").cause, Cause::Memory);
  EXPECT_EQ(judged(QueueState::Ended, "ended 137 none yes no").cause, Cause::Memory);
  EXPECT_EQ(
      judged(QueueState::Ended, "began", "slurmstepd-n1: error: Exceeded job memory limit\n").cause,
      Cause::Memory);
  EXPECT_EQ(judged({}, "began", "slurmstepd: error: Detected 1 oom-kill event(s) in step").cause,
            Cause::Memory);
  EXPECT_EQ(judged(QueueState::TimeLimit, "began").cause, Cause::Time);
  EXPECT_EQ(judged({}, "ended 1 time yes no").cause, Cause::Time);
  EXPECT_EQ(judged(QueueState::NodeFailed, "began").cause, Cause::Node);
  EXPECT_EQ(judged(QueueState::Cancelled, "").cause, Cause::Node);
  EXPECT_EQ(judged({}, "began").cause, Cause::Node);
  EXPECT_EQ(judged(QueueState::Ended, "ended 1 none no no").cause, Cause::Disk);
  EXPECT_EQ(judged({}, "").cause, Cause::Lost);
}

TEST(TaskStatus, TheProgramsOwnSentenceIsTheReason) {
  const TaskStatus status = judged(QueueState::Ended, "ended 2 none yes no",
                                   "reading\nostraka: first\nostraka: B0031: no plate.\nmore\n");
  EXPECT_EQ(status.cause, Cause::Program);
  EXPECT_EQ(status.words, "B0031: no plate.");
  EXPECT_EQ(judged({}, "ended 9 none yes no").words.values().at(0).count, 9);
}

TEST(TaskStatus, APartitionThatEndsJobsEarlierIsNamedWhileTheTaskWaits) {
  const QueueTask task{QueueState::Waiting, "PartitionTimeLimit"};
  const TaskStatus status = judge(kTask, &task, nullptr, {});
  EXPECT_EQ(status.state, TaskState::Waiting);
  EXPECT_THAT(status.words, testing::HasSubstr("ends jobs earlier than the 60 minutes"));
}

TEST(TaskStatus, TheNextSubmissionAsksForTwiceOfWhatWasShort) {
  const pipeline::Needs needs{5, 4000, 1100};
  Ask first{4, 0, 0, {}, {}, "ostraka"};
  raiseTo(first, needs, nullptr);
  EXPECT_EQ(first.memory_mb, 5200) << "1.3 times";
  EXPECT_EQ(first.minutes, 30) << "4.6 minutes on 4 cores, 4 times, but not below 30";
  TaskStatus before{{"B0031", "ostraka-0123456789ab", 1, 5200, 30, {}, false},
                    TaskState::Failed,
                    Cause::Memory,
                    {}};
  Ask again{4, 0, 0, {}, {}, "ostraka"};
  raiseTo(again, needs, &before);
  EXPECT_EQ(again.memory_mb, 10400);
  EXPECT_EQ(again.minutes, 30);
  before.cause = Cause::Time;
  Ask longer{4, 0, 0, {}, {}, "ostraka"};
  raiseTo(longer, needs, &before);
  EXPECT_EQ(longer.memory_mb, 5200);
  EXPECT_EQ(longer.minutes, 60);
}

TEST(Raise, StopsWhereAListOfTasksMayEnd) {
  TaskStatus before{kTask, TaskState::Failed, Cause::Memory, {}};
  before.task.memory_mb = kMostMemory_mb;
  before.task.minutes = kMostMinutes;
  Ask ask;
  raiseTo(ask, {}, &before);
  EXPECT_EQ(ask.memory_mb, kMostMemory_mb);
  before.cause = Cause::Time;
  raiseTo(ask, {}, &before);
  EXPECT_EQ(ask.minutes, kMostMinutes);
}

}  // namespace
}  // namespace ostraka::cluster
