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
  EXPECT_NEAR(*pace.secondsLeft(kStart + seconds(80)), 320, 1e-6);
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
