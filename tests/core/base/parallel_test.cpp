#include "base/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <vector>

namespace ostraka {
namespace {

TEST(ParallelFor, CallsEachIndexOnceForAnyNumberOfThreads) {
  for (const int threads : {0, 1, 3, 16}) {
    std::vector<std::atomic<int>> calls(1000);
    parallelFor(calls.size(), threads, [&](std::size_t i) { ++calls[i]; });
    for (const auto& count : calls) ASSERT_EQ(count.load(), 1);
  }
}

TEST(ParallelFor, DoesNothingForNothing) {
  parallelFor(0, 4, [](std::size_t) { FAIL(); });
}

TEST(ParallelFor, RethrowsAfterAllThreadsEnded) {
  std::atomic<int> running{0};
  EXPECT_THROW(parallelFor(100, 4,
                           [&](std::size_t i) {
                             ++running;
                             --running;
                             if (i == 5) throw std::runtime_error("five");
                           }),
               std::runtime_error);
  EXPECT_EQ(running.load(), 0);
}

TEST(AvailableThreads, IsAtLeastOne) {
  EXPECT_GE(availableThreads(), 1);
}

}  // namespace
}  // namespace ostraka
