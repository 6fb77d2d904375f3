// Every screen of the window: reached by keys, each control with a name, in all themes and text
// sizes. With OSTRAKA_SCREENSHOTS set to a folder a picture of each is written there: of a fresh
// project, or of the one that OSTRAKA_PROJECT names, with computed batches and the virtual rig. So
// tests/bench/manual_pictures.sh makes the pictures of the manual and of the README.
#include <QAbstractSlider>
#include <QAction>
#include <QComboBox>
#include <QDir>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QPushButton>
#include <QScrollBar>
#include <QTabWidget>
#include <QTableView>
#include <QTextBrowser>
#include <QTranslator>

#include "../names.h"
#include "catalogue/batches.h"
#include "catalogue/settings.h"
#include "person.h"
#include "tests/ui/program.h"
#include "ui/frame/project_session.h"
#include "ui/frame/screen.h"
#include "ui/jobs/job.h"
#include "ui/look/look.h"
#include "ui/main/main_window.h"
#include "ui/main/new_project.h"
#include "ui/main/project_lock.h"
#include "ui/queue/batch_queue.h"
#include "ui/queue/queue_switches.h"
#include "ui/viewport/sherd_view.h"
#include "ui/widgets/message_panel.h"
#include "ui/widgets/page_area.h"
#include "ui/wizard/batch_description.h"
#include "ui/wizard/capture_wizard.h"
#include "ui/wizard/plate_pictures.h"
#include "ui/wizard/side_progress.h"
#include "upkeep/project.h"

using namespace ostraka;
using namespace ostraka::ui;

class ScreensTest : public QObject {
  Q_OBJECT

 public:
  static void initMain() { prepareOpenGl(); }

 private slots:
  void initTestCase() { applyLook(*qApp, Theme::Light, 100); }
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

  // From the first start to the bag of the first batch, without a mouse.
  void theFirstRunGoesByKeyboardAlone() {
    const auto inHand = [] { return QApplication::focusWidget()->objectName(); };
    const auto press = [](int key, Qt::KeyboardModifiers with = Qt::NoModifier) {
      QTest::keyClick(QApplication::focusWidget(), static_cast<Qt::Key>(key), with);
    };
    const auto type = [](const char* text) {
      QTest::keyClicks(QApplication::focusWidget(), QString::fromLatin1(text));
    };
    QTRY_VERIFY(QApplication::focusWidget() != nullptr);
    QCOMPARE(inHand(), QStringLiteral("startPhotographs"));
    press(Qt::Key_N, Qt::AltModifier);
    QCOMPARE(inHand(), QStringLiteral("newName"));
    type("Seven");
    for (const char* next : {"newSite", "newFolder", "newBrowse", "newNumbering", "makeProject"}) {
      if (inHand() == QLatin1String("newSite")) type("arm7");
      press(Qt::Key_Tab);
      QCOMPARE(inHand(), QString::fromLatin1(next));
    }
    press(Qt::Key_Space);
    QVERIFY(window_->session() != nullptr);
    activate(*window_);
    QCOMPARE(window_->wizard()->phase(), CapturePhase::NoRig);
    press(Qt::Key_S, Qt::AltModifier);
    QCOMPARE(inHand(), QStringLiteral("virtualSherds"));
    type("2");
    press(Qt::Key_P, Qt::AltModifier);
    QCOMPARE(inHand(), QStringLiteral("virtualWidth"));
    press(Qt::Key_Home);
    named<QPushButton>(*window_, "useVirtualRig")->setFocus();
    press(Qt::Key_Space);
    QCOMPARE(window_->wizard()->phase(), CapturePhase::NoRig);
    press(Qt::Key_Space);  // the answer to its question
    QVERIFY(window_->wizard()->phase() != CapturePhase::NoRig);
    press(Qt::Key_B, Qt::AltModifier);
    QCOMPARE(inHand(), QStringLiteral("capturePlace"));
    type("ARM7 T3 0012 4");
    press(Qt::Key_Return);
    QCOMPARE(window_->wizard()->description()->place().typed(), QStringLiteral("ARM7-T3-0012-4"));
  }

