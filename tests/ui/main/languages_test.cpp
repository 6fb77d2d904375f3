// The window in every language: it fits a laptop's screen, and no button's words are cut off.
#include <QAbstractButton>
#include <QLabel>
#include <QToolButton>
#include <QTranslator>

#include "person.h"
#include "tests/ui/program.h"
#include "ui/frame/project_session.h"
#include "ui/frame/screen.h"
#include "ui/jobs/job.h"
#include "ui/look/look.h"
#include "ui/main/main_window.h"
#include "ui/main/new_project.h"

using namespace ostraka;
using namespace ostraka::ui;

namespace {

constexpr int kWidth = 1280, kHeight = 720;

// A tool button tells no least size, and is laid out by the usual one.
int leastOf(const QAbstractButton& button) {
  return qobject_cast<const QToolButton*>(&button) != nullptr ? button.sizeHint().width()
                                                              : button.minimumSizeHint().width();
}

// What is narrower than its words.
QStringList cutIn(const QWidget& screen) {
  QStringList cut;
  for (const QAbstractButton* button : screen.findChildren<QAbstractButton*>())
    if (button->isVisible() && !button->text().isEmpty() && button->width() < leastOf(*button))
      cut << button->text();
  return cut;
}

}  // namespace

class LanguagesTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { applyLook(*qApp, Theme::Light, 100); }
  void theWindowFitsALaptop_data() {
    QTest::addColumn<QString>("language");
    for (const char* language : {"en", "de", "fr", "es", "el", "tr", "hy"})
      QTest::newRow(language) << language;
  }
  void theWindowFitsALaptop() {
    QFETCH(QString, language);
    QTranslator translator;
    QVERIFY(translator.load(QStringLiteral("ostraka_") + language, QStringLiteral(OSTRAKA_QM)));
    QVERIFY(QApplication::installTranslator(&translator));
    const Home home;
    ThreadedJobRunner jobs;
    MainWindow window(jobs);
    window.resize(kWidth, kHeight);
    activate(window);
    fits(window, window, "start");
    {
      auto made = makeVirtualProject(home.path("Virtual"));
      QVERIFY(made.has_value());
    }
    window.openProject(home.path("Virtual"));
    QVERIFY(window.session() != nullptr);
    activate(window);
    for (std::size_t i = 0; i < window.screens().size(); ++i) {
      window.showScreen(static_cast<int>(i));
      QTRY_VERIFY(window.screens()[i]->isVisible());
      fits(window, *window.screens()[i], window.screens()[i]->iconName());
    }
    window.showSettings();
    fits(window, window, "settings");
    window.showManual();
    QCOMPARE(named<QLabel>(window, "helpNote")->isVisible(), language != QLatin1String("en"));
    fits(window, window, "manual");
    window.showShortcuts();
    QVERIFY(!named<QLabel>(window, "helpNote")->isVisible());
    QApplication::removeTranslator(&translator);
  }

 private:
  static void fits(const MainWindow& window, const QWidget& screen, const QString& name) {
    QTest::qWait(0);
    QString widths = name;
    for (const Screen* shown : window.screens())
      widths += QStringLiteral(", %1 %2").arg(shown->title()).arg(shown->minimumSizeHint().width());
    QVERIFY2(window.minimumSizeHint().width() <= kWidth, qPrintable(widths));
    const QStringList cut = cutIn(screen);
    QVERIFY2(cut.isEmpty(), qPrintable(name + ": " + cut.join(QStringLiteral(" | "))));
  }
};

OSTRAKA_UI_TEST(LanguagesTest)
#include "languages_test.moc"
