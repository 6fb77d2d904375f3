// Processes killed at any moment while they make a project or a copy of its catalogue.
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <random>
#include <thread>

#include "catalogue/settings.h"
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

// Moments at which about every second process is still at work, however long the work takes here:
// the longest delay grows with every process that was killed and shrinks with every one that was
// not.
class Delays {
 public:
  explicit Delays(unsigned seed) : random_(seed) {}
  Microseconds next() { return Microseconds(static_cast<long>(random_() % longest_)); }
  void heard(bool killed) {
    longest_ = killed ? longest_ + longest_ / 4 : longest_ - longest_ / 5;
    killed_ += killed ? 1 : 0;
  }
  int killed() const { return killed_; }

 private:
  std::mt19937_64 random_;
  std::uint64_t longest_ = 20'000;  // microseconds
  int killed_ = 0;
};

constexpr int kTries = 30, kMostTries = 300;

bool hasLeftovers(const fs::path& folder) {
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().filename().string().find(".partial") != std::string::npos) return true;
  return false;
}

TEST(Killed, AProjectInTheMakingIsNoneAndIsMadeByTheSameCall) {
  const TemporaryFolder folder;
  records::ProjectRecord record;
  record.code = "ARM";
  Delays delays(3);
  int unfinished = 0;
  const auto enough = [&] { return delays.killed() > 10 && unfinished > 5; };
  for (int i = 0; i < kTries || (!enough() && i < kMostTries); ++i) {
    const fs::path place = folder.path() / ("p" + std::to_string(i));
    delays.heard(killedAfter(delays.next(), [&] { (void)upkeep::Project::create(place, record); }));
    if (upkeep::Project::isProject(place)) {
      const Result<upkeep::Project> open = upkeep::Project::open(place);
      ASSERT_TRUE(open) << open.error().sentence();
      EXPECT_EQ(Settings(open->catalogue()).project()->code, "ARM");
    } else {
      ++unfinished;
      const Result<upkeep::Project> made = upkeep::Project::create(place, record);
      ASSERT_TRUE(made) << made.error().sentence();
    }
    EXPECT_FALSE(hasLeftovers(place));
    EXPECT_TRUE(contentOf(place));
  }
  EXPECT_TRUE(enough()) << delays.killed() << " killed, " << unfinished << " unfinished";
}

TEST(Killed, AFolderWithSomethingInItIsStillRefusedAfterwards) {
  const TemporaryFolder folder;
  fs::create_directories(folder.path() / "batches/B0001");
  records::ProjectRecord record;
  record.code = "ARM";
  EXPECT_FALSE(upkeep::Project::create(folder.path(), record));
}

using KilledBackups = SmallProject;

TEST_F(KilledBackups, LeaveNothingWhenTheNextOneIsMade) {
  for (int i = 0; i < 100; ++i) numbered(context12);
  const fs::path folder = project_->folder();
  project_.reset();
  Delays delays(5);
  int left = 0;
  const auto enough = [&] { return delays.killed() > 10 && left > 3; };
  for (int i = 0; i < kTries || (!enough() && i < kMostTries); ++i) {
    delays.heard(
        killedAfter(delays.next(), [&] { (void)valueIn(upkeep::Project::open(folder)).backUp(); }));
    left += hasLeftovers(folder) ? 1 : 0;
    const Result<upkeep::Project> open = upkeep::Project::open(folder);
    ASSERT_TRUE(open) << open.error().sentence();
    EXPECT_FALSE(hasLeftovers(folder));
    for (const fs::path& backup : open->backups()) {
      const auto copy = store::Database::open(backup, store::Database::Mode::ReadOnly);
      ASSERT_TRUE(copy) << backup;
    }
  }
  EXPECT_TRUE(enough()) << delays.killed() << " killed, " << left << " of them while a copy was "
                        << "written";
}

}  // namespace
}  // namespace ostraka::catalogue