  void theKeysGoFromScreenToScreen() {
    openVirtual();
    const auto& screens = window_->screens();
    for (std::size_t i = 0; i < screens.size(); ++i) {
      QTest::keyClick(window_.get(), static_cast<Qt::Key>(Qt::Key_1 + static_cast<int>(i)),
                      Qt::ControlModifier);
      QTRY_VERIFY2(screens[i]->isVisible(), qPrintable(screens[i]->title()));
    }
    QTest::keyClick(window_.get(), Qt::Key_F1);
    QTRY_VERIFY(named<QTextBrowser>(*window_, "helpText")->isVisible());
    QVERIFY(named<QTextBrowser>(*window_, "helpText")->toPlainText().size() > 100);
    QTest::keyClick(window_.get(), Qt::Key_Escape);
    QTRY_VERIFY(screens.back()->isVisible());
    for (const auto& [key, with] :
         {std::pair(Qt::Key_F1, Qt::NoModifier), std::pair(Qt::Key_Comma, Qt::ControlModifier)}) {
      QTest::keyClick(window_.get(), key, with);
      QTRY_VERIFY(!screens.back()->isVisible());
      QTest::keyClick(window_.get(), Qt::Key_2, Qt::ControlModifier);
      QTRY_VERIFY(screens[1]->isVisible());
      window_->showScreen(static_cast<int>(screens.size()) - 1);
    }
  }

  void theSameProjectIsNotOpenedTwice() {
    openVirtual();
    const QString folder = QString::fromStdString(window_->session()->folder().string());
    MainWindow other(*jobs_);
    other.openProject(folder);
    QVERIFY(other.session() == nullptr);
  }

  void aProjectThatWasMovedIsClosedAndOpensWhereItIsNow() {
    openVirtual();
    const QString moved = project_ + "-moved";
    QVERIFY(QDir().rename(project_, moved));
    window_->showScreen(3);
    QVERIFY(window_->session() == nullptr);
    auto* words = named<MessagePanel>(*window_, "startMessage");
    QVERIFY2(words->words().contains("not there any more"), qPrintable(words->words()));
    QVERIFY(!QFile::exists(project_));
    window_->openProject(moved);  // its lock is this window's own
    QVERIFY(window_->session() != nullptr);
    window_->closeProject();
    QVERIFY(QDir().rename(moved, project_));
  }

  // Opening may bring the catalogue up to date: never under the hands of another window.
  void aProjectThatIsOpenElsewhereIsNotEvenRead() {
    openVirtual();
    window_->closeProject();
    QFile catalogue(project_ + "/catalogue.sqlite");
    QVERIFY(catalogue.open(QIODevice::WriteOnly));
    catalogue.write("no catalogue");
    catalogue.close();
    auto* words = named<MessagePanel>(*window_, "startMessage");
    {
      const auto elsewhere = ProjectLock::take(project_);
      QVERIFY(elsewhere != nullptr);
      window_->openProject(project_);
      QVERIFY(window_->session() == nullptr);
      QVERIFY2(words->words().contains("another window"), qPrintable(words->words()));
    }
    {  // by another name of the folder
      const QString link = project_ + ".link";
      QVERIFY(QFile::link(project_, link));
      const auto elsewhere = ProjectLock::take(link);
      QVERIFY(elsewhere != nullptr);
      window_->openProject(project_);
      QVERIFY2(words->words().contains("another window"), qPrintable(words->words()));
      QVERIFY(QFile::remove(link));
    }
    window_->openProject(project_);
    QVERIFY(window_->session() == nullptr);
    QVERIFY(!words->words().contains("another window"));
    QVERIFY(!QFile::exists(project_ + "/.ostraka.lock"));  // who could not open it holds nothing
    QVERIFY(QFile::remove(project_ + "/catalogue.sqlite"));
    project_.clear();
  }

