#pragma once
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "files/files.h"
#include "program.h"

/// Commands that are killed at any moment. OSTRAKA_KILLS=N kills each of them N times;
/// OSTRAKA_SEED=N draws other moments than the usual.
namespace ostraka::test {

inline int kills() {
  return numberFrom("OSTRAKA_KILLS", 1);
}

/// Moments at which a process is still at work so many times for each time that it has ended,
/// however long the work takes here.
class Delays {
 public:
  explicit Delays(double kills_per_end = 1) : kills_per_end_(kills_per_end) {}
  double next_s() { return longest_s_ * std::uniform_real_distribution<double>(0, 1)(random_); }
  void heard(bool killed) { longest_s_ *= std::pow(1.25, killed ? 1 : -kills_per_end_); }
  unsigned seed() const { return seed_; }

 private:
  unsigned seed_ = static_cast<unsigned>(numberFrom("OSTRAKA_SEED", 24));
  std::mt19937_64 random_{seed_};
  double kills_per_end_, longest_s_ = 0.1;
};

/// Runs the command and kills it at the next moment; status -1 where it was at work.
inline Ended runAndKill(Delays& delays, const std::vector<std::string>& command,
                        const std::filesystem::path& errors) {
  const pid_t program = startProgram(command, errors);
  std::this_thread::sleep_for(std::chrono::duration<double>(delays.next_s()));
  ::kill(program, SIGKILL);
  Ended ended = waitFor(program, errors);
  delays.heard(ended.status < 0);
  return ended;
}

inline void tellKills(int killed, const std::vector<std::string>& command,
                      const std::string& when) {
  std::printf("%d kills of %s %s, %s\n", killed, command[0].c_str(),
              command[1][0] == '/' || command[1][0] == '-' ? "" : command[1].c_str(), when.c_str());
}

/// prepare: before each run. still: what must hold right after a kill. done: after the same command
/// has been given again.
template <class Prepare, class Still, class Done>
void killRepeatedly(const std::vector<std::string>& command, const std::filesystem::path& errors,
                    Prepare prepare, Still still, Done done, int times = kills()) {
  Delays delays;
  int killed = 0;
  for (int tries = 0; killed < times && tries < 20 * times; ++tries) {
    prepare();
    if (runAndKill(delays, command, errors).status >= 0) continue;
    SCOPED_TRACE("seed " + std::to_string(delays.seed()) + ", kill " + std::to_string(++killed));
    still();
    const Ended again = runProgram(command, errors);
    done(again);
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_EQ(killed, times);
  tellKills(killed, command, "seed " + std::to_string(delays.seed()));
}

}  // namespace ostraka::test
