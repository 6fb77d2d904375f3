#include "ui/jobs/pace.h"

#include <QtTest>

using ostraka::ui::Pace;
using std::chrono::seconds;

class PaceTest : public QObject {
  Q_OBJECT

 private slots:
  void aGuessIsNotShown() {
    Pace pace;
    const Pace::Clock::time_point t0{};
    pace.begin(1, t0);
    pace.report(0.5, t0 + seconds(2));
    QVERIFY(!pace.secondsLeft(t0 + seconds(2)).has_value());  // below three seconds of work
    QVERIFY(pace.secondsLeft(t0 + seconds(4)).has_value());
  }

  void theTimeLeftFollowsThePaceOfAllStages() {
    Pace pace;
    const Pace::Clock::time_point t0{};
    pace.begin(0.25, t0);
    pace.begin(0.75, t0 + seconds(10));
    pace.report(1.0 / 3, t0 + seconds(20));
    QCOMPARE(pace.fraction(), 0.5);
    // Half of the job took 20 s: the other half takes as long.
    QVERIFY(qAbs(*pace.secondsLeft(t0 + seconds(20)) - 20) < 1e-9);
  }

  void stagesFoundWholeDoNotMakeItLookFast() {
    Pace pace;
    const Pace::Clock::time_point t0{};
    pace.begin(0.5, t0);
    pace.begin(0.5, t0 + std::chrono::milliseconds(100));
    pace.report(0.5, t0 + std::chrono::milliseconds(10100));
    QCOMPARE(pace.fraction(), 0.75);
    QVERIFY(qAbs(*pace.secondsLeft(t0 + std::chrono::milliseconds(10100)) - 10) < 1e-9);
  }

  void aPauseIsNotWork() {
    Pace pace;
    const Pace::Clock::time_point t0{};
    pace.begin(1, t0);
    pace.report(0.5, t0 + seconds(10));
    pace.skip(seconds(3600));
    QVERIFY(qAbs(*pace.secondsLeft(t0 + seconds(3610)) - 10) < 1e-9);
  }
};

QTEST_GUILESS_MAIN(PaceTest)
#include "pace_test.moc"
