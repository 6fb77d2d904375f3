#include "cluster/collect.h"

#include <gmock/gmock.h>

#include "decisions/decisions.h"
#include "fake_cluster.h"
#include "intake/computed_again.h"
#include "stages/run_log.h"

namespace ostraka::cluster {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class Collect : public FakeCluster {
 protected:
  Collected collectAll() { return catalogue::valueIn(collect(*project_, {}, quiet, {})); }
};

TEST_F(Collect, WholeResultsAreEnteredOnceHoweverOftenItIsAsked) {
  const store::BatchRow one = queuedBatch(), two = queuedBatch();
  put(fault() / "B0002", "echo 'ostraka: The photographs show no plate.' >&2; exit 2\n");
  ASSERT_TRUE(submitAll());
  EXPECT_TRUE(collectAll().batches.empty()) << "nothing has run yet";
  runTasks();
  const Collected collected = collectAll();
  EXPECT_THAT(collected.batches, ElementsAre("B0001"));
  EXPECT_EQ(sherdsOf(one), 3u);
  EXPECT_EQ(stateOf(one), records::BatchState::Done);
  ASSERT_EQ(collected.left.size(), 1u);
  EXPECT_EQ(collected.left[0].words, "The photographs show no plate.");
  EXPECT_EQ(stateOf(two), records::BatchState::Queued);

  EXPECT_TRUE(collectAll().batches.empty());
  EXPECT_EQ(sherdsOf(one), 3u);
  EXPECT_EQ(stateOfBatch("B0001").state, TaskState::Collected);
  fs::remove(fault() / "B0002");
  EXPECT_THAT(submitAll()->batches, ElementsAre("B0002"));
  runTasks();
  EXPECT_THAT(collectAll().batches, ElementsAre("B0002"));
  EXPECT_EQ(sherdsOf(two), 3u);
  EXPECT_EQ(runs(), 3);
}

// Killed after the catalogue had it, and before the list did.
TEST_F(Collect, ABatchWhoseEntryWasNotedTooLateIsNotEnteredTwice) {
  const store::BatchRow one = queuedBatch();
  ASSERT_TRUE(submitAll());
  runTasks();
  const std::string list = textOf(clusterFolder(project_->folder()) / "tasks.json");
  collectAll();
  put(clusterFolder(project_->folder()) / "tasks.json", list);
  EXPECT_TRUE(collectAll().batches.empty());
  EXPECT_EQ(sherdsOf(one), 3u);
  EXPECT_EQ(stateOfBatch("B0001").state, TaskState::Collected);
}

TEST_F(Collect, WhatIsAskedAgainMeanwhileIsSubmittedAgain) {
  const store::BatchRow one = queuedBatch();
  ASSERT_TRUE(submitAll());
  runTasks();
  ASSERT_TRUE(intake::queueAgain(catalogue(), "B0001", anna));
  EXPECT_THAT(collectAll().batches, ElementsAre("B0001"));
  EXPECT_EQ(stateOf(one), records::BatchState::Queued);
  EXPECT_THAT(submitAll()->batches, ElementsAre("B0001"));
  runTasks();
  collectAll();
  EXPECT_EQ(stateOf(one), records::BatchState::Done);
  EXPECT_EQ(sherdsOf(one), 3u);
}

TEST_F(Collect, ResultsOfABatchThatIsPhotographedAgainAreNotEntered) {
  const store::BatchRow one = queuedBatch();
  ASSERT_TRUE(submitAll());
  runTasks();
  ASSERT_TRUE(catalogue::Batches(catalogue()).setState(one, records::BatchState::Front, anna));
  EXPECT_TRUE(collectAll().batches.empty());
  EXPECT_EQ(sherdsOf(one), 0u);
  EXPECT_EQ(stateOf(one), records::BatchState::Front);
}

// It waits again by then, so its state tells nothing.
TEST_F(Collect, ResultsOfEarlierPhotographsAreNotEnteredThoughTheBatchWaitsAgain) {
  const store::BatchRow one = queuedBatch();
  ASSERT_TRUE(submitAll());
  runTasks();
  photograph("B0001", "front", 250);
  const Collected collected = collectAll();
  EXPECT_TRUE(collected.batches.empty());
  ASSERT_EQ(collected.warnings.size(), 1u);
  EXPECT_THAT(collected.warnings[0].english(), HasSubstr("photographed again"));
  EXPECT_EQ(sherdsOf(one), 0u);
  EXPECT_EQ(stateOf(one), records::BatchState::Queued);
  EXPECT_THAT(submitAll()->batches, ElementsAre("B0001"));
  runTasks();
  EXPECT_THAT(collectAll().batches, ElementsAre("B0001"));
  EXPECT_EQ(sherdsOf(one), 3u);
}

TEST_F(Collect, ResultsThatCannotBeUsedAreNamedAndComputedAgain) {
  const store::BatchRow one = queuedBatch(), two = queuedBatch();
  ASSERT_TRUE(submitAll());
  runTasks();
  put(project_->resultsFolder("B0001") / "pairs.json", "{");
  const Collected collected = collectAll();
  EXPECT_THAT(collected.batches, ElementsAre("B0002"));
  ASSERT_EQ(collected.warnings.size(), 1u);
  EXPECT_THAT(collected.warnings[0], HasSubstr("B0001"));
  EXPECT_EQ(sherdsOf(one), 0u);
  EXPECT_THAT(submitAll()->batches, ElementsAre("B0001"));
  runTasks();
  collectAll();
  EXPECT_EQ(sherdsOf(one), 3u);
  EXPECT_EQ(sherdsOf(two), 3u);
}

// A project may come from a stranger: the results that were replaced are removed.
TEST_F(Collect, NothingIsRemovedThroughALink) {
  const store::BatchRow one = queuedBatch();
  ASSERT_TRUE(submitAll());
  runTasks();
  ASSERT_TRUE(catalogue::Batches(catalogue()).setState(one, records::BatchState::Front, anna));
  const fs::path elsewhere = folder_.path() / "elsewhere",
                 replaced = clusterFolder(project_->folder()) / "replaced";
  fs::create_directories(elsewhere / "B0001");
  put(elsewhere / "B0001/thesis.txt", "mine");
  const auto refuse = [&](const fs::path& link, const fs::path& to) {
    fs::create_directories(link.parent_path());
    fs::create_symlink(to, link);
    const Result<Collected> refused = collect(*project_, {}, quiet, {});
    ASSERT_FALSE(refused) << link;
    EXPECT_EQ(refused.error().code, ErrorCode::UnusableInput);
    EXPECT_EQ(refused.error().where, link.string());
    const Result<upkeep::Project> opened = upkeep::Project::open(project_->folder());
    ASSERT_FALSE(opened) << link;
    EXPECT_EQ(opened.error().where, link.string());
    EXPECT_EQ(textOf(elsewhere / "B0001/thesis.txt"), "mine");
    fs::remove(link);
  };
  refuse(replaced, elsewhere);
  refuse(replaced / "B0001", elsewhere / "B0001");
  refuse(clusterFolder(project_->folder()) / "state/B0001.new", elsewhere / "B0001/thesis.txt");
  EXPECT_TRUE(collectAll().batches.empty());
  EXPECT_EQ(stateOfBatch("B0001").state, TaskState::Collected);
}

// What lies on the other side of the line is a folder of this computer, reached by a false ssh.
class CollectFromAfar : public Collect {
 protected:
  CollectFromAfar() { submitting.access.host = "anna@login:" + there().string(); }
  bool hasRsync() const { return std::system("command -v rsync > /dev/null") == 0; }
  fs::path there() const { return folder_.path() / "there"; }
};

TEST_F(CollectFromAfar, BatchesGoAndResultsComeWithChecksums) {
  if (!hasRsync()) GTEST_SKIP() << "rsync is not installed";
  const store::BatchRow one = queuedBatch();
  fs::create_directories(there() / "batches/B0001/front");
  put(there() / "batches/B0001/front/cam0_pos09.png", "of an earlier taking");
  const Result<Submitted> submitted = submitAll();
  ASSERT_TRUE(submitted) << submitted.error().sentence();
  EXPECT_FALSE(fs::exists(there() / "batches/B0001/front/cam0_pos09.png"));
  for (const char* name : {"front/cam0_pos00.png", "back/cam0_pos03.png"})
    EXPECT_EQ(textOf(there() / "batches/B0001" / name),
              textOf(project_->batchFolder("B0001") / name));
  EXPECT_THAT(textOf(fault() / "logins"), HasSubstr("anna@login\n"));
  runTasks(there());
  EXPECT_FALSE(fs::exists(project_->resultsFolder("B0001")));
  submitting.access.host.clear();  // it is known from then on
  EXPECT_TRUE(submitAll()->batches.empty());
  EXPECT_THAT(collectAll().batches, ElementsAre("B0001"));
  EXPECT_EQ(sherdsOf(one), 3u);
  EXPECT_TRUE(fs::exists(project_->resultsFolder("B0001") / "report.json"));
  EXPECT_FALSE(fs::exists(clusterFolder(project_->folder()) / "incoming/B0001"));
}

TEST_F(CollectFromAfar, NothingOfEarlierPhotographsIsLeftThere) {
  if (!hasRsync()) GTEST_SKIP() << "rsync is not installed";
  queuedBatch();
  ASSERT_TRUE(submitAll());
  runTasks(there());
  put(there() / "results/B0001/of_earlier_photographs", "");
  for (const char* side : {"front", "back"}) photograph("B0001", side, 250);
  EXPECT_THAT(submitAll()->batches, ElementsAre("B0001"));
  EXPECT_FALSE(fs::exists(there() / "results/B0001/of_earlier_photographs"));
  runTasks(there());
  EXPECT_THAT(collectAll().batches, ElementsAre("B0001"));
}

TEST_F(CollectFromAfar, ALineThatBreaksLosesNothing) {
  if (!hasRsync()) GTEST_SKIP() << "rsync is not installed";
  const store::BatchRow one = queuedBatch();
  ASSERT_TRUE(submitAll());
  runTasks(there());
  put(fault() / "down", "");
  EXPECT_FALSE(collect(*project_, {}, quiet, {}));
  fs::remove(fault() / "down");
  // Half of the results had come.
  fs::create_directories(clusterFolder(project_->folder()) / "incoming/B0001/work");
  put(clusterFolder(project_->folder()) / "incoming/B0001/report.json", "{");
  EXPECT_THAT(collectAll().batches, ElementsAre("B0001"));
  EXPECT_EQ(sherdsOf(one), 3u);
}

// rsync would delete there what the cluster has not.
TEST_F(CollectFromAfar, NothingIsDeletedThroughALink) {
  if (!hasRsync()) GTEST_SKIP() << "rsync is not installed";
  queuedBatch();
  ASSERT_TRUE(submitAll());
  runTasks(there());
  const fs::path elsewhere = folder_.path() / "elsewhere";
  fs::create_directories(elsewhere);
  put(elsewhere / "mine.txt", "mine");
  for (const char* name : {"state", "incoming"}) {
    const fs::path folder = clusterFolder(project_->folder()) / name;
    fs::remove_all(folder);
    fs::create_directory_symlink(elsewhere, folder);
    EXPECT_FALSE(collect(*project_, {}, quiet, {})) << name;
    EXPECT_EQ(textOf(elsewhere / "mine.txt"), "mine") << name;
    fs::remove(folder);
  }
  EXPECT_THAT(collectAll().batches, ElementsAre("B0001")) << "the results are still there";
}

TEST_F(CollectFromAfar, AFolderThatAnotherProjectUsesIsLeftAsItIs) {
  if (!hasRsync()) GTEST_SKIP() << "rsync is not installed";
  const store::BatchRow row = queuedBatch();
  fs::copy(project_->folder(), folder_.path() / "copy", fs::copy_options::recursive);
  ASSERT_TRUE(submitAll());
  const std::string photograph = textOf(there() / "batches/B0001/front/cam0_pos00.png");
  upkeep::Project copy = catalogue::valueIn(upkeep::Project::open(folder_.path() / "copy"));
  const fs::path batch = copy.batchFolder("B0001");
  fs::copy_file(batch / "back/cam0_pos00.png", batch / "front/cam0_pos00.png",
                fs::copy_options::overwrite_existing);
  const Result<Submitted> refused = submit(copy, submitting, quiet, {});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::UnusableInput);
  EXPECT_THAT(refused.error().where, HasSubstr(there().string()));
  EXPECT_EQ(textOf(there() / "batches/B0001/front/cam0_pos00.png"), photograph);
  EXPECT_EQ(submissions(), 1);
  queuedBatch();
  EXPECT_THAT(submitAll()->batches, ElementsAre("B0002")) << "its own";
  runTasks(there());
  EXPECT_THAT(collectAll().batches, ElementsAre("B0001", "B0002"));
  EXPECT_EQ(sherdsOf(row), 3u);
}

