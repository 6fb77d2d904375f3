// The queue's screen by keys.
#include "ui/queue/queue_screen.h"

#include <linux/capability.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <QDesktopServices>
#include <QInputDialog>
#include <QListView>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalSpy>
#include <QToolButton>
#include <QUrl>
#include <QtTest>
#include <atomic>
#include <thread>

#include "../named.h"
#include "../project_in.h"
#include "catalogue/batches.h"
#include "catalogue/queue_pause.h"
#include "files/files.h"
#include "intake/side_photographs.h"
#include "paper/report_page.h"
#include "tests/ui/program.h"
#include "ui/frame/project_session.h"
#include "ui/import/batch_importer.h"
#include "ui/queue/batch_computation.h"
#include "ui/queue/batch_queue.h"
#include "ui/queue/queue_switches.h"
#include "ui/widgets/message_panel.h"
#include "upkeep/project.h"

using namespace ostraka;
using namespace ostraka::ui;

namespace {

// While it lives this thread is refused what its permissions refuse, even if it is root's.
class WithoutPrivileges {
 public:
  WithoutPrivileges() {
    ::syscall(SYS_capget, &header_, before_);
    __user_cap_data_struct none[_LINUX_CAPABILITY_U32S_3]{};
    for (int i = 0; i < _LINUX_CAPABILITY_U32S_3; ++i) none[i].permitted = before_[i].permitted;
    ::syscall(SYS_capset, &header_, none);
  }
  ~WithoutPrivileges() { ::syscall(SYS_capset, &header_, before_); }
  WithoutPrivileges(const WithoutPrivileges&) = delete;
  WithoutPrivileges& operator=(const WithoutPrivileges&) = delete;

 private:
  __user_cap_header_struct header_{_LINUX_CAPABILITY_VERSION_3, 0};
  __user_cap_data_struct before_[_LINUX_CAPABILITY_U32S_3]{};
};

}  // namespace

class QueueScreenTest : public QObject {
  Q_OBJECT

 public slots:
  void take(const QUrl& url) { opened_ = url; }

 private slots:
  void init() {
    folder_ = std::make_unique<QTemporaryDir>();
    jobs_ = std::make_unique<ThreadedJobRunner>();
    const std::filesystem::path folder = folder_->filePath("p").toStdString();
    session_ = std::make_unique<ProjectSession>(projectIn(folder), folder, *jobs_);
    queue_ = std::make_unique<BatchQueue>();
    queue_->computation()->setClock(
        [this] { return QDateTime::currentDateTime().addSecs(3600 * hours_); });
    begun_ = hours_ = 0;
    refuse_ = false;
    queue_->computation()->setWork([this](const intake::ComputeOptions&, Progress& progress,
                                          std::stop_token stop) -> Result<intake::BatchFigures> {
      ++begun_;
      progress.note(NoteLevel::Info, "rig: camera B 0.31 px over 412 corners");
      if (refuse_) return Error{ErrorCode::CannotWrite, "The disk is full.", "results"};
      while (!stop.stop_requested()) {
        progress.report(1, 3);
        std::this_thread::yield();
      }
      return Error::cancelled();
    });
    screen_ = std::make_unique<QueueScreen>(queue_.get());
    screen_->resize(1000, 600);
    activate(*screen_);
    screen_->setInFront(true);
  }
  void cleanup() {
    screen_->closeProject();
    screen_.reset();
    queue_.reset();
    jobs_.reset();
    session_.reset();
  }

  void aBatchWithThePhotographsOfAnotherIsKeptByOneButton() {
    addBatch(records::BatchState::Done);
    addBatch();
    for (const char* number : {"B0001", "B0002"})
      QVERIFY(writeFileAtomically(session_->folder() / "batches" / number / "front/IMG_1.jpg",
                                  "the same")
                  .has_value());
    queue_->computation()->setWork([this](const intake::ComputeOptions& options, Progress&,
                                          std::stop_token stop) -> Result<intake::BatchFigures> {
      const Result<catalogue::Catalogue> rows = upkeep::Project::connect(options.project);
      const auto batch = catalogue::Batches(*rows).byNumber(options.number);
      const Result<void> own = intake::checkNotShared(*rows, options.project, *batch, stop);
      if (!own) return own.error();
      ++begun_;
      while (!stop.stop_requested()) std::this_thread::yield();
      return Error::cancelled();
    });
    screen_->openProject(*session_);
    auto* action = screen_->findChild<QAction*>("queueKeepBoth");
    screen_->showItem("B0001");
    QVERIFY(!action->isVisible());
    screen_->showItem("B0002");
    QTRY_VERIFY(action->isVisible() && action->isEnabled());
    QVERIFY(queue_->row(queue_->rowOf("B0002")).failure.contains("B0001"));
    action->trigger();
    QTRY_COMPARE(begun_.load(), 1);
    QVERIFY(!action->isVisible());
  }

