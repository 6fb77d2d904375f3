// Submitting, watching and collecting on a Slurm that this test starts and ends.
#include <gmock/gmock.h>

#include <chrono>
#include <cstdio>
#include <optional>
#include <thread>

#include "cluster_project.h"
#include "colmap/colmap_program.h"
#include "files/scratch_folder.h"

namespace ostraka::cluster {
namespace {

using namespace std::chrono_literals;

// munged, slurmctld and two slurmd; they end with this object, or with the test however it ends.
class Slurm {
 public:
  explicit Slurm(const fs::path& folder) {
    const fs::path out = folder / "said";
    const std::string command = std::string("exec '") + OSTRAKA_SLURM_SCRIPT + "' '" +
                                folder.string() + "' > '" + out.string() + "' 2>&1";
    standing_ = ::popen(command.c_str(), "we");
    for (int tries = 0; tries < 300 && !said.ends_with('\n'); ++tries) {
      std::this_thread::sleep_for(100ms);
      if (const Result<std::string> text = readFile(out)) said = *text;
    }
    ::setenv("SLURM_CONF", (folder / "slurm.conf").c_str(), 1);
  }
  ~Slurm() {
    if (standing_ != nullptr) ::pclose(standing_);
    ::unsetenv("SLURM_CONF");
  }
  Slurm(const Slurm&) = delete;
  Slurm& operator=(const Slurm&) = delete;
  std::string said;  ///< "ready\n", or why not

 private:
  std::FILE* standing_ = nullptr;
};

bool isInstalled(const std::string& program) {
  return colmap::findProgram(program) || fs::exists("/usr/sbin/" + program);
}

class OnSlurm : public ClusterProject {
 protected:
  void SetUp() override {
    for (const char* program : {"munged", "slurmctld", "slurmd", "sbatch", "squeue"})
      if (!isInstalled(program)) GTEST_SKIP() << program << " is not installed";
    // A socket's path has at most 107 bytes, so not in the folder of the test.
    Result<ScratchFolder> made = ScratchFolder::make("slurm", "/tmp");
    ASSERT_TRUE(made) << made.error().sentence();
    folder.emplace(std::move(*made));
    slurm.emplace(folder->path());
    // It may be another one's, or may not start as this user; what it says is printed.
    if (slurm->said != "ready\n") GTEST_SKIP() << "Slurm did not start: " << slurm->said;
  }
  static int call(const std::string& command) {
    return std::system((command + " > /dev/null 2>&1").c_str());
  }
  template <class Holds>
  bool waitUntil(Holds holds, std::chrono::seconds most = 120s) {
    const auto begin = std::chrono::steady_clock::now();
    while (!holds()) {
      if (std::chrono::steady_clock::now() - begin > most) return false;
      std::this_thread::sleep_for(200ms);
    }
    return true;
  }
  bool nothingRuns() {
    for (const TaskStatus& one : states())
      if (one.state == TaskState::Waiting || one.state == TaskState::Running) return false;
    return true;
  }

