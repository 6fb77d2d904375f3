// Blue, white, orange; what was not seen stands on no scale.
#include <QTest>
#include <cmath>
#include <limits>

#include "tests/ui/program.h"
#include "ui/look/distance_scale.h"
#include "ui/look/state_colours.h"

namespace ostraka::ui {

class DistanceScaleTest : public QObject {
  Q_OBJECT

 private slots:
  void zeroIsWhiteAndTheEndsAreBlueAndOrange() {
    const DistanceScale scale(0.5);
    QVERIFY(scale.of(0).lightnessF() > 0.95);
    const StateColours light{QPalette(Qt::white)};
    QCOMPARE(scale.of(-0.5), light.of(State::Front));  // the side that lies outside
    QCOMPARE(scale.of(0.5), light.of(State::Back));
    QCOMPARE(scale.of(-7), scale.of(-0.5));
    QCOMPARE(scale.of(7), scale.of(0.5));
  }

  void lightnessFallsEvenlyFromZeroToBothEnds() {
    const DistanceScale scale(2);
    for (double distance = 0.1; distance <= 2; distance += 0.1) {
      QVERIFY(scale.of(distance).lightnessF() < scale.of(distance - 0.1).lightnessF());
      QVERIFY(scale.of(-distance).lightnessF() < scale.of(0.1 - distance).lightnessF());
    }
  }

  void whatWasNotSeenHasAColourOfNoDistance() {
    const DistanceScale scale(1);
    QCOMPARE(scale.of(std::numeric_limits<double>::quiet_NaN()), DistanceScale::notSeen());
    const QColor unseen = DistanceScale::notSeen();
    QVERIFY2(unseen.hslSaturationF() > 0.5, "grey is a colour of the clay");
    for (double distance = -1; distance <= 1; distance += 0.01) {
      const QColor c = scale.of(distance);
      const double apart =
          std::hypot(c.red() - unseen.red(), c.green() - unseen.green(), c.blue() - unseen.blue());
      QVERIFY2(apart > 80, qPrintable(c.name()));
    }
  }
};

OSTRAKA_UI_TEST(DistanceScaleTest)

}  // namespace ostraka::ui

#include "distance_scale_test.moc"
