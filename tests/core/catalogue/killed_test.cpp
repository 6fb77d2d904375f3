// Processes killed at any moment while they make a project or a copy of its catalogue.
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <random>
#include <thread>

#include "flipped_bits.h"
#include "small_project.h"

namespace ostraka::catalogue {
namespace {

namespace fs = std::filesystem;
using Microseconds = std::chrono::microseconds;

// Whether the process was killed before it had done its work.
template <class Work>
bool killedAfter(Microseconds delay, Work work) {
  const pid_t child = ::fork();
  if (child == 0) {
    work();
    ::_exit(0);
  }
  std::this_thread::sleep_for(delay);
  ::kill(child, SIGKILL);
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFSIGNALED(status);
}

template <class Work>
Microseconds timeOf(Work work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration_cast<Microseconds>(std::chrono::steady_clock::now() - begin);
}

bool hasLeftovers(const fs::path& folder) {
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().filename().string().find(".partial") != std::string::npos) return true;
  return false;
}

TEST(Killed, AProjectInTheMakingIsNoneAndIsMadeByTheSameCall) {
  const TemporaryFolder folder;
  ProjectRecord record;
  record.code = "ARM";
  const Microseconds usual =
      timeOf([&] { ASSERT_TRUE(Project::create(folder.path() / "first", record)); });
  std::mt19937_64 random(3);
  int killed = 0, unfinished = 0;
  for (int i = 0; i < 30; ++i) {
    const fs::path place = folder.path() / ("p" + std::to_string(i));
    const Microseconds delay(random() % static_cast<std::uint64_t>(usual.count()));
    killed += killedAfter(delay, [&] { (void)Project::create(place, record); }) ? 1 : 0;
    if (Project::isProject(place)) {
      const Result<Project> open = Project::open(place);
      ASSERT_TRUE(open) << open.error().sentence();
      EXPECT_EQ(open->catalogue().project()->code, "ARM");
    } else {
      ++unfinished;
      const Result<Project> made = Project::create(place, record);
      ASSERT_TRUE(made) << made.error().sentence();
    }
    EXPECT_FALSE(hasLeftovers(place));
    EXPECT_TRUE(contentOf(place));
  }
  EXPECT_GT(killed, 10);
  EXPECT_GT(unfinished, 5);
}

TEST(Killed, AFolderWithSomethingInItIsStillRefusedAfterwards) {
  const TemporaryFolder folder;
  fs::create_directories(folder.path() / "batches/B0001");
  ProjectRecord record;
  record.code = "ARM";
  EXPECT_FALSE(Project::create(folder.path(), record));
}

using KilledBackups = SmallProject;

TEST_F(KilledBackups, LeaveNothingWhenTheNextOneIsMade) {
  for (int i = 0; i < 100; ++i) numbered(context12);
  const fs::path folder = project_->folder();
  Microseconds usual = timeOf([&] { ASSERT_TRUE(project_->backUp()); });
  project_.reset();
  std::mt19937_64 random(5);
  int killed = 0, left = 0;
  for (int i = 0; i < 30; ++i) {
    const Microseconds delay(random() % static_cast<std::uint64_t>(2 * usual.count()));
    killed += killedAfter(delay, [&] { (void)valueIn(Project::open(folder)).backUp(); }) ? 1 : 0;
    left += hasLeftovers(folder) ? 1 : 0;
    const Result<Project> open = Project::open(folder);
    ASSERT_TRUE(open) << open.error().sentence();
    EXPECT_FALSE(hasLeftovers(folder));
    for (const fs::path& backup : open->backups()) {
      const auto copy = Database::open(backup, Database::Mode::ReadOnly);
      ASSERT_TRUE(copy) << backup;
    }
  }
  EXPECT_GT(killed, 10);
  EXPECT_GT(left, 3) << "no kill came while a copy was written";
}

}  // namespace
}  // namespace ostraka::catalogue
