// What the frame around the screens does, without a rig and without computing.
#include <QAction>
#include <QComboBox>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QScreen>
#include <QTableView>
#include <QUndoStack>
#include <atomic>
#include <thread>

#include "archive/archive.h"
#include "catalogue/batches.h"
#include "catalogue/files.h"
#include "files/files.h"
#include "person.h"
#include "records/sherd.h"
#include "sherds/sherds.h"
#include "tests/ui/program.h"
#include "ui/frame/project_session.h"
#include "ui/frame/screen.h"
#include "ui/jobs/job.h"
#include "ui/main/main_window.h"
#include "ui/main/project_lock.h"
#include "ui/main/start_screen.h"
#include "ui/main/window_place.h"
#include "ui/queue/batch_computation.h"
#include "ui/queue/batch_queue.h"
#include "ui/queue/queue_switches.h"
#include "ui/settings/window_settings.h"
#include "ui/widgets/message_panel.h"
#include "upkeep/project.h"

using namespace ostraka;
using namespace ostraka::ui;

class MainWindowTest : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    home_ = std::make_unique<Home>();
    folder_ = home_->path(QStringLiteral("Ostraka/p1"));
    records::ProjectRecord record;
    record.code = "ARM1";
    record.title = "Aragats 2026";
    const auto made = upkeep::Project::create(folder_.toStdString(), record);
    QVERIFY2(made.has_value(), made ? "" : made.error().sentence().english().c_str());
  }

  void settingsAndHelpAreThereBeforeAProjectIs() {
    MainWindow window(jobs_);
    activate(window);
    QTest::mouseClick(named<QPushButton>(window, "startSettings"), Qt::LeftButton);
    QVERIFY(!named<StartScreen>(window, "start")->isVisible());
    window.closeProject();
    named<QAction>(window, "leavePage")->trigger();
    QTRY_VERIFY(named<StartScreen>(window, "start")->isVisible());
    QTest::mouseClick(named<QPushButton>(window, "startHelp"), Qt::LeftButton);
    QVERIFY(!named<StartScreen>(window, "start")->isVisible());
  }

  void aProjectIsCalledByItsName() {
    MainWindow window(jobs_);
    activate(window);
    window.openProject(folder_);
    QVERIFY(window.windowTitle().startsWith("Aragats 2026"));
    QCOMPARE(named<QLabel>(window, "headerWhere")->text(), QStringLiteral("Aragats 2026"));
    window.closeProject();
    QVERIFY(recent(window)->item(0)->text().startsWith("Aragats 2026"));
  }

  void theStartScreenTellsWhichProjectsHaveUnfinishedBatches() {
    MainWindow window(jobs_);
    activate(window);
    window.openProject(folder_);
    window.queue()->switches()->setPaused(true);
    for (const auto state : {records::BatchState::Queued, records::BatchState::Done}) {
      records::BatchRecord batch;
      batch.state = state;
      const auto added = catalogue::Batches(window.session()->project().catalogue()).add(batch, {});
      QVERIFY(added.has_value());
    }
    window.session()->tellBatchChanged({});
    window.closeProject();
    const QString told = recent(window)->item(0)->text();
    QVERIFY2(told.endsWith("1 batch(es) unfinished"), qPrintable(told));
  }

  void aProjectThatIsGoneIsListedAndFoundAgain() {
    {
      MainWindow window(jobs_);
      activate(window);
      window.openProject(folder_);
      window.close();
    }
    const QString elsewhere = home_->path(QStringLiteral("moved"));
    QVERIFY(QDir().rename(folder_, elsewhere));
    MainWindow window(jobs_);
    activate(window);
    QCOMPARE(recent(window)->count(), 1);
    QVERIFY2(recent(window)->item(0)->text().contains("find it"),
             qPrintable(recent(window)->item(0)->text()));
    emit named<StartScreen>(window, "start")->found(folder_, elsewhere);
    QVERIFY(window.session() != nullptr);
    window.closeProject();
    QCOMPARE(recent(window)->count(), 1);
    QVERIFY(!recent(window)->item(0)->text().contains("find it"));
  }

  void eachProjectOpensOnThePageWhereItWasLeft() {
    const QString other = home_->path(QStringLiteral("Ostraka/p2"));
    records::ProjectRecord record;
    record.code = "P2";
    record.title = "Another";
    QVERIFY(upkeep::Project::create(other.toStdString(), record).has_value());
    MainWindow window(jobs_);
    activate(window);
    const auto inFront = [&](int page) {
      return window.screens()[static_cast<std::size_t>(page)]->isVisible();
    };
    window.openProject(folder_);
    QVERIFY(inFront(0));
    window.showScreen(1);
    window.openProject(other);
    QVERIFY2(inFront(0), "nobody was in this project yet");
    window.openProject(folder_);
    QVERIFY(inFront(1));
  }

  void theWindowOfALargerScreenOpensWithinThisOne() {
    const QRect room = QGuiApplication::primaryScreen()->availableGeometry();
    QWidget large;
    large.setGeometry(room.translated(60, 77));
    const QByteArray kept = large.saveGeometry();
    large.setWindowState(Qt::WindowMaximized);
    for (const QByteArray& geometry : {kept, large.saveGeometry(), QByteArray()}) {
      QWidget window;
      placeWindow(window, geometry);
      QVERIFY2(room.contains(window.normalGeometry()), geometry.toHex().constData());
      QVERIFY(window.width() > room.width() / 2);
    }
  }

  void aScreenLeadsToTheSettingsOfTheNumbering() {
    MainWindow window(jobs_);
    activate(window);
    window.openProject(folder_);
    emit window.screens().front()->wantsScreen("settings", "numbering");
    auto* scheme = named<QLineEdit>(window, "numberingScheme");
    QTRY_VERIFY(scheme->visibleRegion().boundingRect() == scheme->rect());
    QVERIFY(scheme->hasFocus());
  }

  void aStepThatIsRefusedIsToldOnThePageInFront() {
    MainWindow window(jobs_);
    activate(window);
    window.openProject(folder_);
    window.showSettings();
    auto* told = named<QLabel>(window, "settingsSaid");
    QVERIFY(!told->isVisible());
    window.session()->tellStepRefused("It was changed meanwhile.");
    QCOMPARE(told->text(), QStringLiteral("It was changed meanwhile."));
    QVERIFY(told->isVisible());
    window.leaveSidePage();
    window.showSettings();
    QVERIFY(!told->isVisible());
  }

  void anotherLanguageIsARestartAwayThatOpensTheProjectAgain() {
    const QLocale before;
    QLocale::setDefault(QLocale(QLocale::German));
    MainWindow window(jobs_);
    activate(window);
    window.openProject(folder_);
    window.showSettings();
    auto* language = named<QComboBox>(window, "settingsLanguage");
    auto* restart = named<QPushButton>(window, "settingsRestart");
    language->setCurrentIndex(language->findData("de"));
    QVERIFY(!restart->isVisible());
    language->setCurrentIndex(language->findData("el"));
    QVERIFY(restart->isVisible());
    QVERIFY(!window.restarted());
    restart->click();
    QTRY_VERIFY(!window.isVisible());
    QCOMPARE(window.restarted().value_or(QString()), folder_);
    QCOMPARE(readSettings().language, QStringLiteral("el"));
    QLocale::setDefault(before);
  }

  void whatIsInTheCatalogueHasACopyOnceItIsOpen() {
    MainWindow window(jobs_);
    activate(window);
    window.openProject(folder_);
    QVERIFY(window.session() != nullptr);
    QTRY_VERIFY(!window.session()->project().backups().empty());
  }

  void whatStandsInAFieldIsSavedWhenTheWindowCloses() {
    store::SherdRow row;
    {
      auto project = upkeep::Project::open(folder_.toStdString());
      row = *sherds::Sherds(project->catalogue()).add({}, {});
    }
    {
      MainWindow window(jobs_);
      activate(window);
      window.openProject(folder_);
      for (int i = 0; i < 9 && !named<QTableView>(window, "sherds")->isVisible(); ++i)
        window.showScreen(i);
      auto* table = named<QTableView>(window, "sherds");
      QTRY_COMPARE(table->model()->rowCount(), 1);
      QTest::mouseClick(table->viewport(), Qt::LeftButton, {},
                        table->visualRect(table->model()->index(0, 0)).center());
      auto* ware = named<QLineEdit>(window, "field_ware");
      QTRY_VERIFY(ware->isEnabled());
      ware->setFocus();
      QTest::keyClicks(ware, "red slip");
      window.close();  // no Return, no Tab
    }
    const auto project = upkeep::Project::open(folder_.toStdString());
    QCOMPARE(sherds::Sherds(project->catalogue()).get(row)->ware, std::string("red slip"));
  }

  void closingSaysOnceThatAnExportWouldBeLost() {
    {
      auto project = upkeep::Project::open(folder_.toStdString());
      QVERIFY(sherds::Sherds(project->catalogue()).add({}, {}).has_value());
    }
    MainWindow window(jobs_);
    activate(window);
    window.openProject(folder_);
    window.showScreen(5);
    auto* target = named<QLineEdit>(window, "target");
    target->selectAll();
    QTest::keyClicks(target, home_->path(QStringLiteral("out")));
    auto* start = named<QPushButton>(window, "start");
    QTRY_VERIFY(start->isEnabled());
    QTRY_VERIFY(named<QLabel>(window, "size")->text().contains("sherd"));
    window.showScreen(0);
    start->click();
    QVERIFY(!window.close());
    QVERIFY(start->isVisible());  // one sees what is meant
    QVERIFY(window.close());
    QVERIFY(window.session() == nullptr);
  }

  void aProjectThatStillLeavesStaysLockedWhenAnotherIsClosed() {
    {
      auto project = upkeep::Project::open(folder_.toStdString());
      records::BatchRecord batch;
      batch.state = records::BatchState::Queued;
      QVERIFY(catalogue::Batches(project->catalogue()).add(batch, {}).has_value());
    }
    const QString other = home_->path(QStringLiteral("Ostraka/p2"));
    records::ProjectRecord record;
    record.code = "P2";
    record.title = "Another";
    QVERIFY(upkeep::Project::create(other.toStdString(), record).has_value());
    const auto computing = std::make_shared<std::atomic<bool>>(false);
    const auto may_end = std::make_shared<std::atomic<bool>>(false);
    const auto at_the_end = qScopeGuard([may_end] { *may_end = true; });
    MainWindow window(jobs_);
    window.queue()->computation()->setWork([=](const intake::ComputeOptions&, Progress&,
                                               std::stop_token) -> Result<intake::BatchFigures> {
      *computing = true;
      while (!*may_end) std::this_thread::yield();  // a stage that ends its work
      return Error::cancelled();
    });
    activate(window);
    window.openProject(folder_);
    QTRY_VERIFY(computing->load());
    window.closeProject();
    window.openProject(other);
    QVERIFY(window.session() != nullptr);
    window.closeProject();
    QVERIFY(window.queue()->computation()->isLeaving());
    QVERIFY(ProjectLock::take(folder_) == nullptr);
    QVERIFY(ProjectLock::take(other) != nullptr);
    *may_end = true;
    QTRY_VERIFY(!window.queue()->computation()->isLeaving());
    QVERIFY(ProjectLock::take(folder_) != nullptr);
  }

  void leavingAProjectThatIsProcessedAsksOnce() {
    MainWindow window(jobs_);
    activate(window);
    window.queue()->computation()->setWork(
        [](const intake::ComputeOptions&, Progress&,
           std::stop_token stop) -> Result<intake::BatchFigures> {
          while (!stop.stop_requested()) std::this_thread::yield();
          return Error::cancelled();
        });
    window.openProject(folder_);
    records::BatchRecord batch;
    batch.state = records::BatchState::Queued;
    QVERIFY(catalogue::Batches(window.session()->project().catalogue()).add(batch, {}).has_value());
    window.session()->tellBatchChanged(QStringLiteral("B0001"));
    QTRY_VERIFY(window.queue()->computation()->isBusy());
    auto* leave = named<QAction>(window, "closeProject");
    leave->trigger();
    QVERIFY(window.session() != nullptr);
    QVERIFY2(named<QLabel>(window, "footerSaid")->text().contains("Leaving the project stops it"),
             qPrintable(named<QLabel>(window, "footerSaid")->text()));
    window.showScreen(0);
    leave->trigger();
    QVERIFY2(window.session() != nullptr, "who went on working is asked anew");
    leave->trigger();
    QVERIFY(window.session() == nullptr);
    QTRY_VERIFY(!window.queue()->computation()->isLeaving());
  }

  void theChosenProjectIsOpenedByOneButtonOrByEnter() {
    MainWindow window(jobs_);
    activate(window);
    QVERIFY(!named<QPushButton>(window, "openChosen")->isVisible());
    for (const bool by_key : {false, true}) {
      window.openProject(folder_);
      window.closeProject();
      if (by_key)
        QTest::keyClick(recent(window), Qt::Key_Return);
      else
        QTest::mouseClick(named<QPushButton>(window, "openChosen"), Qt::LeftButton);
      QTRY_VERIFY(window.session() != nullptr);
    }
  }

  void openingAProjectSaysWhichOfItsFilesWereChanged() {
    {
      auto project = upkeep::Project::open(folder_.toStdString());
      QVERIFY(project.has_value());
      records::FileRecord file;
      file.path = "models/B0001/a/model.ply";
      file.sha256 = sha256("as it was entered");
      file.media_type = "application/octet-stream";
      file.role = "model";
      QVERIFY(catalogue::Files(project->catalogue()).save(file, {}).has_value());
      QVERIFY(writeFileAtomically(project->folder() / file.path, "one bit another").has_value());
    }
    MainWindow window(jobs_);
    activate(window);
    window.openProject(folder_);
    QTRY_VERIFY(named<QLabel>(window, "footerSaid")
                    ->text()
                    .contains(QStringLiteral("models/B0001/a/model.ply")));
  }

  void aDamagedCatalogueIsRepairedByOneButtonAndOpened() {
    const QString file = folder_ + QStringLiteral("/catalogue.sqlite");
    auto bytes = readFile(file.toStdString());
    QVERIFY(bytes.has_value());
    (*bytes)[5 * 4096 + 100] = static_cast<char>((*bytes)[5 * 4096 + 100] ^ 4);
    QVERIFY(writeFileAtomically(file.toStdString(), *bytes).has_value());
    MainWindow window(jobs_);
    activate(window);
    window.openProject(folder_);  // the page is not among those that are read at once
    QTRY_VERIFY(window.session() == nullptr);
    auto* message = named<MessagePanel>(window, "startMessage");
    QCOMPARE(message->act()->text(), QStringLiteral("Repair the catalogue"));
    QTest::mouseClick(message->act(), Qt::LeftButton);
    QTRY_COMPARE(message->headline(), QStringLiteral("The catalogue is repaired."));
    QVERIFY2(message->words().contains("Everything in it is as it was."),
             qPrintable(message->words()));
    QVERIFY2(message->words().contains("catalogue-damaged"), qPrintable(message->words()));
    QCOMPARE(message->act()->text(), QStringLiteral("Open the project"));
    QTest::mouseClick(message->act(), Qt::LeftButton);
    QVERIFY(window.session() != nullptr);
    QVERIFY(window.windowTitle().startsWith("Aragats 2026"));
  }

  void anArchiveIsRestoredByOneButtonAndOpened() {
    QuietProgress quiet;
    const QString archived = home_->path(QStringLiteral("p1-archive"));
    {
      const auto project = upkeep::Project::open(folder_.toStdString());
      QVERIFY(archive::archiveProject(*project, {archived.toStdString()}, quiet, {}).has_value());
    }
    MainWindow window(jobs_);
    activate(window);
    window.openProject(archived);
    QVERIFY(window.session() == nullptr);
    auto* message = named<MessagePanel>(window, "startMessage");
    QCOMPARE(message->act()->text(), QStringLiteral("Restore…"));
    QTest::mouseClick(message->act(), Qt::LeftButton);
    auto* dialog = named<QFileDialog>(window, "restoreTo");
    dialog->close();
    emit dialog->fileSelected(home_->path(QStringLiteral("Ostraka")));  // p1 is in it
    QTRY_VERIFY(window.session() != nullptr);
    QCOMPARE(QString::fromStdString(window.session()->folder().string()),
             home_->path(QStringLiteral("Ostraka/p1-2")));
  }

  void aCatalogueThatCannotBeRepairedSaysWhyAndStaysAsItIs() {
    const QString file = folder_ + QStringLiteral("/catalogue.sqlite");
    QVERIFY(QFile::resize(file, 0));  // and no backup is there
    MainWindow window(jobs_);
    activate(window);
    window.openProject(folder_);
    auto* message = named<MessagePanel>(window, "startMessage");
    QTest::mouseClick(message->act(), Qt::LeftButton);
    QTRY_COMPARE(message->headline(), QStringLiteral("The catalogue could not be repaired."));
    QCOMPARE(message->act()->text(), QStringLiteral("OK"));
    QCOMPARE(QFileInfo(file).size(), 0);
  }

  void theLogIsShownFromEveryPage() {
    MainWindow window(jobs_);
    activate(window);
    window.openProject(folder_);
    window.showScreen(0);
    auto* text = named<QWidget>(window, "queueLogText");
    QVERIFY(!text->isVisible());
    named<QAction>(window, "queueLog")->trigger();
    QVERIFY(named<QWidget>(window, "queue")->isVisible());
    QVERIFY(!text->isHidden());
    window.showScreen(0);
    QVERIFY2(!named<QAction>(window, "queueLog")->isChecked(), "no log is there");
    window.showScreen(1);
    QVERIFY(named<QAction>(window, "queueLog")->isChecked());
  }

  void undoNamesWhatItUndoesAndNothingElse() {
    MainWindow window(jobs_);
    activate(window);
    window.openProject(folder_);
    auto* undo = named<QAction>(window, "undo");
    QVERIFY(!undo->isEnabled());
    QCOMPARE(undo->text(), QStringLiteral("Undo"));
    window.session()->undo().push(new QUndoCommand(QStringLiteral("name it")));
    QVERIFY(undo->isEnabled());
    QCOMPARE(undo->text(), QStringLiteral("Undo: name it"));
    undo->trigger();
    QVERIFY(named<QAction>(window, "redo")->isEnabled());
    QCOMPARE(undo->text(), QStringLiteral("Undo"));
  }

 private:
  static QListWidget* recent(QWidget& window) {
    return named<QListWidget>(window, "recentProjects");
  }
  std::unique_ptr<Home> home_;
  QString folder_;
  ThreadedJobRunner jobs_;
};

OSTRAKA_UI_TEST(MainWindowTest)
#include "main_window_test.moc"