TEST_F(CollectFromAfar, NothingIsSentIntoAProject) {
  if (!hasRsync()) GTEST_SKIP() << "rsync is not installed";
  queuedBatch();
  fs::create_directories(there());
  put(there() / "catalogue.sqlite", "of the project that lies there");
  EXPECT_FALSE(submitAll());
  EXPECT_FALSE(fs::exists(there() / "batches/B0001"));
}

// Only what is entered replaces what was there.
TEST_F(CollectFromAfar, ResultsThatAreNotOfTheBatchLeaveItsOwn) {
  if (!hasRsync()) GTEST_SKIP() << "rsync is not installed";
  const store::BatchRow row = queuedBatch();
  const fs::path own = project_->resultsFolder("B0001");
  fs::create_directories(own);
  put(own / "report.json", "of an earlier run");
  ASSERT_TRUE(submitAll());
  runTasks(there());
  fs::create_directories(there() / "results/B0001/work");
  put(there() / "results/B0001/work/batch.json",
      R"({"front/a.png": "of others", "back/a.png": "of others"})");
  const Collected foreign = collectAll();
  EXPECT_TRUE(foreign.batches.empty());
  EXPECT_EQ(foreign.warnings.size(), 1u);
  EXPECT_EQ(textOf(own / "report.json"), "of an earlier run");

  fs::remove_all(there() / "results/B0001");
  ASSERT_TRUE(submitAll());
  runTasks(there());
  put(there() / "results/B0001/pairs.json", "{");  // found while it is entered
  EXPECT_TRUE(collectAll().batches.empty());
  EXPECT_EQ(textOf(own / "report.json"), "of an earlier run");
  EXPECT_EQ(sherdsOf(row), 0u);

  ASSERT_TRUE(submitAll());
  runTasks(there());
  EXPECT_THAT(collectAll().batches, ElementsAre("B0001"));
  EXPECT_FALSE(fs::exists(clusterFolder(project_->folder()) / "replaced/B0001"));
}

