#include "ui/widgets/open_outside.h"

#include <QDesktopServices>
#include <QUrl>
#include <QtTest>

#include "tests/ui/program.h"

using namespace ostraka::ui;

class OpenOutsideTest : public QObject {
  Q_OBJECT

 public slots:
  void take(const QUrl& url) { taken_ = url; }

 private slots:
  // Some desktops have no program for it and do not say so.
  void thePathOfWhatOpensIsToldAsWell() {
    QDesktopServices::setUrlHandler(QStringLiteral("file"), this, "take");
    QCOMPARE(openOutside(QStringLiteral("/p/report one.html")),
             QStringLiteral("Opening /p/report one.html. If it does not appear, open it by hand."));
    QDesktopServices::unsetUrlHandler(QStringLiteral("file"));
    QCOMPARE(taken_.toLocalFile(), QStringLiteral("/p/report one.html"));
  }

  void whereNoProgramOpensItThePathIsTold() {
    for (const char* name : {"PATH", "BROWSER", "DESKTOP_SESSION", "XDG_CURRENT_DESKTOP"})
      qputenv(name, "");
    const QString told = openOutside(QStringLiteral("/p/report.html"));
    QVERIFY2(told.contains("/p/report.html"), qPrintable(told));
  }

 private:
  QUrl taken_;
};

OSTRAKA_UI_TEST(OpenOutsideTest)
#include "open_outside_test.moc"
