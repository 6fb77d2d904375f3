#include "cluster/submit.h"

#include <gmock/gmock.h>

#include "fake_cluster.h"

namespace ostraka::cluster {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class Submit : public FakeCluster {};

TEST_F(Submit, EachBatchThatWaitsBecomesATaskOnce) {
  queuedBatch();
  queuedBatch();
  newBatch({bag4});  // still being photographed
  const Result<Submitted> first = submitAll();
  ASSERT_TRUE(first) << first.error().sentence();
  EXPECT_THAT(first->batches, ElementsAre("B0001", "B0002"));
  EXPECT_THAT(first->arrays, ElementsAre("4711"));
  EXPECT_GE(first->memory_mb, 2000);
  EXPECT_GE(first->minutes, 30);
  EXPECT_EQ(stateOfBatch("B0001").state, TaskState::Waiting);

  const Result<Submitted> second = submitAll();
  ASSERT_TRUE(second) << second.error().sentence();
  EXPECT_TRUE(second->batches.empty());
  EXPECT_EQ(second->already, 2);
  EXPECT_EQ(submissions(), 1);

  queuedBatch();
  EXPECT_THAT(submitAll()->batches, ElementsAre("B0004"));
  runTasks();
  EXPECT_TRUE(submitAll()->batches.empty()) << "done, and not collected yet";
  EXPECT_EQ(submissions(), 2);
}

TEST_F(Submit, WhatFailedIsSubmittedAgainWithMoreOfWhatWasShort) {
  queuedBatch();
  put(fault() / "B0001", "rm $f/B0001; kill -9 $$\n");
  const int asked_mb = submitAll()->memory_mb;
  runTasks(project_->folder(), "FAILED");
  EXPECT_EQ(stateOfBatch("B0001").cause, Cause::Memory);
  EXPECT_EQ(submitAll()->memory_mb, 2 * asked_mb);
  runTasks();
  EXPECT_EQ(stateOfBatch("B0001").state, TaskState::Done);
}

TEST_F(Submit, WhatSlurmRefusesIsSaidInItsWordsAndNothingIsLost) {
  queuedBatch();
  put(fault() / "refusal", "sbatch: error: invalid partition specified: nope\n");
  const Result<Submitted> refused = submitAll();
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().sentence(), HasSubstr("invalid partition specified: nope"));
  EXPECT_TRUE(readTasks(project_->folder())->tasks.empty());
  fs::remove(fault() / "refusal");
  EXPECT_EQ(submitAll()->batches.size(), 1u);
}

// The connection broke after Slurm had taken the array.
TEST_F(Submit, AnArrayThatSlurmHasIsNotSubmittedTwice) {
  queuedBatch();
  put(fault() / "broken", "");
  const Result<Submitted> submitted = submitAll();
  ASSERT_TRUE(submitted) << submitted.error().sentence();
  EXPECT_EQ(submitted->batches.size(), 1u);
  fs::remove(fault() / "broken");
  EXPECT_TRUE(submitAll()->batches.empty());
  EXPECT_EQ(submissions(), 1);
}

TEST_F(Submit, NothingIsConcludedWhileSlurmDoesNotAnswer) {
  queuedBatch();
  ASSERT_TRUE(submitAll());
  put(fault() / "down", "");
  const auto unknown = status(project_->folder(), {}, {});
  ASSERT_FALSE(unknown);
  EXPECT_THAT(unknown.error().sentence(), HasSubstr("cannot contact slurmctld"));
  EXPECT_FALSE(submitAll());
  EXPECT_FALSE(collect(*project_, {}, quiet, {}));
  fs::remove(fault() / "down");
  EXPECT_EQ(stateOfBatch("B0001").state, TaskState::Waiting);
}

TEST_F(Submit, AClusterWithoutSpaceIsNamedBeforeAnythingIsSubmitted) {
  queuedBatch();
  put(fault() / "free", "1000");
  const Result<Submitted> refused = submitAll();
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::CannotWrite);
  EXPECT_THAT(refused.error().sentence(), HasSubstr("Nothing was submitted"));
  EXPECT_EQ(submissions(), 0);
}

TEST_F(Submit, ABatchThatCannotBeReadKeepsBackNoOther) {
  queuedBatch();
  queuedBatch();
  fs::remove_all(project_->batchFolder("B0001") / "front");
  const Result<Submitted> submitted = submitAll();
  ASSERT_TRUE(submitted);
  EXPECT_THAT(submitted->batches, ElementsAre("B0002"));
  EXPECT_EQ(submitted->warnings.size(), 1u);
}

TEST_F(Submit, WithoutSlurmOneSentenceSaysWhatToDo) {
  queuedBatch();
  fs::remove(bin() / "sbatch");
  const std::string path = ::getenv("PATH");
  ::setenv("PATH", bin().c_str(), 1);
  const Result<Submitted> refused = submitAll();
  ::setenv("PATH", path.c_str(), 1);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::Missing);
  EXPECT_THAT(refused.error().sentence(), HasSubstr("--host USER@LOGIN:/FOLDER"));
}

// Jobs write their notes and logs there.
TEST_F(Submit, ALinkInTheProjectsFolderForTheClusterIsNamedAndNothingIsSubmitted) {
  queuedBatch();
  const fs::path elsewhere = folder_.path() / "elsewhere";
  fs::create_directories(elsewhere);
  fs::create_directories(clusterFolder(project_->folder()));
  for (const char* name : {"state", "log"}) {
    const fs::path link = clusterFolder(project_->folder()) / name;
    fs::create_directory_symlink(elsewhere, link);
    const Result<Submitted> refused = submitAll();
    ASSERT_FALSE(refused) << name;
    EXPECT_EQ(refused.error().code, ErrorCode::UnusableInput);
    EXPECT_EQ(refused.error().where, link.string());
    fs::remove(link);
  }
  EXPECT_TRUE(fs::is_empty(elsewhere));
  EXPECT_EQ(submissions(), 0);
}

// Two jobs of one batch would write into the same folder.
TEST_F(Submit, ABatchThatIsPhotographedAgainIsSubmittedAnewOnceItsJobHasEnded) {
  queuedBatch();
  ASSERT_TRUE(submitAll());
  const std::string job = readTasks(project_->folder())->of("B0001")->job;
  photograph("B0001", "front", 250);
  const Result<Submitted> waiting = submitAll();
  ASSERT_TRUE(waiting) << waiting.error().sentence();
  EXPECT_TRUE(waiting->batches.empty());
  ASSERT_EQ(waiting->warnings.size(), 1u);
  EXPECT_THAT(waiting->warnings[0].english(), HasSubstr(job));
  runTasks();
  EXPECT_THAT(submitAll()->batches, ElementsAre("B0001"));
  EXPECT_NE(readTasks(project_->folder())->of("B0001")->job, job);
  EXPECT_TRUE(submitAll()->warnings.empty()) << "these photographs are on the cluster now";
  EXPECT_EQ(submissions(), 2);
}

}  // namespace
}  // namespace ostraka::cluster
