// What a person with two folders of a telephone's photographs does first: to models in the window.
// Each click is a click on a button in sight; nothing is typed.
#include <QDesktopServices>
#include <QDialogButtonBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QDropEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QMenu>
#include <QMimeData>
#include <QPushButton>
#include <QTableView>
#include <QUrl>
#include <atomic>
#include <chrono>

#include "catalogue/batches.h"
#include "catalogue/settings.h"
#include "person.h"
#include "records/sherd.h"
#include "sherds/sherds.h"
#include "tests/ui/program.h"
#include "ui/capture/capture_screen.h"
#include "ui/frame/project_session.h"
#include "ui/frame/screen.h"
#include "ui/import/print_sheet_button.h"
#include "ui/jobs/job.h"
#include "ui/look/look.h"
#include "ui/main/main_window.h"
#include "ui/main/start_screen.h"
#include "ui/queue/batch_computation.h"
#include "ui/queue/batch_queue.h"
#include "ui/queue/queue_screen.h"
#include "ui/viewport/sherd_view.h"
#include "ui/widgets/message_panel.h"
#include "upkeep/project.h"
#include "virtualrig/batch_files.h"

using namespace ostraka;
using namespace ostraka::ui;

class FirstTrialTest : public QObject {
  Q_OBJECT

 public:
  static void initMain() { prepareOpenGl(); }

 public slots:
  void take(const QUrl& url) { opened_ = url.toLocalFile(); }

 private slots:
  void initTestCase() {
    QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    applyLook(*qApp, Theme::Light, 100);
  }
  void init() {
    home_ = std::make_unique<Home>();
    jobs_ = std::make_unique<ThreadedJobRunner>();
    window_ = std::make_unique<MainWindow>(*jobs_);
    window_->queue()->computation()->setWork(
        [this](const intake::ComputeOptions& options, Progress&, std::stop_token stop) {
          while (!computed_ && !stop.stop_requested()) QThread::msleep(10);
          return twoSherds(options);
        });
    computed_ = false;
    clicks_ = 0;
    activate(*window_);
  }
  void cleanup() {
    computed_ = true;
    window_.reset();
    jobs_.reset();
  }