  void theScreenOfTheLastTimeIsInFrontAgain() {
    openVirtual();
    QVERIFY(window_->screens()[0]->isVisible());
    window_->showScreen(2);
    window_->close();
    window_ = std::make_unique<MainWindow>(*jobs_);
    activate(*window_);
    openVirtual();
    QVERIFY(window_->screens()[2]->isVisible());
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

  void eachLanguageStandsInTheListByItsOwnNameWithACapital() {
    QTest::keyClick(window_.get(), Qt::Key_Comma, Qt::ControlModifier);
    const auto* languages = named<QComboBox>(*window_, "settingsLanguage");
    QStringList names;
    for (int i = 1; i < languages->count(); ++i) names << languages->itemText(i);
    QCOMPARE(names, QStringList({"English", "Deutsch", "Français", "Español", "Ελληνικά", "Türkçe",
                                 "Հայերեն"}));
  }

  void theWindowFitsASmallLaptopInEachTextSize() {
    const QSize laptop(1280, 690);  // 1280 x 720 below a title
    openVirtual();
    for (const int percent : {100, 150, 200}) {
      applyLook(*qApp, Theme::Light, percent);
      for (std::size_t i = 0; i < window_->screens().size(); ++i) {
        window_->showScreen(static_cast<int>(i));
        QCoreApplication::processEvents();
        const QSize least = window_->minimumSizeHint();
        QVERIFY2(least.width() <= laptop.width() && least.height() <= laptop.height(),
                 qPrintable(QStringLiteral("%1 at %2 %: %3 x %4")
                                .arg(window_->screens()[i]->title())
                                .arg(percent)
                                .arg(least.width())
                                .arg(least.height())));
      }
    }
    // However large the letters are: the next thing to do is in sight, and nothing lies beside it.
    window_->resize(laptop);
    for (std::size_t i = 0; i < window_->screens().size(); ++i) {
      window_->showScreen(static_cast<int>(i));
      const QScrollArea* area = areaOf(*window_->screens()[i]);
      QVERIFY(area != nullptr);
      QTRY_VERIFY2(area->horizontalScrollBar()->maximum() == 0,
                   qPrintable(window_->screens()[i]->title()));
      if (window_->screens()[i]->iconName() != QLatin1String("export"))  // a list of choices
        QTRY_VERIFY2(area->verticalScrollBar()->maximum() == 0,
                     qPrintable(window_->screens()[i]->title()));
    }
    window_->showScreen(0);
    QTRY_COMPARE_WITH_TIMEOUT(window_->wizard()->phase(), CapturePhase::Place, 60000);
    const auto* next = named<QPushButton>(*window_, "captureButton");
    QTRY_COMPARE(next->visibleRegion().boundingRect(), next->rect());
    // Nor do the bold letters of the sunlight widen it while sherds are being placed.
    applyLook(*qApp, Theme::Sunlight, 200);
    QCoreApplication::processEvents();
    QTRY_COMPARE(areaOf(*window_->screens()[0])->horizontalScrollBar()->maximum(), 0);
    QCOMPARE(window_->width(), laptop.width());
    // In the usual size nothing has to be scrolled.
    applyLook(*qApp, Theme::Light, 100);
    window_->resize(laptop);
    for (std::size_t i = 0; i < window_->screens().size(); ++i) {
      window_->showScreen(static_cast<int>(i));
      QCoreApplication::processEvents();
      const QWidget* page = window_->screens()[i];
      const QScrollArea* area = areaOf(*page);
      QVERIFY(area != nullptr);
      QTRY_VERIFY2(page->size() == area->viewport()->size(),
                   qPrintable(QStringLiteral("%1: %2 in %3")
                                  .arg(window_->screens()[i]->title())
                                  .arg(page->height())
                                  .arg(area->viewport()->height())));
    }
  }

  void picturesOfAllScreens() {
    folder_ = qEnvironmentVariable("OSTRAKA_SCREENSHOTS");
    const QString given = qEnvironmentVariable("OSTRAKA_PROJECT");
    if (!given.isEmpty()) {
      project_ = given;
      // No picture says on which computer it was taken: the project lies in ~/Ostraka.
      qputenv("HOME", QFileInfo(QFileInfo(given).path()).path().toUtf8());
    }
    QTranslator plurals, words;  // as the program has it: '1 sherd', '2 sherds'
    QVERIFY(plurals.load(QStringLiteral("ostraka_en"), QStringLiteral(OSTRAKA_QM)));
    QApplication::installTranslator(&plurals);
    const QString language = qEnvironmentVariable("OSTRAKA_SCREENSHOTS_LANGUAGE");
    if (!language.isEmpty()) {
      QVERIFY(words.load(QStringLiteral("ostraka_") + language, QStringLiteral(OSTRAKA_QM)));
      QApplication::installTranslator(&words);
    }
    window_ = std::make_unique<MainWindow>(*jobs_);
    window_->resize(pictureSize());
    activate(*window_);
    openVirtual();
    showScreen("capture");  // a project with results opens with another, without live pictures
    QTRY_COMPARE_WITH_TIMEOUT(window_->wizard()->phase(), CapturePhase::Place, 60000);
    QTRY_VERIFY_WITH_TIMEOUT(window_->wizard()->pictures()->live().has_value(), 60000);
    if (given.isEmpty()) addBatches();
    for (const Theme theme : themes()) {
      look(theme);
      picture(theme, "start", [this] { window_->closeProject(); });
      openVirtual();
      showScreen("capture");
      QTRY_VERIFY_WITH_TIMEOUT(window_->wizard()->pictures()->live().has_value(), 60000);
      for (const Screen* screen : window_->screens())
        picture(theme, screen->iconName(), [this, screen] { showScreen(screen->iconName()); });
      picture(theme, "drawing", [this] {
        showScreen("catalogue");
        named<QAction>(*window_, "drawing")->trigger();
      });
      picture(theme, "masks", [this] {
        showScreen("queue");
        auto* list = named<QListView>(*window_, "queueList");  // the oldest is computed
        list->setCurrentIndex(list->model()->index(list->model()->rowCount() - 1, 0));
        named<QAction>(*window_, "queueMasks")->trigger();
      });
      named<QAction>(*window_, "masksBack")->trigger();
      picture(theme, "settings", [this] { window_->showSettings(); });
      picture(theme, "help", [this] { window_->showManual(); });
      picture(theme, "keys", [this] { window_->showShortcuts(); });
    }
    // Only for pictures that a person looks at: a whole batch is photographed.
    if (!folder_.isEmpty() && qEnvironmentVariableIsSet("OSTRAKA_SCREENSHOTS_CAPTURE"))
      picturesOfACapture();
  }

 private:
  static const QScrollArea* areaOf(const QWidget& page) {
    return qobject_cast<const PageArea*>(page.parentWidget()->parentWidget());
  }
  void openVirtual() {
    if (project_.isEmpty() || !QDir(project_).exists()) {
      project_ = home_->path("Ostraka/Virtual");
      auto made = makeVirtualProject(project_);
      QVERIFY2(made.has_value(), made ? "" : made.error().sentence().english().c_str());
    }
    window_->openProject(project_);
    QVERIFY(window_->session() != nullptr);
  }

  // One of each state, so that the queue shows what it can.
  void addBatches() {
    catalogue::Catalogue& rows = window_->session()->project().catalogue();
    window_->queue()->switches()->setPaused(true);
    for (const records::BatchState state :
         {records::BatchState::Done, records::BatchState::Review, records::BatchState::Failed,
          records::BatchState::Queued}) {
      records::BatchRecord batch;
      batch.state = state;
      const auto row = catalogue::Batches(rows).add(batch, {});
      QVERIFY(row.has_value());
      const std::string number = catalogue::Batches(rows).get(*row)->number;
      if (state == records::BatchState::Failed)
        (void)catalogue::Settings(rows).setValue(
            "queue.failure." + number,
            R"({"sentence":"front/cam1_pos03.jpg: only two markers are seen; )"
            R"(photograph the fronts again."})");
      else if (state != records::BatchState::Queued)
        (void)catalogue::Settings(rows).setValue(
            "queue.figures." + number, R"({"sherds":9,"sure":7,"ask":2,"uncertainty_mm":0.08})");
    }
    window_->session()->tellBatchChanged({});
  }

  // OSTRAKA_SCREENSHOTS_THEME=light makes those of one theme.
  static QVector<Theme> themes() {
    const QString one = qEnvironmentVariable("OSTRAKA_SCREENSHOTS_THEME");
    if (!one.isEmpty()) return {themeFromName(one)};
    return {Theme::Light, Theme::Dark, Theme::Sunlight};
  }

  // OSTRAKA_SCREENSHOTS_SIZE=1366x700 and OSTRAKA_SCREENSHOTS_TEXT=200 try other screens.
  static QSize pictureSize() {
    const QStringList size = qEnvironmentVariable("OSTRAKA_SCREENSHOTS_SIZE").split('x');
    return size.size() == 2 ? QSize(size[0].toInt(), size[1].toInt()) : QSize(1280, 720);
  }
  static void look(Theme theme) {
    const int asked = qEnvironmentVariableIntValue("OSTRAKA_SCREENSHOTS_TEXT");
    applyLook(*qApp, theme, asked > 0 ? asked : theme == Theme::Sunlight ? 130 : 100);
  }

  void showScreen(const QString& icon_name) {
    window_->showScreenNamed(icon_name, {});
    if (icon_name == QLatin1String("catalogue")) {
      named<QTabWidget>(*window_, "right")->setCurrentIndex(0);
      named<QTableView>(*window_, "sherds")->selectRow(0);
    }
    if (icon_name == QLatin1String("export")) {
      auto* target = named<QLineEdit>(*window_, "target");
      target->setText("/media/stick/season-3");
      emit target->textEdited(target->text());  // typed: no proposal takes its place
    }
  }

  // Each step of the wizard in all themes.
  void picturesOfACapture() {
    constexpr int kLong_ms = 1200000;
    CaptureWizard& wizard = *window_->wizard();
    window_->queue()->switches()->setPaused(true);
    showScreen("capture");
    const auto all = [&](const QString& screen) {
      for (const Theme theme : themes()) {
        look(theme);
        picture(theme, screen, [] {});
      }
    };
    wizard.next();
    QTRY_VERIFY_WITH_TIMEOUT(wizard.side()->stopsDone() >= 3, kLong_ms);
    all("capture-shoot");
    QTRY_COMPARE_WITH_TIMEOUT(wizard.phase(), CapturePhase::Flip, kLong_ms);
    all("capture-flip");
    wizard.next();
    QTRY_COMPARE_WITH_TIMEOUT(wizard.phase(), CapturePhase::Done, kLong_ms);
    all("capture-done");
  }

  // For pictures and models that come from jobs.
  static int waiting() {
    const int asked = qEnvironmentVariableIntValue("OSTRAKA_SCREENSHOTS_WAIT");
    return asked > 0 ? asked : 5000;
  }

  template <class Go>
  void picture(Theme theme, const QString& screen, Go go) {
    go();
    QCoreApplication::processEvents();
    // A person looks at these: with pictures from jobs, and with models and drawings.
    if (!folder_.isEmpty())
      QTest::qWait(qEnvironmentVariableIsSet("OSTRAKA_PROJECT") ? waiting() : 50);
    const QImage shown = window_->grab().toImage();
    QVERIFY(shown.width() >= pictureSize().width());
    if (!folder_.isEmpty())
      QVERIFY(shown.save(QStringLiteral("%1/%2-%3.png").arg(folder_, screen, themeName(theme))));
  }

  std::unique_ptr<Home> home_;
  std::unique_ptr<JobRunner> jobs_;
  std::unique_ptr<MainWindow> window_;
  QString project_;
  QString folder_;  ///< of the pictures; empty: none are kept
};

OSTRAKA_UI_TEST(ScreensTest)
#include "records/records.h"
#include "screens_test.moc"
