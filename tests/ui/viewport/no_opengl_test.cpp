// Without OpenGL the view is a sentence, and everything that one may ask of it goes on.
#include <QLabel>
#include <QTest>

#include "tests/ui/program.h"
#include "ui/viewport/sherd_view.h"

namespace ostraka::ui {

class NoOpenGlTest : public QObject {
  Q_OBJECT

 private slots:
  void itSaysSoAndNothingBreaks();
};

void NoOpenGlTest::itSaysSoAndNothingBreaks() {
  QCOMPARE(QGuiApplication::platformName(), QStringLiteral("offscreen"));
  SherdView view;
  view.resize(400, 300);
  view.show();
  QVERIFY(!view.hasOpenGl());
  const auto* words = view.findChild<QLabel*>("noOpenGl");
  QVERIFY(words != nullptr);
  QVERIFY(words->text().contains("OpenGL"));
  ShownScan scan;
  scan.cloud.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  view.showScans(scan, scan, Eigen::Isometry3d::Identity());
  view.setPose(Eigen::Isometry3d::Identity());
  view.setDistances({{0.1f}, {0.2f}, 0.5});
  view.setApart(true);
  view.setSection(true);
  view.setMeasuring(true);
  view.setMeasure({0, 0, 0}, {1, 0, 0}, "1 mm");
  view.showModel({});
  view.clear();
  view.resetView();
  QVERIFY(view.isApart());
  QVERIFY(!view.grab().isNull());
}

OSTRAKA_UI_TEST(NoOpenGlTest)

}  // namespace ostraka::ui

#include "no_opengl_test.moc"
