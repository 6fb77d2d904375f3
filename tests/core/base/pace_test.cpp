#include "base/pace.h"

#include <gtest/gtest.h>

namespace ostraka {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr Pace::Clock::time_point kStart{};

TEST(Pace, DoesNotShowAGuess) {
  Pace pace;
  pace.begin(1, kStart);
  pace.report(0.5, kStart + seconds(2));
  EXPECT_FALSE(pace.secondsLeft(kStart + seconds(2))) << "below three seconds of work";
  EXPECT_TRUE(pace.secondsLeft(kStart + seconds(4)));
}

TEST(Pace, IsAGuessBeforeAFifthOfWhatThisRunHasToDo) {
  Pace pace;
  pace.begin(0.1, kStart);
  pace.begin(0.9, kStart + seconds(60));
  EXPECT_FALSE(pace.secondsLeft(kStart + seconds(60))) << "a tenth took a minute";
  pace.report(1.0 / 9, kStart + seconds(80));
  ASSERT_TRUE(pace.secondsLeft(kStart + seconds(80)));
  // 320 s by all of it, 160 s by this stage, of which a ninth is done.
  EXPECT_NEAR(*pace.secondsLeft(kStart + seconds(80)), 320 - 160.0 / 9, 1e-6);
  Pace again;  // nine tenths were found whole
  again.begin(0.9, kStart);
  again.begin(0.1, kStart + milliseconds(100));
  again.report(0.1, kStart + seconds(10));
  EXPECT_FALSE(again.secondsLeft(kStart + seconds(10)));
  again.report(0.2, kStart + seconds(20));
  EXPECT_TRUE(again.secondsLeft(kStart + seconds(20)));
}

TEST(Pace, FollowsAllStages) {
  Pace pace;
  pace.begin(0.25, kStart);
  pace.begin(0.75, kStart + seconds(10));
  pace.report(1.0 / 3, kStart + seconds(20));
  EXPECT_DOUBLE_EQ(pace.fraction(), 0.5);
  // Half of the job took 20 s: the other half takes as long.
  EXPECT_NEAR(*pace.secondsLeft(kStart + seconds(20)), 20, 1e-9);
}

TEST(Pace, DoesNotLookFastBecauseOfStagesFoundWhole) {
  Pace pace;
  pace.begin(0.5, kStart);
  pace.begin(0.5, kStart + milliseconds(100));
  pace.report(0.5, kStart + milliseconds(10100));
  EXPECT_DOUBLE_EQ(pace.fraction(), 0.75);
  EXPECT_NEAR(*pace.secondsLeft(kStart + milliseconds(10100)), 10, 1e-9);
}

TEST(Pace, TakesASlowStageInLittleByLittle) {
  Pace pace;
  pace.begin(0.5, kStart);
  Pace::Clock::time_point now = kStart;
  for (int percent = 1; percent <= 100; ++percent)
    pace.report(percent / 100.0, now = kStart + seconds(percent));
  ASSERT_NEAR(*pace.secondsLeft(now), 100, 1);
  // Its second half is five times as slow: 500 s.
  pace.begin(0.5, now);
  double before = *pace.secondsLeft(now), most = before;
  for (int second = 1; second <= 400; ++second) {
    pace.report(second / 500.0, now += seconds(1));
    const double left = *pace.secondsLeft(now);
    EXPECT_LT(left - before, 5) << "in a second, at " << second;
    before = left;
    most = std::max(most, left);
  }
  EXPECT_LT(most, 350);
  EXPECT_NEAR(before, 100, 30) << "within 30 % once most of the stage is done";
}

// Reports that come in leaps, as of a few large pieces of work.
TEST(Pace, DoesNotSwingWhereReportsAreRare) {
  Pace pace;
  pace.begin(1, kStart);
  Pace::Clock::time_point now = kStart;
  double before = 0, grown = 0;
  for (int second = 1; second < 100; ++second) {
    now += seconds(1);
    if (second % 10 == 0) pace.report(second / 100.0, now);
    const std::optional<double> left = pace.secondsLeft(now);
    if (left && before > 0) grown += std::max(0.0, *left - before);
    before = left.value_or(0);
  }
  EXPECT_LT(grown, 1);
}

TEST(Pace, DoesNotCountAPauseAsWork) {
  Pace pace;
  pace.begin(1, kStart);
  pace.report(0.5, kStart + seconds(10));
  pace.skip(seconds(3600));
  EXPECT_NEAR(*pace.secondsLeft(kStart + seconds(3610)), 10, 1e-9);
}

TEST(Pace, TakesWorkWithoutStagesForOneWhole) {
  Pace pace;
  EXPECT_FALSE(pace.secondsLeft(kStart + seconds(10)));
  pace.report(0, kStart);
  pace.report(0.5, kStart + seconds(10));
  EXPECT_DOUBLE_EQ(pace.fraction(), 0.5);
  EXPECT_NEAR(*pace.secondsLeft(kStart + seconds(10)), 10, 1e-9);
}

TEST(Pace, DoesNotCountWhatWasReportedBeforeTheFirstStage) {
  Pace pace;
  pace.report(1, kStart);
  pace.begin(0.5, kStart + seconds(10));
  EXPECT_DOUBLE_EQ(pace.fraction(), 0);
}

}  // namespace
}  // namespace ostraka