// Killed after the results had their place and before they were entered.
TEST_F(CollectFromAfar, DecisionsBetweenAKillAndTheNextCollectionStay) {
  if (!hasRsync()) GTEST_SKIP() << "rsync is not installed";
  const store::BatchRow row = queuedBatch();
  ASSERT_TRUE(submitAll());
  runTasks(there());
  const fs::path own = project_->resultsFolder("B0001"),
                 replaced = clusterFolder(project_->folder()) / "replaced/B0001";
  fs::create_directories(replaced);
  put(replaced / "report.json", "of an earlier run");
  fs::create_directories(own);
  put(own / "report.json", "of the cluster");
  const std::string decided = decisions::textOf({});
  put(own / "decisions.json", decided);
  EXPECT_THAT(collectAll().batches, ElementsAre("B0001"));
  EXPECT_EQ(sherdsOf(row), 3u);
  EXPECT_EQ(textOf(own / "decisions.json"), decided);
  EXPECT_FALSE(fs::exists(replaced));
}

// Put there after the command had looked.
TEST_F(CollectFromAfar, NoFolderIsMadeThroughALink) {
  if (!hasRsync()) GTEST_SKIP() << "rsync is not installed";
  queuedBatch();
  const fs::path elsewhere = folder_.path() / "elsewhere";
  fs::create_directories(elsewhere);
  fs::create_directories(clusterFolder(project_->folder()));
  fs::create_directory_symlink(elsewhere, clusterFolder(project_->folder()) / "incoming");
  const Place place = catalogue::valueIn(Place::of(project_->folder(), submitting.access.host));
  const Result<void> fetched = place.fetch("results/B0001", "cluster/incoming/B0001", 0, {}, {});
  ASSERT_FALSE(fetched);
  EXPECT_EQ(fetched.error().code, ErrorCode::CannotWrite);
  EXPECT_TRUE(fs::is_empty(elsewhere));
}

