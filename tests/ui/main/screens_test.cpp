// Every screen of the window: reached by keys, each control with a name, in all themes and text
// sizes. With OSTRAKA_SCREENSHOTS set to a folder a picture of each is written there: of a fresh
// project, or of the one that OSTRAKA_PROJECT names, with computed batches and the virtual rig. So
// the pictures of the manual and of resources/docs are made.
#include <QAbstractSlider>
#include <QAction>
#include <QComboBox>
#include <QDir>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableView>
#include <QTextBrowser>
#include <QTranslator>

#include "../names.h"
#include "catalogue/project.h"
#include "person.h"
#include "ui/capture/capture_wizard.h"
#include "ui/frame/look.h"
#include "ui/frame/page_area.h"
#include "ui/frame/project_session.h"
#include "ui/frame/station.h"
#include "ui/jobs/job.h"
#include "ui/main/main_window.h"
#include "ui/main/new_project.h"
#include "ui/queue/batch_queue.h"
#include "ui/viewport/sherd_view.h"

using namespace ostraka;
using namespace ostraka::ui;

class ScreensTest : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    home_ = std::make_unique<Home>();
    jobs_ = std::make_unique<ThreadedJobRunner>();
    window_ = std::make_unique<MainWindow>(*jobs_);
    window_->resize(1280, 720);
    activate(*window_);
  }
  void cleanup() {
    window_.reset();
    jobs_.reset();
    applyLook(*qApp, Theme::Light, 100);
  }

  void eachControlHasANameForScreenReaders() {
    const QStringList at_start = namelessIn(*window_);
    QVERIFY2(at_start.isEmpty(), qPrintable(at_start.join(QLatin1Char('\n'))));
    openVirtual();
    const QStringList with_project = namelessIn(*window_);
    QVERIFY2(with_project.isEmpty(), qPrintable(with_project.join(QLatin1Char('\n'))));
  }

  void theExampleFollowsTheTypingOnTheStartScreen() {
    QTest::keyClicks(named<QLineEdit>(*window_, "newSite"), "arm7");
    QCOMPARE(named<QLabel>(*window_, "newExample")->text(), QStringLiteral("ARM7-T3-0012-0007"));
    QTest::keyClicks(named<QLineEdit>(*window_, "newName"), "Seven");
    QTest::mouseClick(named<QPushButton>(*window_, "makeProject"), Qt::LeftButton);
    QVERIFY(window_->session() != nullptr);
    activate(*window_);
    QTest::keyClick(window_.get(), Qt::Key_W, Qt::ControlModifier);
    QVERIFY(window_->session() == nullptr);
    QVERIFY(named<QWidget>(*window_, "recentProjects")->isVisible());
  }

  void theKeysGoFromStationToStation() {
    openVirtual();
    const auto& stations = window_->stations();
    for (std::size_t i = 0; i < stations.size(); ++i) {
      QTest::keyClick(window_.get(), static_cast<Qt::Key>(Qt::Key_1 + static_cast<int>(i)),
                      Qt::ControlModifier);
      QTRY_VERIFY2(stations[i]->isVisible(), qPrintable(stations[i]->title()));
    }
    QTest::keyClick(window_.get(), Qt::Key_F1);
    QTRY_VERIFY(named<QTextBrowser>(*window_, "helpText")->isVisible());
    QVERIFY(named<QTextBrowser>(*window_, "helpText")->toPlainText().size() > 100);
    QTest::keyClick(window_.get(), Qt::Key_Escape);
    QTRY_VERIFY(stations.back()->isVisible());
  }

  void theSameProjectIsNotOpenedTwice() {
    openVirtual();
    const QString folder = QString::fromStdString(window_->session()->folder().string());
    MainWindow other(*jobs_);
    other.openProject(folder);
    QVERIFY(other.session() == nullptr);
  }

  void theCataloguesFileOpensItsProject() {
    openVirtual();
    window_->closeProject();
    window_->openProject(project_ + "/catalogue.sqlite");
    QVERIFY(window_->session() != nullptr);
    QCOMPARE(QString::fromStdString(window_->session()->folder().string()), project_);
  }

  void theFirst3DViewLeavesTheWindowItsKeyboard() {
    const WId id = window_->winId();
    openVirtual();
    for (const Qt::Key key : {Qt::Key_3, Qt::Key_5, Qt::Key_2, Qt::Key_1}) {
      QTest::keyClick(window_.get(), key, Qt::ControlModifier);
      QCoreApplication::processEvents();
    }
    QVERIFY(window_->findChild<QWidget*>("canvas") != nullptr);
    QCOMPARE(window_->winId(), id);
    QVERIFY(window_->isActiveWindow());
    QTRY_VERIFY(window_->focusWidget() != nullptr);
  }

  void aFolderThatIsNoProjectIsRefusedOnTheStartScreen() {
    window_->openProject(home_->path("nothing"));
    QVERIFY(window_->session() == nullptr);
    QVERIFY(named<QWidget>(*window_, "startMessage")->isVisible());
  }

  void theThemeAndTheTextSizeHoldAtOnceAndAreKept() {
    QTest::keyClick(window_.get(), Qt::Key_Comma, Qt::ControlModifier);
    auto* theme = named<QComboBox>(*window_, "settingsTheme");
    QTRY_VERIFY(theme->isVisible());
    const double before = QApplication::font().pointSizeF();
    theme->setCurrentIndex(theme->findData(static_cast<int>(Theme::Dark)));
    QVERIFY(QApplication::palette().color(QPalette::Base).lightness() < 64);
    named<QAbstractSlider>(*window_, "settingsText")->setValue(15);
    QVERIFY(qAbs(QApplication::font().pointSizeF() - 1.5 * before) < 0.01);
    window_->close();
    QCOMPARE(readSettings().theme, Theme::Dark);
    QCOMPARE(readSettings().text_percent, 150);
  }

  void theWindowFitsASmallLaptopInEachTextSize() {
    const QSize laptop(1280, 690);  // 1280 x 720 below a title
    openVirtual();
    for (const int percent : {100, 150, 200}) {
      applyLook(*qApp, Theme::Light, percent);
      for (std::size_t i = 0; i < window_->stations().size(); ++i) {
        window_->showStation(static_cast<int>(i));
        QCoreApplication::processEvents();
        const QSize least = window_->minimumSizeHint();
        QVERIFY2(least.width() <= laptop.width() && least.height() <= laptop.height(),
                 qPrintable(QStringLiteral("%1 at %2 %: %3 x %4")
                                .arg(window_->stations()[i]->title())
                                .arg(percent)
                                .arg(least.width())
                                .arg(least.height())));
      }
    }
    // In the usual size nothing has to be scrolled.
    applyLook(*qApp, Theme::Light, 100);
    window_->resize(laptop);
    for (std::size_t i = 0; i < window_->stations().size(); ++i) {
      window_->showStation(static_cast<int>(i));
      QCoreApplication::processEvents();
      const QWidget* page = window_->stations()[i];
      const auto* area = qobject_cast<const PageArea*>(page->parentWidget()->parentWidget());
      QVERIFY(area != nullptr);
      QTRY_VERIFY2(page->size() == area->viewport()->size(),
                   qPrintable(QStringLiteral("%1: %2 in %3")
                                  .arg(window_->stations()[i]->title())
                                  .arg(page->height())
                                  .arg(area->viewport()->height())));
    }
  }

  void picturesOfAllScreens() {
    const QString folder = qEnvironmentVariable("OSTRAKA_SCREENSHOTS");
    const QString given = qEnvironmentVariable("OSTRAKA_PROJECT");
    if (!given.isEmpty()) project_ = given;
    QTranslator plurals;  // as the program has it: '1 sherd', '2 sherds'
    QVERIFY(plurals.load(QStringLiteral("ostraka_en"), QStringLiteral(OSTRAKA_QM)));
    QApplication::installTranslator(&plurals);
    window_ = std::make_unique<MainWindow>(*jobs_);
    window_->resize(1280, 720);
    activate(*window_);
    openVirtual();
    QTRY_COMPARE_WITH_TIMEOUT(window_->wizard()->phase(), CapturePhase::Place, 60000);
    QTRY_VERIFY_WITH_TIMEOUT(window_->wizard()->live().has_value(), 60000);
    if (given.isEmpty()) addBatches();
    for (const Theme theme : {Theme::Light, Theme::Dark, Theme::Sunlight}) {
      applyLook(*qApp, theme, theme == Theme::Sunlight ? 130 : 100);
      picture(folder, theme, "start", [this] { window_->closeProject(); });
      openVirtual();
      QTRY_VERIFY_WITH_TIMEOUT(window_->wizard()->live().has_value(), 60000);
      for (std::size_t i = 0; i < window_->stations().size(); ++i)
        picture(folder, theme, window_->stations()[i]->iconName(), [this, i] {
          window_->showStation(static_cast<int>(i));
          if (window_->stations()[i]->iconName() == QLatin1String("catalogue"))
            named<QTableView>(*window_, "sherds")->selectRow(0);
          if (window_->stations()[i]->iconName() == QLatin1String("export"))
            named<QLineEdit>(*window_, "target")->setText("/media/stick/season-3");
        });
      picture(folder, theme, "drawing", [this] {
        for (std::size_t i = 0; i < window_->stations().size(); ++i)
          if (window_->stations()[i]->iconName() == QLatin1String("catalogue"))
            window_->showStation(static_cast<int>(i));
        named<QAction>(*window_, "drawing")->trigger();
      });
      picture(folder, theme, "settings", [this] { window_->showSettings(); });
      picture(folder, theme, "help", [this] { window_->showManual(); });
      picture(folder, theme, "keys", [this] { window_->showShortcuts(); });
    }
  }

 private:
  void openVirtual() {
    if (project_.isEmpty() || !QDir(project_).exists()) {
      project_ = home_->path("Ostraka/Virtual");
      auto made = makeVirtualProject(project_);
      QVERIFY2(made.has_value(), made ? "" : made.error().sentence().c_str());
    }
    window_->openProject(project_);
    QVERIFY(window_->session() != nullptr);
  }

  // One of each state, so that the queue shows what it can.
  void addBatches() {
    catalogue::Catalogue& rows = window_->session()->project().catalogue();
    window_->queue()->setPaused(true);
    for (const catalogue::BatchState state :
         {catalogue::BatchState::Done, catalogue::BatchState::Review, catalogue::BatchState::Failed,
          catalogue::BatchState::Queued}) {
      catalogue::BatchRecord batch;
      batch.state = state;
      const auto row = rows.addBatch(batch, {});
      QVERIFY(row.has_value());
      const std::string number = rows.batch(*row)->number;
      if (state == catalogue::BatchState::Failed)
        (void)rows.setSetting("queue.failure." + number,
                              R"({"sentence":"front/cam1_pos03.jpg: only two markers are seen; )"
                              R"(photograph the fronts again."})");
      else if (state != catalogue::BatchState::Queued)
        (void)rows.setSetting("queue.figures." + number,
                              R"({"sherds":9,"sure":7,"ask":2,"uncertainty_mm":0.08})");
    }
    window_->session()->tellBatchChanged({});
  }

  template <class Go>
  void picture(const QString& folder, Theme theme, const QString& screen, Go go) {
    go();
    QCoreApplication::processEvents();
    // A person looks at these: with pictures from jobs, and with models and drawings.
    if (!folder.isEmpty()) QTest::qWait(qEnvironmentVariableIsSet("OSTRAKA_PROJECT") ? 5000 : 50);
    const QImage shown = window_->grab().toImage();
    QVERIFY(shown.width() >= 1280);
    if (!folder.isEmpty())
      QVERIFY(shown.save(QStringLiteral("%1/%2-%3.png").arg(folder, screen, themeName(theme))));
  }

  std::unique_ptr<Home> home_;
  std::unique_ptr<JobRunner> jobs_;
  std::unique_ptr<MainWindow> window_;
  QString project_;
};

int main(int argc, char** argv) {
  prepareOpenGl();
  QApplication application(argc, argv);
  applyLook(application, Theme::Light, 100);
  ScreensTest test;
  return QTest::qExec(&test, argc, argv);
}
#include "screens_test.moc"
