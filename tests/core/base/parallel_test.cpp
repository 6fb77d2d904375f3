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

TEST(ParallelForRanges, CoversEachIndexOnceWithAShortLastTask) {
  for (const int threads : {1, 3}) {
    std::vector<int> calls(10, 0);
    parallelForRanges(calls.size(), 4, threads, [&](std::size_t begin, std::size_t end) {
      EXPECT_LE(end - begin, 4U);
      for (std::size_t i = begin; i < end; ++i) ++calls[i];
    });
    EXPECT_EQ(calls, std::vector<int>(10, 1));
  }
  parallelForRanges(0, 4, 2, [](std::size_t, std::size_t) { FAIL() << "nothing to do"; });
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