class TakePlace : public ClusterProject {
 protected:
  TakePlace() {
    queuedBatch();
    fs::create_directories(incoming().parent_path());
    fs::create_directories(project_->resultsFolder("B0001") / "work");
    fs::copy(folder_.path() / "prepared/B0001", incoming(), fs::copy_options::recursive);
  }
  fs::path incoming() const { return clusterFolder(project_->folder()) / "incoming/B0001"; }
  fs::path results() const { return project_->resultsFolder("B0001"); }
};

TEST_F(TakePlace, DecisionsTakenMeanwhileStay) {
  put(results() / "decisions.json", "mine");
  put(results() / "mask_strokes.json", "my strokes");
  put(results() / "report.json", "the old one");
  put(incoming() / "decisions.json", "those of the day before");
  const Result<void> taken = takePlace(*project_, "B0001", incoming(), quiet);
  ASSERT_TRUE(taken) << taken.error().sentence();
  EXPECT_EQ(textOf(results() / "decisions.json"), "mine");
  EXPECT_EQ(textOf(results() / "mask_strokes.json"), "my strokes");
  EXPECT_THAT(textOf(results() / "report.json"), HasSubstr("ostraka-report/1"));
  EXPECT_FALSE(fs::exists(incoming()));
}

TEST_F(TakePlace, FilesThatNoRunWroteStayOnTheClusterAndAreNamed) {
  put(incoming() / "open me.desktop", "[Desktop Entry]");
  put(incoming() / "sherds/01/notes.txt", "of another user");
  put(incoming() / "work/scans_front/f999.ply", "named by no record");
  stages::WarningsKept notes(quiet);
  const Result<void> taken = takePlace(*project_, "B0001", incoming(), notes);
  ASSERT_TRUE(taken) << taken.error().sentence();
  ASSERT_EQ(notes.warnings.size(), 1u);
  for (const char* file : {"open me.desktop", "sherds/01/notes.txt", "work/scans_front/f999.ply"}) {
    EXPECT_FALSE(fs::exists(results() / file)) << file;
    EXPECT_THAT(notes.warnings[0].english(), HasSubstr(file));
  }
  for (const char* file :
       {"pairs.json", "report.html", "sherds/01/model.ply", "work/scans_front/f001.ply"})
    EXPECT_TRUE(fs::exists(results() / file)) << file;
}

