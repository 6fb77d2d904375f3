#include "devices/clock.h"

#include <gtest/gtest.h>

#include <thread>

#include "base/message.h"
#include "tests/core/capture/simulated_clock.h"

namespace ostraka::devices {
namespace {

using capture::testing::SimulatedClock;

TEST(SteadyClock, WaitsAtLeastAsLongAsItIsTold) {
  const auto clock = steadyClock();
  const double before_s = clock->now_s();
  EXPECT_TRUE(clock->sleep(0.02, {}));
  EXPECT_GE(clock->now_s() - before_s, 0.02);
}

// A minute that nobody could interrupt would hold up the window that closes.
TEST(SteadyClock, IsWokenByARequestToStop) {
  const auto clock = steadyClock();
  std::stop_source stop;
  const double before_s = clock->now_s();
  const std::jthread asks([&] {
    clock->sleep(0.02, {});
    stop.request_stop();
  });
  EXPECT_FALSE(clock->sleep(60, stop.get_token()));
  EXPECT_LT(clock->now_s() - before_s, 30);
}

TEST(OpenWithin, TriesAgainUntilItSucceeds) {
  SimulatedClock clock;
  int tries = 0;
  const Result<void> opened = openWithin(2, 0.5, clock, {}, [&]() -> Result<void> {
    if (++tries < 3) return Error::missing(message("Not plugged in."));
    return {};
  });
  EXPECT_TRUE(opened.has_value());
  EXPECT_EQ(tries, 3);
  EXPECT_EQ(clock.now_s(), 1);
}

TEST(OpenWithin, TriesAtTheEndOfItsTimeOnceMoreAndTellsTheLastError) {
  SimulatedClock clock;
  int tries = 0;
  const Result<void> opened = openWithin(2, 0.5, clock, {}, [&]() -> Result<void> {
    return Error::missing(message("Try %1.", ++tries));
  });
  ASSERT_FALSE(opened.has_value());
  EXPECT_EQ(opened.error().sentence(), "Try 5.");  // at 0, 0.5, 1, 1.5 and 2 s
  EXPECT_EQ(clock.now_s(), 2);
}

TEST(OpenWithin, EndsWhenAStopIsRequested) {
  SimulatedClock clock;
  std::stop_source stop;
  int tries = 0;
  const Result<void> opened = openWithin(2, 0.5, clock, stop.get_token(), [&]() -> Result<void> {
    ++tries;
    stop.request_stop();
    return Error::missing(message("Not plugged in."));
  });
  ASSERT_FALSE(opened.has_value());
  EXPECT_EQ(opened.error().code, ErrorCode::Cancelled);
  EXPECT_EQ(tries, 1);
}

}  // namespace
}  // namespace ostraka::devices
