// rig simulate, killed at any moment.
#include <gtest/gtest.h>
#include <signal.h>
#include <stdlib.h>

#include <chrono>
#include <random>
#include <thread>

#include "program.h"

namespace ostraka::test {
namespace {

namespace fs = std::filesystem;

TEST(SimulateKilled, LeavesAWholeBatchOrNoneAndIsRepeatedWithTheSameBytes) {
  constexpr int kTrials = 20;
  std::string pattern = (fs::temp_directory_path() / "ostraka_killed_XXXXXX").string();
  const fs::path root = ::mkdtemp(pattern.data()), batch = root / "batch", errors = root / "errors";
  const std::vector<std::string> command{
      "rig", "simulate", "--output", batch.string(), "--sherds", "1",      "--width",
      "160", "--stops",  "4",        "--threads",    "1",        "--seed", "5"};
  const auto began = std::chrono::steady_clock::now();
  ASSERT_EQ(runProgram(command, errors).status, 0);
  const std::chrono::duration<double> whole_s = std::chrono::steady_clock::now() - began;
  const auto whole = digests(batch);
  ASSERT_GT(whole.size(), 60u);
  std::mt19937 random(20);
  std::uniform_real_distribution<double> moment(0, 1.05 * whole_s.count());
  for (int trial = 0; trial < kTrials; ++trial) {
    fs::remove_all(batch);
    const pid_t program = startProgram(command, errors);
    std::this_thread::sleep_for(std::chrono::duration<double>(moment(random)));
    ::kill(program, SIGKILL);
    waitFor(program, errors);
    if (fs::exists(batch)) {
      EXPECT_EQ(digests(batch), whole) << "trial " << trial;
      continue;
    }
    const Ended again = runProgram(command, errors);
    ASSERT_EQ(again.status, 0) << "trial " << trial << ": " << again.errors;
    EXPECT_EQ(digests(batch), whole) << "trial " << trial;
    EXPECT_FALSE(fs::exists(root / "batch.partial"));
  }
  fs::remove_all(root);
}

}  // namespace
}  // namespace ostraka::test