  void fromTheFolderOfBothSidesToModelsInThreeClicks() {
    photographs("Trench 3/fronts", 4);
    photographs("Trench 3/backs", 3);
    QVERIFY(virtualrig::writePlateAndBoard(path("Trench 3")).has_value());
    auto* begin = named<QPushButton>(*window_, "startPhotographs");
    QVERIFY(begin->property("primary").toBool());
    QTRY_VERIFY(begin->hasFocus());
    click(begin);
    auto* dialog = window_->findChild<QFileDialog*>();
    QVERIFY(dialog != nullptr);
    dialog->selectFile(home_->path("Trench 3"));
    click(dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Open));
    importThem();
    QVERIFY2(clicks_ <= 3, qPrintable(QString::number(clicks_)));
    const upkeep::Project& project = window_->session()->project();
    QCOMPARE(QString::fromStdString(project.folder().string()), home_->path("Ostraka/Trench 3"));
    const auto row = catalogue::Settings(project.catalogue()).project();
    QCOMPARE(row->title, std::string("Trench 3"));
    QCOMPARE(row->code, std::string("TRENCH3"));
  }

  void twoDroppedFoldersNeedOneClick() {
    photographs("fronts", 4);
    photographs("backs", 3);
    QVERIFY(virtualrig::writePlateAndBoard(path("")).has_value());
    drop({home_->path("fronts"), home_->path("backs")});
    importThem();
    QCOMPARE(clicks_, 1);
  }

  void whoLeftTheQueueIsNotTakenToTheModels() {
    photographs("fronts", 4);
    photographs("backs", 3);
    QVERIFY(virtualrig::writePlateAndBoard(path("")).has_value());
    drop({home_->path("fronts"), home_->path("backs")});
    click(shown("importStart"));
    QTRY_VERIFY(screen("queue")->isVisible());
    window_->showScreenNamed("map", {});
    window_->showScreenNamed("queue", "B0001");
    computed_ = true;
    QTRY_VERIFY(window_->queue()->row(0).figures.has_value());
    QTest::qWait(50);  // for what is queued
    QVERIFY(screen("queue")->isVisible());
  }

  void whoEditsMasksIsNotTakenToTheModels() {
    photographs("fronts", 4);
    photographs("backs", 3);
    QVERIFY(virtualrig::writePlateAndBoard(path("")).has_value());
    drop({home_->path("fronts"), home_->path("backs")});
    click(shown("importStart"));
    QTRY_VERIFY(screen("queue")->isVisible());
    auto* masks = window_->findChild<QAction*>("queueMasks");
    masks->setEnabled(true);  // as of a batch that is there from before
    masks->trigger();
    const auto* queue = static_cast<const QueueScreen*>(screen("queue"));
    QVERIFY(queue->masksPage()->isVisible());
    computed_ = true;
    QTRY_VERIFY(window_->queue()->row(0).figures.has_value());
    QTest::qWait(50);  // for what is queued
    QVERIFY(queue->masksPage()->isVisible());
  }

  void aSecondBatchIsTheOneThatTheQueueShows() {
    photographs("fronts", 4);
    photographs("backs", 3);
    QVERIFY(virtualrig::writePlateAndBoard(path("")).has_value());
    drop({home_->path("fronts"), home_->path("backs")});
    importThem();
    computed_ = false;
    photographs("Other/fronts", 4);
    photographs("Other/backs", 3);
    QVERIFY(virtualrig::writePlateAndBoard(path("Other")).has_value());
    window_->showScreenNamed("capture", {});
    named<CaptureScreen>(*window_, "capture")
        ->importPhotographs({home_->path("Other/fronts"), home_->path("Other/backs")});
    click(shown("importStart"));
    QTRY_VERIFY(screen("queue")->isVisible());
    QCOMPARE(named<QListView>(*window_, "queueList")->currentIndex().data().toString(),
             QString("B0002"));
  }

  void aCancelledImportLeavesNoProjectUnlessSomebodyWorkedInIt() {
    photographs("fronts", 4);
    photographs("backs", 3);
    QVERIFY(virtualrig::writePlateAndBoard(path("")).has_value());
    const auto begin = [this] {
      drop({home_->path("fronts"), home_->path("backs")});
      QTRY_VERIFY(window_->session() != nullptr);
      QTRY_VERIFY(named<QPushButton>(*window_, "importLeave")->isVisible());
    };
    begin();
    const QString folder = QString::fromStdString(window_->session()->folder().string());
    QTest::mouseClick(named<QPushButton>(*window_, "importLeave"), Qt::LeftButton);
    auto* message = named<MessagePanel>(*window_, "startMessage");
    QTRY_VERIFY(message->isVisible());
    QVERIFY(window_->session() == nullptr);
    QVERIFY(!QDir(folder).exists());
    QVERIFY(QFileInfo::exists(home_->path("fronts/IMG_0.jpg")));
    begin();
    workInIt();
    QTest::mouseClick(named<QPushButton>(*window_, "importLeave"), Qt::LeftButton);
    QTest::qWait(50);  // for what is queued
    QVERIFY(window_->session() != nullptr);
    QVERIFY(QDir(folder).exists());
  }

  void aFolderIsDroppedOntoThePageNotIntoAField() {
    for (const char* name : {"newName", "newSite", "newFolder", "newNumbering"})
      QVERIFY(!named<QLineEdit>(*window_, name)->acceptDrops());
  }

  void aTypedMarkerSizeIsProposedBeforeASheetThatWasPrintedOnce() {
    photographs("fronts", 4);
    photographs("backs", 3);
    drop({home_->path("fronts"), home_->path("backs")});
    auto* sheet = named<QLabel>(*window_, "importSheet");
    QTRY_VERIFY(sheet->isVisible());
    named<QDoubleSpinBox>(*window_, "importMarker")->setValue(18);
    workInIt();
    QTest::mouseClick(named<QPushButton>(*window_, "importLeave"), Qt::LeftButton);
    print("startPrintSheet");
    named<CaptureScreen>(*window_, "capture")
        ->importPhotographs({home_->path("fronts"), home_->path("backs")});
    QTRY_VERIFY2(sheet->isVisible() && sheet->text().contains("last import"),
                 qPrintable(sheet->text()));
  }

  void whatHoldsNoPhotographsIsSaidAndLeavesNoProject_data() {
    QTest::addColumn<QString>("made");
    QTest::newRow("an empty folder") << "nothing";
    QTest::newRow("an empty batch") << "nothing/front";
  }
  void whatHoldsNoPhotographsIsSaidAndLeavesNoProject() {
    QFETCH(QString, made);
    QVERIFY(QDir(home_->path("")).mkpath(made));
    drop({home_->path("nothing")});
    auto* message = named<MessagePanel>(*window_, "startMessage");
    QTRY_VERIFY(message->isVisible());
    QVERIFY(window_->session() == nullptr);
    QVERIFY(!QDir(home_->path("Ostraka")).exists());
  }

  void whoHasNoSheetPrintsOursAndTheImportProposesIt() {
    print("startPrintSheet");
    QCOMPARE(opened_, home_->path("Ostraka/sheets/A4/sheet.pdf"));
    QVERIFY(QFileInfo::exists(opened_));
    auto* message = named<MessagePanel>(*window_, "startMessage");
    QTRY_VERIFY(message->isVisible());
    QVERIFY2(message->words().contains("100 %"), qPrintable(message->words()));
    photographs("fronts", 4);
    photographs("backs", 3);
    drop({home_->path("fronts"), home_->path("backs")});
    auto* sheet = named<QLabel>(*window_, "importSheet");
    QTRY_VERIFY2(sheet->isVisible() && sheet->text().contains("sheets/A4/plate.json"),
                 qPrintable(sheet->text()));
    QVERIFY(named<QPushButton>(*window_, "importPrintSheet")->isVisible());
    workInIt();
    // What a person cleared is not proposed again.
    QTest::mouseClick(named<QPushButton>(*window_, "importClearSheet"), Qt::LeftButton);
    QTest::mouseClick(named<QPushButton>(*window_, "importLeave"), Qt::LeftButton);
    window_->showScreenNamed("capture", {});
    named<CaptureScreen>(*window_, "capture")
        ->importPhotographs({home_->path("fronts"), home_->path("backs")});
    QTRY_VERIFY2(sheet->isVisible() && sheet->text().contains("no scale"),
                 qPrintable(sheet->text()));
    // Unless it is printed after that.
    print("importPrintSheet");
    QTest::mouseClick(named<QPushButton>(*window_, "importLeave"), Qt::LeftButton);
    named<CaptureScreen>(*window_, "capture")
        ->importPhotographs({home_->path("fronts"), home_->path("backs")});
    QTRY_VERIFY2(sheet->isVisible() && sheet->text().contains("sheets/A4/plate.json"),
                 qPrintable(sheet->text()));
  }

  void theSheetThatWasPrintedLastIsProposedAlsoWhenItWasThereAlready() {
    print("startPrintSheet");
    print("startPrintSheet", 1);
    const QString first = home_->path("Ostraka/sheets/A4");
    std::filesystem::last_write_time(
        first.toStdString(),
        std::filesystem::last_write_time(first.toStdString()) - std::chrono::hours(1));
    QVERIFY(QString::fromStdString(printedSheet().string()).contains("sheets/A3"));
    print("startPrintSheet");
    QVERIFY(QString::fromStdString(printedSheet().string()).contains("sheets/A4"));
  }

  void aDroppedProjectIsOpened() {
    records::ProjectRecord record;
    record.code = "ARM1";
    record.title = "Hill";
    QVERIFY(upkeep::Project::create(path("Hill"), record).has_value());
    drop({home_->path("Hill")});
    QTRY_VERIFY(window_->session() != nullptr);
    QCOMPARE(QString::fromStdString(window_->session()->folder().string()), home_->path("Hill"));
  }

 private:
  void print(const char* button, int size = 0) {
    QDesktopServices::setUrlHandler(QStringLiteral("file"), this, "take");
    named<QPushButton>(*window_, button)->menu()->actions().at(size)->trigger();
    QDesktopServices::unsetUrlHandler(QStringLiteral("file"));
  }

  std::filesystem::path path(const char* name) const {
    return home_->path(QString::fromLatin1(name)).toStdString();
  }

  void click(QPushButton* button) {
    QVERIFY(button != nullptr);
    QTRY_VERIFY(button->isVisible() && button->isEnabled());
    QTest::mouseClick(button, Qt::LeftButton);
    ++clicks_;
  }

  // The button of that name once it is there to be pressed.
  QPushButton* shown(const char* name) const {
    auto* button = named<QPushButton>(*window_, name);
    (void)QTest::qWaitFor([button] { return button->isVisible() && button->isEnabled(); }, 20000);
    return button;
  }

  const Screen* screen(const char* name) const {
    for (const Screen* each : window_->screens())
      if (each->iconName() == QLatin1String(name)) return each;
    return nullptr;
  }

  // What is shown of the photographs is right: the batch is in the queue, then its models.
  // So that the project that was made for an import stays when it is cancelled.
  void workInIt() {
    QVERIFY(catalogue::Settings(window_->session()->project().catalogue())
                .setValue("key", "value", {})
                .has_value());
  }
  void importThem() {
    click(shown("importStart"));
    QTRY_VERIFY(screen("queue")->isVisible());
    QTRY_VERIFY(window_->queue()->computation()->isBusy());
    computed_ = true;
    QTRY_VERIFY(screen("catalogue")->isVisible());
    const auto* table = named<QTableView>(*window_, "sherds");
    QTRY_COMPARE(table->model()->rowCount(), 2);
    QTRY_VERIFY(table->selectionModel()->hasSelection());
  }

  void drop(const QStringList& paths) {
    QMimeData data;
    QList<QUrl> urls;
    for (const QString& each : paths) urls << QUrl::fromLocalFile(each);
    data.setUrls(urls);
    auto* start = window_->findChild<StartScreen*>();
    QVERIFY(start->acceptDrops());
    QDragEnterEvent enter({5, 5}, Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(start, &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent event(QPointF(5, 5), Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(start, &event);
  }

  void photographs(const QString& folder, int count) {
    QVERIFY(QDir().mkpath(home_->path(folder)));
    QImage image(800, 600, QImage::Format_RGB32);
    for (int i = 0; i < count; ++i) {
      image.fill(QColor::fromHsv(i * 40, 10 * static_cast<int>(folder.size()), 200));
      QVERIFY(image.save(home_->path(QString("%1/IMG_%2.jpg").arg(folder).arg(i))));
    }
  }

  static Result<intake::BatchFigures> twoSherds(const intake::ComputeOptions& options) {
    auto project = upkeep::Project::open(options.project);
    if (!project) return project.error();
    const auto batch = catalogue::Batches(project->catalogue()).byNumber(options.number);
    if (!batch) return batch.error();
    for (int i = 0; i < 2; ++i) {
      records::SherdRecord sherd;
      sherd.batch = batch->row;
      if (const auto added = sherds::Sherds(project->catalogue()).add(sherd, {}); !added)
        return added.error();
    }
    const auto set = catalogue::Batches(project->catalogue())
                         .setState(batch->row, records::BatchState::Done, {});
    if (!set) return set.error();
    intake::BatchFigures figures;
    figures.sherds = figures.sure = 2;
    return figures;
  }

  std::unique_ptr<Home> home_;
  std::unique_ptr<JobRunner> jobs_;
  std::unique_ptr<MainWindow> window_;
  std::atomic<bool> computed_ = false;
  int clicks_ = 0;
  QString opened_;  // outside of the window
};

OSTRAKA_UI_TEST(FirstTrialTest)
#include "first_trial_test.moc"
