#include "base/parallel.h"

#include <gtest/gtest.h>
#include <pthread.h>

#include <atomic>
#include <stdexcept>
#include <system_error>
#include <thread>
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

// As for a user at his limit of processes; that limit does not hold for root.
TEST(ParallelFor, GoesOnWhereTheSystemGivesNoThread) {
  pthread_attr_t before, too_large;
  ASSERT_EQ(::pthread_getattr_default_np(&before), 0);
  ASSERT_EQ(::pthread_attr_init(&too_large), 0);
  ASSERT_EQ(::pthread_attr_setstacksize(&too_large, std::size_t{1} << 50), 0);
  ASSERT_EQ(::pthread_setattr_default_np(&too_large), 0);
  bool refused = false;
  try {
    std::thread([] {}).join();
  } catch (const std::system_error&) {
    refused = true;
  }
  std::vector<std::atomic<int>> calls(1000);
  EXPECT_NO_THROW(parallelFor(calls.size(), 4, [&](std::size_t i) { ++calls[i]; }));
  ::pthread_setattr_default_np(&before);
  ::pthread_attr_destroy(&before);
  ::pthread_attr_destroy(&too_large);
  EXPECT_TRUE(refused) << "no stack is so large";
  for (const auto& count : calls) ASSERT_EQ(count.load(), 1);
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