  void anEmptyQueueSaysWhatToDoFirst() {
    screen_->openProject(*session_);
    QSignalSpy wanted(screen_.get(), &Screen::wantsScreen);
    QTest::mouseClick(child<QPushButton>("queueToCapture"), Qt::LeftButton);
    QCOMPARE(wanted.count(), 1);
    QCOMPARE(wanted[0][0].toString(), QStringLiteral("capture"));
  }

  void aRestoredQueueStandsStillSaysWhyAndGoesOnByItsButton() {
    addBatch();
    QVERIFY(catalogue::pauseRestoredQueue(session_->project().catalogue()).has_value());
    screen_->openProject(*session_);
    auto* message = child<MessagePanel>("queueMessage");
    QVERIFY(message->isVisible());
    QVERIFY2(message->headline().contains("restored"), qPrintable(message->headline()));
    QCOMPARE(queue_->workWords(), QStringLiteral("Paused; 1 batch(es) queued."));
    QCOMPARE(begun_.load(), 0);
    QTest::mouseClick(message->act(), Qt::LeftButton);
    QTRY_COMPARE(begun_.load(), 1);
    QVERIFY(!message->isVisible());
    QVERIFY(!queue_->switches()->isPaused());
  }

  void whatIsCancelledSaysSoUntilItsWorkHasStopped() {
    addBatch();
    std::atomic<bool> noticed = false;
    queue_->computation()->setWork([&](const intake::ComputeOptions& options, Progress&,
                                       std::stop_token) -> Result<intake::BatchFigures> {
      options.estimated(90);
      ++begun_;
      while (!noticed) std::this_thread::yield();
      return Error::cancelled();
    });
    screen_->openProject(*session_);
    QTRY_COMPARE(begun_.load(), 1);
    QTRY_VERIFY2(queue_->workWords().endsWith("about 2 min left"), qPrintable(queue_->workWords()));
    auto* cancel = screen_->findChild<QAction*>("queueCancel");
    cancel->trigger();
    QVERIFY(!cancel->isEnabled());
    QCOMPARE(stateWords(queue_->row(0)), QStringLiteral("Stopping…"));
    QCOMPARE(queue_->workWords(), QStringLiteral("B0001: stopping…"));
    noticed = true;
    QTRY_COMPARE(queue_->row(0).state, QueueState::Failed);
    QCOMPARE(stateWords(queue_->row(0)), QStringLiteral("Stopped"));
  }

  void anImportIsShownBeforeItsBatchIs() {
    BatchImporter importer;
    screen_->showImportsOf(&importer);
    screen_->openProject(*session_);
    emit importer.started(QStringLiteral("Import of fronts"));
    QCOMPARE(child<QPushButton>("queueToCapture")->text(), QStringLiteral("Show the import"));
    emit importer.progressed(0.8);
    auto* bar = child<QProgressBar>("importProgress");
    QVERIFY(bar->isVisible());
    QCOMPARE(bar->value(), 80);
    emit importer.ended();
    QVERIFY(!bar->isVisible());
    QCOMPARE(child<QPushButton>("queueToCapture")->text(), QStringLiteral("Capture a batch"));
  }

  void spacePausesAndGoesOnDeleteStops() {
    addBatch();
    screen_->openProject(*session_);
    QTRY_COMPARE(begun_.load(), 1);
    QTRY_COMPARE(queue_->row(0).state, QueueState::Busy);
    QTest::keyClick(child<QListView>("queueList"), Qt::Key_Space);
    QCOMPARE(queue_->row(0).state, QueueState::Paused);
    QTest::keyClick(child<QListView>("queueList"), Qt::Key_Space);
    QCOMPARE(queue_->row(0).state, QueueState::Busy);
    QTest::keyClick(child<QListView>("queueList"), Qt::Key_Delete);
    QTRY_COMPARE(queue_->row(0).state, QueueState::Failed);
    QTest::keyClick(child<QListView>("queueList"), Qt::Key_Delete);  // once more: not wanted at all
    QVERIFY(queue_->row(0).aside);
    QVERIFY(!child<QWidget>("queueCancelButton")->isEnabled());
    QTest::keyClick(child<QListView>("queueList"), Qt::Key_R);
    QTRY_COMPARE(begun_.load(), 2);
    QCOMPARE(child<QWidget>("queueCancelButton")->accessibleName(), QString("Cancel, key Del"));
  }