  std::optional<ScratchFolder> folder;
  std::optional<Slurm> slurm;
};

TEST_F(OnSlurm, EachSherdArrivesOnceThoughTasksAreKilledANodeLeavesAndADiskIsFull) {
  const char* wanted = ::getenv("OSTRAKA_SLURM_BATCHES");  // 200 for the figures of RESULTS.md
  const int batches = wanted == nullptr ? 12 : std::max(6, std::atoi(wanted));
  std::vector<store::BatchRow> rows;
  for (int i = 0; i < batches; ++i) rows.push_back(queuedBatch());
  // The first try of four of them goes wrong.
  put(fault() / "B0001", "rm $f/B0001; echo 'ostraka: No plate.' >&2; exit 2\n");
  put(fault() / "B0002", "rm $f/B0002; python3 -c 'a = b\"x\" * 400000000\nwhile True: pass'\n");
  put(fault() / "B0003", "rm $f/B0003; sleep 100\n");
  put(fault() / "B0004", "rm $f/B0004; exit 1\n");
  const fs::path full = project_->folder() / "results/B0004.room";
  fs::create_directories(full / "in the way");  // where the task tries whether there is room
  submitting.ask.memory_mb = 100;
  const Result<Submitted> first = submitAll();
  ASSERT_TRUE(first) << first.error().sentence();
  ASSERT_EQ(first->batches.size(), static_cast<std::size_t>(batches));
  ASSERT_EQ(first->arrays.size(), 1u);
  EXPECT_TRUE(submitAll()->batches.empty()) << "Slurm has them";

  ASSERT_TRUE(waitUntil([&] {
    return stateOfBatch("B0003").state == TaskState::Running && !fs::exists(fault() / "B0003");
  }));
  EXPECT_EQ(call("scancel " + first->arrays[0] + "_3"), 0);
  EXPECT_EQ(call("scontrol update nodename=near2 state=drain reason=test"), 0);
  ASSERT_TRUE(waitUntil([&] { return nothingRuns(); }, std::chrono::seconds(60 + 2 * batches)));
  EXPECT_EQ(stateOfBatch("B0001").words, "No plate.");
  EXPECT_EQ(stateOfBatch("B0002").cause, Cause::Memory) << stateOfBatch("B0002").words;
  EXPECT_EQ(stateOfBatch("B0003").cause, Cause::Node) << stateOfBatch("B0003").words;
  EXPECT_EQ(stateOfBatch("B0004").cause, Cause::Disk) << stateOfBatch("B0004").words;
  const Result<Collected> before = collect(*project_, {}, quiet, {});
  ASSERT_TRUE(before) << before.error().sentence();
  EXPECT_EQ(before->batches.size(), static_cast<std::size_t>(batches - 4));

  fs::remove_all(full);
  submitting.ask.memory_mb = 0;
  EXPECT_EQ(submitAll()->batches.size(), 4u);
  ASSERT_TRUE(waitUntil([&] { return nothingRuns(); }));
  const Result<Collected> after = collect(*project_, {}, quiet, {});
  ASSERT_TRUE(after) << after.error().sentence();
  EXPECT_EQ(after->batches.size(), 4u);
  EXPECT_TRUE(after->left.empty());
  EXPECT_TRUE(collect(*project_, {}, quiet, {})->batches.empty());
  for (const store::BatchRow row : rows) {
    EXPECT_EQ(sherdsOf(row), 3u);
    EXPECT_EQ(stateOf(row), records::BatchState::Done);
  }
}

// Preempted, or its node failed: Slurm puts the task back by itself.
TEST_F(OnSlurm, ARequeuedTaskGoesOnWithoutBeingSubmittedAgain) {
  const store::BatchRow row = queuedBatch();
  put(fault() / "B0001", "rm $f/B0001; sleep 100\n");
  const Result<Submitted> submitted = submitAll();
  ASSERT_TRUE(submitted) << submitted.error().sentence();
  ASSERT_TRUE(waitUntil([&] {
    return stateOfBatch("B0001").state == TaskState::Running && !fs::exists(fault() / "B0001");
  }));
  EXPECT_EQ(call("scontrol requeue " + submitted->arrays[0] + "_1"), 0);
  EXPECT_TRUE(submitAll()->batches.empty());
  ASSERT_TRUE(waitUntil([&] { return nothingRuns(); }, 180s));
  EXPECT_EQ(catalogue::valueIn(collect(*project_, {}, quiet, {})).batches.size(), 1u);
  EXPECT_EQ(sherdsOf(row), 3u);
  EXPECT_EQ(textOf(fault() / "runs"), "B0001\nB0001\n");
}

TEST_F(OnSlurm, APartitionThatEndsJobsEarlierIsNamed) {
  queuedBatch();
  submitting.ask.partition = "brief";
  ASSERT_TRUE(submitAll());
  EXPECT_TRUE(waitUntil([&] {
    return testing::Value(stateOfBatch("B0001").words,
                          testing::HasSubstr("ends jobs earlier than the 30 minutes"));
  }));
  EXPECT_EQ(stateOfBatch("B0001").state, TaskState::Waiting);
}

}  // namespace
}  // namespace ostraka::cluster
