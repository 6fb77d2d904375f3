#pragma once
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "base/files.h"
#include "program.h"

/// Commands that are killed at any moment. OSTRAKA_KILLS=N kills each of them N times;
/// OSTRAKA_SEED=N draws other moments than the usual.
namespace ostraka::test {

inline int kills() {
  return numberFrom("OSTRAKA_KILLS", 2);
}

/// Moments at which about every second process is still at work, however long the work takes here.
class Delays {
 public:
  double next_s() { return longest_s_ * std::uniform_real_distribution<double>(0, 1)(random_); }
  void heard(bool killed) { longest_s_ *= killed ? 1.25 : 0.8; }
  unsigned seed() const { return seed_; }

 private:
  unsigned seed_ = static_cast<unsigned>(numberFrom("OSTRAKA_SEED", 24));
  std::mt19937_64 random_{seed_};
  double longest_s_ = 0.1;
};

/// prepare: before each run. still: what must hold right after a kill. done: after the same command
/// has been given again.
template <class Prepare, class Still, class Done>
void killRepeatedly(const std::vector<std::string>& command, const std::filesystem::path& errors,
                    Prepare prepare, Still still, Done done, int times = kills()) {
  Delays delays;
  int killed = 0;
  for (int tries = 0; killed < times && tries < 20 * times; ++tries) {
    prepare();
    const pid_t program = startProgram(command, errors);
    std::this_thread::sleep_for(std::chrono::duration<double>(delays.next_s()));
    ::kill(program, SIGKILL);
    const bool was_killed = waitFor(program, errors).status < 0;
    delays.heard(was_killed);
    if (!was_killed) continue;
    SCOPED_TRACE("seed " + std::to_string(delays.seed()) + ", kill " + std::to_string(++killed));
    still();
    const Ended again = runProgram(command, errors);
    done(again);
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_EQ(killed, times);
  std::printf("%d kills of %s %s, seed %u\n", killed, command[0].c_str(),
              command[1][0] == '/' || command[1][0] == '-' ? "" : command[1].c_str(),
              delays.seed());
}

using Digests = std::map<std::string, std::string>;

/// What a command writes below its target when nobody disturbs it: files that are the same each
/// time, and those that tell the time.
class Undisturbed {
 public:
  Undisturbed(const std::vector<std::string>& command, const std::filesystem::path& target,
              const std::filesystem::path& errors)
      : target_(target) {
    for (Digests& found : runs_) {
      std::filesystem::remove_all(target);
      const Ended ended = runProgram(command, errors);
      status_ = ended.status;
      EXPECT_NE(status_, 2) << ended.errors;
      found = digests(target);
      EXPECT_FALSE(found.empty());
    }
  }
  int status() const { return status_; }
  Digests whole() const { return lasting(runs_[0]); }
  Digests now() const { return lasting(digests(target_)); }

 private:
  Digests lasting(const Digests& found) const {
    Digests kept;
    for (const auto& [name, digest] : found) {
      const auto a = runs_[0].find(name), b = runs_[1].find(name);
      const bool lasts = a != runs_[0].end() && b != runs_[1].end() && a->second == b->second;
      kept[name] = lasts ? digest : "tells the time";
    }
    return kept;
  }
  std::filesystem::path target_;
  Digests runs_[2];
  int status_ = -1;
};

/// Killed and given again a command writes the same bytes. Whatever has its last name, seal, after
/// a kill is whole with all that belongs to it: no half result passes for one.
inline void killedWithTheSameBytes(const std::vector<std::string>& command,
                                   const std::filesystem::path& target, const std::string& seal,
                                   const std::filesystem::path& errors, int times = kills()) {
  const Undisturbed undisturbed(command, target, errors);
  ASSERT_TRUE(undisturbed.whole().contains(seal)) << seal;
  killRepeatedly(
      command, errors, [&] { std::filesystem::remove_all(target); },
      [&] {
        if (std::filesystem::exists(target / seal)) {
          EXPECT_EQ(undisturbed.now(), undisturbed.whole());
        }
      },
      [&](const Ended& again) {
        // 2: it was whole when it was killed, and is not written over.
        EXPECT_TRUE(again.status == undisturbed.status() || again.status == 2) << again.errors;
        EXPECT_EQ(undisturbed.now(), undisturbed.whole());
        if (again.status == 2) return;
        EXPECT_FALSE(std::filesystem::exists(target.string() + ".partial"));
      },
      times);
}

}  // namespace ostraka::test
