#include "cluster/job_script.h"

#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "cluster/queue_text.h"
#include "files/files.h"
#include "tests/core/files/temporary_folder.h"

namespace ostraka::cluster {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

TEST(JobScript, AsksForWhatIsNeededOneBatchATask) {
  const std::string text = jobScript("ostraka-0123456789ab", {"B0007", "B0009"},
                                     {8, 4100, 90, "long", "dig", "module load ostraka; ostraka"});
  for (const char* line :
       {"#!/bin/bash\n", "#SBATCH --array=1-2\n", "#SBATCH --cpus-per-task=8\n",
        "#SBATCH --mem=4100M\n", "#SBATCH --time=90\n", "#SBATCH --partition=long\n",
        "#SBATCH --account=dig\n", "#SBATCH --requeue\n", "batches=(B0007 B0009)\n",
        "ostraka_here() { module load ostraka; ostraka \"$@\"; }\n"})
    EXPECT_THAT(text, HasSubstr(line));
}

TEST(JobScript, TexturesAreAsPhotographedUnlessTheProjectWantsThemWithoutTheLight) {
  Ask ask;
  EXPECT_THAT(jobScript("ostraka-0123456789ab", {"B0007"}, ask), HasSubstr("\ntexture=photo\n"));
  ask.albedo = true;
  const std::string text = jobScript("ostraka-0123456789ab", {"B0007"}, ask);
  EXPECT_THAT(text, HasSubstr("\ntexture=albedo\n"));
  EXPECT_THAT(text, HasSubstr(" --texture $texture "));
}

TEST(JobScript, RefusesWhatWouldBecomeAnotherLineOfTheScript) {
  EXPECT_TRUE((Ask{4, 1000, 30, "long-2", "a.b", "ostraka"}.check()));
  EXPECT_FALSE((Ask{4, 1000, 30, "long\n#SBATCH --uid=0", "", "ostraka"}.check()));
  EXPECT_FALSE((Ask{4, 1000, 30, "", "dig $(id)", "ostraka"}.check()));
  EXPECT_FALSE((Ask{4, 1000, 30, "", "", "ostraka\nrm"}.check()));
  EXPECT_FALSE((Ask{4, 1000, 30, "", "", ""}.check()));
  EXPECT_FALSE((Ask{0, 1000, 30, "", "", "ostraka"}.check()));
}

// The script as a node runs it; the program is a few lines of a shell.
class RunScript : public testing::Test {
 protected:
  RunScript() {
    for (const char* name : {"batches/B0001", "results", "cluster/state", "cluster/log"})
      fs::create_directories(folder_.path() / name);
  }
  // The exit status; what it noted is in note.
  int run(const std::string& program_text, const std::string& before = "") {
    std::ofstream(folder_.path() / "program") << "#!/bin/sh\nmkdir -p results/B0001\n"
                                              << program_text << "\n";
    fs::permissions(folder_.path() / "program", fs::perms::owner_all);
    std::ofstream(folder_.path() / "script")
        << jobScript("ostraka-0123456789ab", {"B0001"}, {1, 1000, 30, "", "", "./program"});
    const int status = std::system(("cd '" + folder_.path().string() + "' && " + before +
                                    " SLURM_ARRAY_TASK_ID=1 bash script > /dev/null 2>&1")
                                       .c_str());
    const Result<std::string> text = readFile(folder_.path() / "cluster/state/B0001");
    note = text ? readStateNote(*text) : std::nullopt;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  TemporaryFolder folder_;
  std::optional<StateNote> note;
};

TEST_F(RunScript, ResultsThatAreWholeAreSaidToBeWhateverAPersonMustDecide) {
  EXPECT_EQ(run("[ \"$1 $2 $3 $4\" = 'process batches/B0001 --output results/B0001' ] || exit 2\n"
                "echo {} > results/B0001/report.json; exit 3"),
            0);
  ASSERT_TRUE(note);
  EXPECT_TRUE(note->ended && note->whole && !note->time_up && note->room);
  EXPECT_EQ(note->exit_status, 3);
  EXPECT_EQ(note->job, "ostraka-0123456789ab");
}

TEST_F(RunScript, AReportOfAnEarlierRunIsNotThatOfThisOne) {
  fs::create_directories(folder_.path() / "results/B0001");
  std::ofstream(folder_.path() / "results/B0001/report.json") << "{}";
  fs::last_write_time(folder_.path() / "results/B0001/report.json",
                      fs::file_time_type::clock::now() - std::chrono::hours(1));
  EXPECT_EQ(run("exit 1"), 1);
  ASSERT_TRUE(note);
  EXPECT_TRUE(note->ended && !note->whole && note->room);
}

TEST_F(RunScript, ADiskWithoutRoomIsNoted) {
  fs::create_directories(folder_.path() / "results/B0001.room/in the way");
  EXPECT_EQ(run("exit 1"), 1);
  ASSERT_TRUE(note);
  EXPECT_TRUE(note->ended && !note->room);
}

TEST_F(RunScript, NothingIsWrittenThroughALink) {
  const fs::path elsewhere = folder_.path() / "elsewhere", thesis = elsewhere / "thesis.txt";
  fs::create_directories(elsewhere);
  std::ofstream(thesis) << "mine";
  fs::create_symlink(thesis, folder_.path() / "cluster/state/B0001.new");
  fs::create_symlink(thesis, folder_.path() / "results/B0001.room");
  EXPECT_EQ(run("exit 1"), 1);
  ASSERT_TRUE(note);
  EXPECT_TRUE(note->ended && note->room);
  EXPECT_EQ(*readFile(thesis), "mine");

  for (const char* name : {"cluster/log", "cluster/state"}) {
    fs::remove_all(folder_.path() / name);
    fs::create_directory_symlink(elsewhere, folder_.path() / name);
    EXPECT_EQ(run("echo > ran"), 73) << name;
    fs::remove(folder_.path() / name);
    fs::create_directories(folder_.path() / name);
  }
  EXPECT_FALSE(fs::exists(folder_.path() / "ran"));
  EXPECT_FALSE(fs::exists(elsewhere / "B0001"));
}

// As Slurm signals the script a minute before the end: the program is told, and waited for.
TEST_F(RunScript, BeforeTheTimeLimitTheProgramIsStoppedAndItsEndAwaited) {
  EXPECT_EQ(run("trap 'sleep 0.3; echo > results/B0001/ended; exit 1' TERM\n"
                "kill -USR1 \"$(cat pid)\"; while :; do sleep 0.05; done",
                "echo $$ > pid; exec env"),
            1);
  EXPECT_TRUE(fs::exists(folder_.path() / "results/B0001/ended"));
  ASSERT_TRUE(note);
  EXPECT_TRUE(note->ended && note->time_up && !note->whole);
}

TEST_F(RunScript, WhatSlurmKillsIsNotSaidToHaveEnded) {
  EXPECT_EQ(run("trap 'exit 1' TERM\nkill -TERM \"$(cat pid)\"; while :; do sleep 0.05; done",
                "echo $$ > pid; exec env"),
            143);
  ASSERT_TRUE(note);
  EXPECT_FALSE(note->ended);
}

}  // namespace
}  // namespace ostraka::cluster