  void whatIsAskedAboutIsWhatIsStopped() {
    addBatch();
    screen_->openProject(*session_);
    QTRY_COMPARE(begun_.load(), 1);
    addBatch();
    session_->tellBatchChanged("B0002");
    QCOMPARE(queue_->rowCount(), 2);
    screen_->showItem("B0001");
    hours_ = 2;
    QTest::keyClick(child<QListView>("queueList"), Qt::Key_Delete);
    auto* message = child<MessagePanel>("queueMessage");
    QVERIFY(message->isVisible());
    QCOMPARE(begun_.load(), 1);
    screen_->showItem("B0002");
    QTest::mouseClick(child<QPushButton>("messageAct"), Qt::LeftButton);
    QTRY_COMPARE(queue_->row(queue_->rowOf("B0001")).state, QueueState::Failed);
    QTRY_COMPARE(begun_.load(), 2);
    QCOMPARE(queue_->row(queue_->rowOf("B0002")).state, QueueState::Busy);
  }

  void theLogIsOneKeyAway() {
    addBatch();
    screen_->openProject(*session_);
    QTRY_VERIFY(child<QPlainTextEdit>("queueLogText")->toPlainText().contains("412 corners"));
    QVERIFY(!child<QPlainTextEdit>("queueLogText")->isVisible());
    QTest::keyClick(child<QListView>("queueList"), Qt::Key_L);
    QVERIFY(child<QPlainTextEdit>("queueLogText")->isVisible());
  }

  void aBumpedCameraIsCalibratedAwayByOneKey() {
    queue_->computation()->setWork([this](const intake::ComputeOptions& options, Progress&,
                                          std::stop_token) -> Result<intake::BatchFigures> {
      ++begun_;
      auto project = upkeep::Project::open(options.project);
      const auto batch = catalogue::Batches(project->catalogue()).byNumber(options.number);
      (void)catalogue::Batches(project->catalogue())
          .setState(batch->row, records::BatchState::Done, {});
      intake::BatchFigures figures;
      figures.sherds = figures.sure = 3;
      if (begun_ == 1) figures.moved = {{1, 0.83, 2.5, 0.01}};
      return figures;
    });
    addBatch();
    screen_->openProject(*session_);
    auto* button = child<QWidget>("queueCalibrateButton");
    QTRY_VERIFY(button->isVisible());
    QSignalSpy wanted(screen_.get(), &Screen::wantsScreen);
    QTest::keyClick(child<QListView>("queueList"), Qt::Key_C);
    QCOMPARE(wanted.count(), 1);
    QCOMPARE(wanted[0][0].toString(), QStringLiteral("capture"));
    QCOMPARE(wanted[0][1].toString(), QStringLiteral("calibrate:B0001"));
    QTest::keyClick(child<QListView>("queueList"), Qt::Key_R);
    QTRY_COMPARE(begun_.load(), 2);
    QTRY_VERIFY(!button->isVisible());  // the rig fits: nothing is offered
  }

  void aReportThatMayRunScriptsIsToldOfAndOneOfOursOpens() {
    addBatch(records::BatchState::Done);
    const auto file = session_->folder() / "results/B0001/report.html";
    QVERIFY(writeFileAtomically(file, "<html><script>alert(1)</script></html>").has_value());
    screen_->openProject(*session_);
    QSignalSpy said(screen_.get(), &Screen::said);
    QDesktopServices::setUrlHandler(QStringLiteral("file"), this, "take");
    QTest::keyClick(child<QListView>("queueList"), Qt::Key_O);
    QCOMPARE(said.count(), 1);
    QVERIFY2(said[0][0].toString().contains("not opened"), qPrintable(said[0][0].toString()));
    QVERIFY(opened_.isEmpty());
    const std::string ours = std::string(kReportHead) + "<title>B0001</title></html>";
    QVERIFY(writeFileAtomically(file, ours).has_value());
    QTest::keyClick(child<QListView>("queueList"), Qt::Key_O);
    QDesktopServices::unsetUrlHandler(QStringLiteral("file"));
    QCOMPARE(said.count(), 2);
    QVERIFY2(said[1][0].toString().startsWith("Opening "), qPrintable(said[1][0].toString()));
    QCOMPARE(opened_.toLocalFile(), QString::fromStdString(file.string()));
  }

  void masksAreOfferedOnlyWhereThereAreAny() {
    addBatch(records::BatchState::Done);
    screen_->openProject(*session_);
    const auto* masks = child<QToolButton>("queueMasksButton");
    QVERIFY(!masks->isEnabled());
    QVERIFY2(masks->toolTip().contains("no masks"), qPrintable(masks->toolTip()));
    std::filesystem::create_directories(session_->folder() / "results/B0001/work/masks_front");
    session_->tellBatchChanged("B0001");
    QVERIFY(masks->isEnabled());
    QVERIFY2(!masks->toolTip().contains("no masks"), qPrintable(masks->toolTip()));
  }