TEST_F(TakePlace, NothingIsReplacedThroughALink) {
  const fs::path elsewhere = folder_.path() / "elsewhere",
                 replaced = clusterFolder(project_->folder()) / "replaced";
  fs::create_directories(elsewhere / "B0001");
  put(elsewhere / "B0001/thesis.txt", "mine");
  fs::create_directory_symlink(elsewhere, replaced);
  EXPECT_FALSE(takePlace(*project_, "B0001", incoming(), quiet));
  EXPECT_EQ(textOf(elsewhere / "B0001/thesis.txt"), "mine");
  EXPECT_TRUE(fs::exists(results() / "work"));
}

TEST_F(TakePlace, FilesOfAClusterAreThoseOfStrangers) {
  put(results() / "report.json", "the old one");
  const auto refused = [&](const std::string& what) {
    const Result<void> taken = takePlace(*project_, "B0001", incoming(), quiet);
    EXPECT_FALSE(taken) << what;
    EXPECT_EQ(textOf(results() / "report.json"), "the old one") << what;
  };
  fs::create_symlink("/etc/passwd", incoming() / "log.txt");
  refused("a link");
  fs::remove(incoming() / "log.txt");
  put(incoming() / "a\nb", "");
  refused("a line end in a name");
  fs::remove(incoming() / "a\nb");
  put(incoming() / "..\\up", "");
  refused("a backslash");
  fs::remove(incoming() / "..\\up");
  fs::remove(incoming() / "report.json");
  refused("not whole");
}

}  // namespace
}  // namespace ostraka::cluster
