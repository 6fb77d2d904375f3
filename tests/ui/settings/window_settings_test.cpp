#include "ui/settings/window_settings.h"

#include <QSettings>
#include <QtTest>

#include "tests/ui/program.h"

using namespace ostraka::ui;

class WindowSettingsTest : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    folder_ = std::make_unique<QTemporaryDir>();
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder_->path());
  }

  void whatIsWrittenIsReadBack() {
    WindowSettings settings;
    settings.theme = Theme::Sunlight;
    settings.text_percent = 150;
    settings.initials = QStringLiteral("ΑΠ");
    settings.recent = {QStringLiteral("/a b/ü"), QStringLiteral("/c")};
    settings.geometry = QByteArray("\x01\x00\x02", 3);
    writeSettings(settings);
    const WindowSettings back = readSettings();
    QCOMPARE(back.theme, settings.theme);
    QCOMPARE(back.text_percent, 150);
    QCOMPARE(back.initials, settings.initials);
    QCOMPARE(back.recent, settings.recent);
    QCOMPARE(back.geometry, settings.geometry);
  }

  void aProjectKeepsItsTitleAndItsPlaceWhenItIsMoved() {
    WindowSettings settings;
    settings.remember("/a", {"Aragats", 2});
    settings.remember("/b", {"Other", 0});
    settings.moved("/a", "/new/a");
    writeSettings(settings);
    const WindowSettings back = readSettings();
    QCOMPARE(back.recent, (QStringList{"/b", "/new/a"}));
    QCOMPARE(back.projects,
             (QMap<QString, RecentProject>{{"/b", {"Other", 0}}, {"/new/a", {"Aragats", 2}}}));
  }

  void whatAnotherWindowChangedMeanwhileStays() {
    OpenSettings first;
    first.remember("/a", {"Aragats", 0});
    first.keep();
    OpenSettings mine, other;
    mine.theme = Theme::Dark;
    other.theme = Theme::Sunlight;
    other.language = QStringLiteral("de");
    other.remember("/b", {"Other", 0});
    other.keep();
    mine.keep();
    for (const WindowSettings& both : {static_cast<WindowSettings>(mine), readSettings()}) {
      QCOMPARE(both.theme, Theme::Dark);
      QCOMPARE(both.language, QString("de"));
      QCOMPARE(both.recent, (QStringList{"/a", "/b"}));
      QCOMPARE(both.projects.value("/b").title, QString("Other"));
    }
    other.theme = Theme::Light;  // mine changed nothing since
    other.keep();
    mine.keep();
    QCOMPARE(mine.theme, Theme::Light);
  }

  void aProjectThatWasForgottenHereDoesNotComeBack() {
    OpenSettings settings;
    settings.remember("/a", {"Aragats", 0});
    settings.keep();
    settings.forget("/a");
    settings.keep();
    QVERIFY(settings.recent.isEmpty());
    QVERIFY(readSettings().recent.isEmpty());
  }

  void valuesOutOfRangeBecomeTheDefault() {
    QSettings raw(QSettings::IniFormat, QSettings::UserScope, "ostraka", "window");
    raw.setValue("text_percent", 5000);
    raw.setValue("threads", -3);
    raw.setValue("theme", "pink");
    raw.sync();
    const WindowSettings settings = readSettings();
    QCOMPARE(settings.text_percent, 100);
    QCOMPARE(settings.threads, 0);
    QCOMPARE(settings.theme, Theme::Light);
  }

  void theLastProjectComesFirstAndOnceOnly() {
    WindowSettings settings;
    for (int i = 0; i < 12; ++i) settings.remember(QString::number(i), {});
    settings.remember(QStringLiteral("8"), {});
    QCOMPARE(settings.recent.size(), kMostRecentProjects);
    QCOMPARE(settings.recent.first(), QStringLiteral("8"));
    QCOMPARE(settings.recent.count(QStringLiteral("8")), 1);
  }

 private:
  std::unique_ptr<QTemporaryDir> folder_;
};

OSTRAKA_UI_TEST(WindowSettingsTest)
#include "window_settings_test.moc"