  void aReadOnlyProjectOffersNothingThatChangesIt() {
    addBatch(records::BatchState::Done);
    addBatch();
    const std::filesystem::path folder = session_->folder();
    std::filesystem::create_directories(folder / "results/B0001/work/masks_front");
    session_.reset();
    ::chmod((folder / "catalogue.sqlite").c_str(), 0444);
    ::chmod(folder.c_str(), 0555);
    {
      const WithoutPrivileges refused;
      session_ = std::make_unique<ProjectSession>(projectIn(folder), folder, *jobs_);
    }
    ::chmod(folder.c_str(), 0755);
    QVERIFY(!session_->whyReadOnly().isEmpty());
    screen_->openProject(*session_);
    QCOMPARE(queue_->row(queue_->rowOf("B0002")).state, QueueState::Waiting);  // nor is it begun
    screen_->showItem("B0001");
    for (const char* name : {"queueAgainButton", "queueMasksButton", "queueDraftsButton"}) {
      const auto* button = child<QToolButton>(name);
      QVERIFY2(!button->isEnabled(), name);
      QVERIFY2(button->toolTip().contains("read-only"), qPrintable(button->toolTip()));
    }
    QVERIFY(child<QToolButton>("queueReviewButton")->isEnabled());  // to be looked at
    QVERIFY(child<QPushButton>("queueNext")->isEnabled());
  }

  void aFullDiskIsSaidWithAButtonThatGoesOn() {
    refuse_ = true;
    addBatch();
    screen_->openProject(*session_);
    auto* message = child<MessagePanel>("queueMessage");
    QTRY_VERIFY(message->isVisible());
    QVERIFY(message->words().contains("disk is full"));
    QCOMPARE(screen_->waiting(), 1);
    refuse_ = false;
    QTest::mouseClick(child<QPushButton>("messageAct"), Qt::LeftButton);
    QTRY_COMPARE(begun_.load(), 2);
    QVERIFY(!message->isVisible());
  }

  void theMarkerSideOfABatchByHandCanBeTypedAnew() {
    addBatch(records::BatchState::Done);
    const std::filesystem::path batch = session_->folder() / "batches" / "B0001";
    screen_->openProject(*session_);
    auto* action = screen_->findChild<QAction*>("queueMarkerSide");
    QVERIFY2(!action->isVisible(), "scans have no markers");
    QVERIFY(writeFileAtomically(batch / "front/IMG_1.jpg", "no photograph").has_value());
    session_->tellBatchChanged(QStringLiteral("B0001"));
    QTRY_VERIFY(action->isVisible() && action->isEnabled());
    QVERIFY(writeFileAtomically(batch / "plate.json",
                                R"({"dictionary":"DICT_4X4_100","markers":[{"id":3,"corners":)"
                                R"([[0,20,0],[20,20,0],[20,0,0],[0,0,0]]}]})")
                .has_value());
    action->trigger();
    auto* dialog = screen_->findChild<QInputDialog*>("markerSide");
    QVERIFY(dialog != nullptr && dialog->isVisible());
    QCOMPARE(dialog->doubleValue(), 20.0);
    QSignalSpy said(screen_.get(), &Screen::said);
    dialog->accept();
    QTRY_COMPARE(said.count(), 1);  // its photograph cannot be read: nothing is queued
    QCOMPARE(queue_->row(0).state, QueueState::Done);
    QVERIFY(writeFileAtomically(batch / "rig.json", "{}").has_value());
    session_->tellBatchChanged(QStringLiteral("B0001"));
    QTRY_VERIFY(!action->isVisible());  // its rig says how large it is
  }

 private:
  template <class T>
  T* child(const char* name) {
    return named<T>(*screen_, name);
  }
  void addBatch(records::BatchState state = records::BatchState::Queued) {
    records::BatchRecord record;
    record.state = state;
    QVERIFY(catalogue::Batches(session_->project().catalogue()).add(record, {}).has_value());
  }
  std::atomic<int> begun_ = 0;
  std::atomic<bool> refuse_ = false;
  int hours_ = 0;  ///< that the clock is ahead
  std::unique_ptr<QTemporaryDir> folder_;
  std::unique_ptr<JobRunner> jobs_;
  std::unique_ptr<ProjectSession> session_;
  std::unique_ptr<BatchQueue> queue_;
  std::unique_ptr<QueueScreen> screen_;
  QUrl opened_;
};

OSTRAKA_UI_TEST(QueueScreenTest)
#include "queue_screen_test.moc"
