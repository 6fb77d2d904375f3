// The queue without a display, with work that does nothing: its order, and that what is to be done
// outlives the window.
#include "ui/queue/batch_queue.h"

#include <QAbstractItemModelTester>
#include <QSignalSpy>
#include <QtTest>
#include <atomic>
#include <mutex>
#include <thread>

#include "catalogue/batches.h"
#include "catalogue/settings.h"
#include "queue_bench.h"
#include "records/records.h"
#include "store/database.h"
#include "tests/ui/program.h"

using namespace ostraka;
using namespace ostraka::ui;
using intake::BatchFigures, intake::ComputeOptions;
using Computed = Result<BatchFigures>;

class BatchQueueTest : public QObject {
  Q_OBJECT

 private slots:
  void init() { folder_ = std::make_unique<QTemporaryDir>(); }

  void whatNobodyWantsIsSetAsideAndComesBackByComputingIt() {
    InlineJobRunner jobs;
    Bench bench(folder(), jobs);
    bench.setWork([](const ComputeOptions&, Progress&, std::stop_token) -> Computed {
      return Error{ErrorCode::NotEnough, "No plate is seen.", {}};
    });
    const QString number = addBatch(bench.session, BatchState::Queued);
    bench.queue.setSession(&bench.session);
    QTRY_COMPARE(bench.queue.failed(), 1);
    bench.queue.setAside(number);
    QCOMPARE(bench.queue.failed(), 0);
    QCOMPARE(stateWords(bench.queue.row(0)), QStringLiteral("Set aside"));
    QVERIFY(bench.queue.row(0).failure.contains("photographs are kept"));
    const auto kept =
        catalogue::Settings(bench.session.project().catalogue()).value("queue.failure.B0001");
    QVERIFY2(!kept->empty() && !QString::fromStdString(*kept).contains("photographs"),
             "kept in the language of one day");
    BatchQueue after_a_start;
    after_a_start.setSession(&bench.session);
    QVERIFY(after_a_start.row(0).aside);
    QCOMPARE(after_a_start.failed(), 0);
    bench.queue.retry(number);
    QTRY_COMPARE(bench.queue.failed(), 1);
    QVERIFY(!bench.queue.row(0).aside);
    QCOMPARE(bench.queue.row(0).failure, QStringLiteral("No plate is seen."));
  }

  void whatWasSetAsideAtThePlateIsPhotographedOn() {
    InlineJobRunner jobs;
    Bench bench(folder(), jobs);
    const QString number = addBatch(bench.session, BatchState::Front);
    bench.queue.setSession(&bench.session);
    bench.queue.setAside(number);
    QCOMPARE(stateOf(bench.session, number), BatchState::Failed);
    QCOMPARE(bench.queue.failed(), 0);
    bench.queue.retry(number);
    QCOMPARE(stateOf(bench.session, number), BatchState::Front);
    QVERIFY(bench.computed.isEmpty());
  }

  void whatIsDoneIsNotSetAside() {
    InlineJobRunner jobs;
    Bench bench(folder(), jobs);
    const QString number = addBatch(bench.session, BatchState::Done);
    bench.queue.setSession(&bench.session);
    bench.queue.setAside(number);
    QCOMPARE(stateOf(bench.session, number), BatchState::Done);
  }

  void batchesAreComputedOldestFirstAndShownNewestFirst() {
    InlineJobRunner jobs;
    Bench bench(folder(), jobs);
    const QString first = addBatch(bench.session, BatchState::Queued);
    const QString second = addBatch(bench.session, BatchState::Queued);
    const QString open = addBatch(bench.session, BatchState::Front);
    const QAbstractItemModelTester tester(&bench.queue,
                                          QAbstractItemModelTester::FailureReportingMode::QtTest);
    bench.queue.setSession(&bench.session);
    QTRY_COMPARE(bench.computed, (QStringList{first, second}));
    QTRY_VERIFY(!bench.queue.computation()->isBusy());
    QCOMPARE(bench.queue.row(0).number, open);
    QCOMPARE(bench.queue.row(0).state, QueueState::Shooting);
    QCOMPARE(bench.queue.row(2).number, first);
    QCOMPARE(bench.queue.row(2).state, QueueState::Review);
    QVERIFY(bench.queue.row(2).figures.has_value());
    QCOMPARE(bench.queue.row(2).figures->ask, 1);
  }

  void aBatchThatArrivesLaterIsComputedToo() {
    InlineJobRunner jobs;
    Bench bench(folder(), jobs);
    bench.queue.setSession(&bench.session);
    const QString number = addBatch(bench.session, BatchState::Queued);
    bench.session.tellBatchChanged(number);
    QTRY_COMPARE(bench.computed, QStringList{number});
  }

  void oneBatchThatChangesIsOneRow() {
    InlineJobRunner jobs;
    Bench bench(folder(), jobs);
    for (int i = 0; i < 3; ++i) addBatch(bench.session, BatchState::Front);
    bench.queue.setSession(&bench.session);
    QSignalSpy changed(&bench.queue, &QAbstractItemModel::dataChanged);
    catalogue::Catalogue& rows = bench.session.project().catalogue();
    (void)catalogue::Batches(rows).setState(catalogue::Batches(rows).byNumber("B0002")->row,
                                            BatchState::Done, {});
    bench.session.tellBatchChanged("B0002");
    QCOMPARE(bench.queue.row(1).state, QueueState::Done);
    QCOMPARE(changed.count(), 1);
    QCOMPARE(changed[0][0].toModelIndex().row(), 1);
    QCOMPARE(changed[0][1].toModelIndex().row(), 1);
  }

  void aDraftComesFirstAndIsFinalWhenItIsComputedAgain() {
    InlineJobRunner jobs;
    Bench bench(folder(), jobs);
    QVector<bool> drafts;
    bench.setWork([&](const ComputeOptions& options, Progress&, std::stop_token) -> Computed {
      drafts << options.draft;
      catalogue::Catalogue& rows = bench.session.project().catalogue();
      records::BatchRecord record = *catalogue::Batches(rows).byNumber(options.number);
      record.state = options.draft ? BatchState::Review : BatchState::Done;
      record.scale_doubts.clear();
      if (options.draft) record.scale_doubts = {"This is a draft."};
      (void)catalogue::Batches(rows).save(record, {});
      BatchFigures figures;
      figures.sherds = figures.sure = 3;
      figures.draft = options.draft;
      return figures;
    });
    bench.queue.setSession(&bench.session);
    bench.queue.switches()->setMakesDrafts(true);
    const QString number = addBatch(bench.session, BatchState::Queued);
    bench.session.tellBatchChanged(number);
    QTRY_COMPARE(drafts, QVector<bool>{true});
    QTRY_COMPARE(bench.queue.row(0).state, QueueState::Review);
    QVERIFY(stateWords(bench.queue.row(0)).startsWith(QLatin1String("Draft:")));
    const auto words = [&] { return figuresWords(*bench.queue.row(0).figures); };
    QVERIFY2(words().contains(QLatin1String("draft")), qPrintable(words()));
    bench.queue.retry(number);
    QTRY_COMPARE(drafts, (QVector<bool>{true, false}));
    QTRY_VERIFY(!words().contains(QLatin1String("draft")));
    Bench again(folder(), jobs);
    again.queue.setSession(&again.session);
    QVERIFY2(again.queue.switches()->makesDrafts(), "the project remembers it");
  }

  // Who photographs wants to see the sherds before they go back into their bag.
  void aDraftDoesNotWaitForWhatIsMadeFinal() {
    ThreadedJobRunner jobs;
    Bench bench(folder(), jobs);
    std::mutex guard;
    QStringList begun;
    bench.setWork([&](const ComputeOptions& options, Progress& progress,
                      std::stop_token stop) -> Computed {
      bool endless = false;
      {
        const std::lock_guard lock(guard);
        begun << QString::fromStdString(options.number) + (options.draft ? " draft" : " final");
        endless = begun.last() == QLatin1String("B0001 final") && begun.count("B0001 final") == 1;
      }
      while (endless && !stop.stop_requested()) {
        progress.report(1, 3);
        std::this_thread::yield();
      }
      if (stop.stop_requested()) return Error::cancelled();
      auto project = upkeep::Project::open(options.project);
      const auto batch = catalogue::Batches(project->catalogue()).byNumber(options.number);
      (void)catalogue::Batches(project->catalogue()).setState(batch->row, BatchState::Review, {});
      BatchFigures figures;
      figures.sherds = figures.sure = 3;
      figures.draft = options.draft;
      return figures;
    });
    const auto seen = [&] {
      const std::lock_guard lock(guard);
      return begun;
    };
    bench.queue.setSession(&bench.session);
    bench.queue.switches()->setMakesDrafts(true);
    const QString first = addBatch(bench.session, BatchState::Queued);
    bench.session.tellBatchChanged(first);
    QTRY_COMPARE(bench.queue.row(0).state, QueueState::Review);
    bench.queue.retry(first);  // final, and it takes long
    QTRY_COMPARE(seen(), (QStringList{"B0001 draft", "B0001 final"}));
    const QString second = addBatch(bench.session, BatchState::Queued);
    bench.session.tellBatchChanged(second);
    // The draft is made at once; then the other goes on, and nobody has to ask for it.
    QTRY_COMPARE(seen(), (QStringList{"B0001 draft", "B0001 final", "B0002 draft", "B0001 final"}));
    QTRY_COMPARE(bench.queue.row(1).state, QueueState::Review);
    QVERIFY(bench.queue.row(1).failure.isEmpty());
    QVERIFY(!bench.queue.row(1).figures->draft);
    QVERIFY(bench.queue.row(0).figures->draft);
  }

  void aBumpedCameraIsNamedUntilTheRigIsCalibratedAgain() {
    InlineJobRunner jobs;
    Bench bench(folder(), jobs);
    bench.setWork([&](const ComputeOptions& options, Progress&, std::stop_token) -> Computed {
      catalogue::Catalogue& rows = bench.session.project().catalogue();
      (void)catalogue::Batches(rows).setState(
          catalogue::Batches(rows).byNumber(options.number)->row, BatchState::Done, {});
      BatchFigures figures;
      figures.sherds = figures.sure = 3;
      figures.moved = {{1, 0.83, 2.5, 0.01}};
      return figures;
    });
    bench.queue.setSession(&bench.session);
    const QString number = addBatch(bench.session, BatchState::Queued);
    bench.session.tellBatchChanged(number);
    QTRY_COMPARE(bench.queue.row(0).state, QueueState::Done);
    const auto told = [](BatchQueue& queue) {
      return queue.data(queue.index(0), Qt::AccessibleTextRole).toString();
    };
    QVERIFY2(told(bench.queue).contains(QLatin1String("Camera B was bumped")),
             qPrintable(told(bench.queue)));
    QVERIFY(told(bench.queue).contains(QLatin1String("0.8 px, 2.5 mm")));
    {
      Bench again(folder(), jobs);  // the window was closed
      again.queue.setSession(&again.session);
      QCOMPARE(again.queue.row(0).figures->moved.size(), std::size_t{1});
      QCOMPARE(again.queue.row(0).figures->moved[0].camera, 1);
    }
    bench.queue.forgetMoved(number);
    QVERIFY(!told(bench.queue).contains(QLatin1String("bumped")));
    Bench again(folder(), jobs);
    again.queue.setSession(&again.session);
    QVERIFY(again.queue.row(0).figures->moved.empty());
  }

  void aPausedQueueStaysPausedWhenTheProjectIsOpenedAgain() {
    InlineJobRunner jobs;
    QString number;
    {
      Bench bench(folder(), jobs);
      bench.queue.setSession(&bench.session);
      bench.queue.switches()->setPaused(true);
      number = addBatch(bench.session, BatchState::Queued);
      bench.session.tellBatchChanged(number);
      QCoreApplication::processEvents();
      QVERIFY(bench.computed.isEmpty());
    }
    Bench again(folder(), jobs);
    again.queue.setSession(&again.session);
    QVERIFY(again.queue.switches()->isPaused());
    QVERIFY(again.queue.workWords().contains(QLatin1String("1")));
    again.queue.switches()->setPaused(false);
    QTRY_COMPARE(again.computed, QStringList{number});
  }

  void aBatchThatWasBeingComputedWhenTheWindowClosedIsComputedAgain() {
    ThreadedJobRunner jobs;
    std::atomic<int> begun = 0;
    const auto endless = [&](const ComputeOptions&, Progress&, std::stop_token stop) -> Computed {
      ++begun;
      while (!stop.stop_requested()) std::this_thread::yield();
      return Error::cancelled();
    };
    QString number;
    {
      Bench bench(folder(), jobs);
      bench.setWork(endless);
      number = addBatch(bench.session, BatchState::Queued);
      bench.queue.setSession(&bench.session);
      QTRY_COMPARE(begun.load(), 1);
      bench.queue.setSession(nullptr);
    }
    Bench again(folder(), jobs);
    QCOMPARE(stateOf(again.session, number), BatchState::Queued);
    again.queue.setSession(&again.session);
    QTRY_COMPARE(again.computed, QStringList{number});
  }

  void whatWasComputedWhileTheWindowClosedHasItsFigures() {
    ThreadedJobRunner jobs;
    std::atomic<bool> begun = false, go = false;
    {
      Bench bench(folder(), jobs);
      bench.setWork([&](const ComputeOptions& options, Progress&, std::stop_token) -> Computed {
        begun = true;
        while (!go) std::this_thread::yield();  // too far on to be stopped
        auto project = upkeep::Project::open(options.project);
        const auto batch = catalogue::Batches(project->catalogue()).byNumber(options.number);
        (void)catalogue::Batches(project->catalogue()).setState(batch->row, BatchState::Review, {});
        return BatchFigures{3, 2, 1, 0.07, 5};
      });
      addBatch(bench.session, BatchState::Queued);
      bench.queue.setSession(&bench.session);
      QTRY_VERIFY(begun);
      bench.queue.setSession(nullptr);
      go = true;
      QTRY_VERIFY(!bench.queue.computation()->isLeaving());
    }
    Bench again(folder(), jobs);
    again.queue.setSession(&again.session);
    QCOMPARE(again.queue.row(0).state, QueueState::Review);
    QVERIFY(again.queue.row(0).figures.has_value());
    QCOMPARE(again.queue.row(0).figures->ask, 1);
  }

  void theSameQueueStartsNothingBeforeTheOldWorkEnded() {
    ThreadedJobRunner jobs;
    std::atomic<int> at_once = 0, most = 0, begun = 0;
    Bench bench(folder(), jobs);
    bench.setWork([&](const ComputeOptions&, Progress&, std::stop_token stop) -> Computed {
      most = std::max(most.load(), ++at_once);
      ++begun;
      while (!stop.stop_requested()) std::this_thread::yield();
      --at_once;
      return Error::cancelled();
    });
    addBatch(bench.session, BatchState::Queued);
    bench.queue.setSession(&bench.session);
    QTRY_COMPARE(begun.load(), 1);
    bench.queue.setSession(nullptr);
    bench.queue.setSession(&bench.session);
    QTRY_COMPARE(begun.load(), 2);
    QCOMPARE(most.load(), 1);
  }

  void aFailureIsKeptWithItsSentenceAndDoesNotStopTheOthers() {
    InlineJobRunner jobs;
    Bench bench(folder(), jobs);
    const QString bad = addBatch(bench.session, BatchState::Queued);
    const QString good = addBatch(bench.session, BatchState::Queued);
    bench.setWork([&](const ComputeOptions& options, Progress&, std::stop_token) -> Computed {
      if (QString::fromStdString(options.number) == bad)
        return Error{ErrorCode::UnusableInput, "Only two markers are seen; shoot it again.",
                     "front/cam1_pos03.jpg"};
      bench.computed << QString::fromStdString(options.number);
      (void)catalogue::Batches(bench.session.project().catalogue())
          .setState(
              catalogue::Batches(bench.session.project().catalogue()).byNumber(options.number)->row,
              BatchState::Done, {});
      return BatchFigures{};
    });
    QSignalSpy failed(&bench.queue, &BatchQueue::batchFailed);
    bench.queue.setSession(&bench.session);
    QTRY_COMPARE(bench.computed, QStringList{good});
    QCOMPARE(failed.count(), 1);
    QCOMPARE(stateOf(bench.session, bad), BatchState::Failed);
    const QueueRow& row = bench.queue.row(bench.queue.rowOf(bad));
    QVERIFY(row.failure.contains(QLatin1String("front/cam1_pos03.jpg")));
    QVERIFY(row.failure.contains(QLatin1String("shoot it again")));
    QCOMPARE(bench.queue.failed(), 1);
  }

  void aFullDiskIsAPauseThatGoesOn() {
    InlineJobRunner jobs;
    Bench bench(folder(), jobs);
    const QString number = addBatch(bench.session, BatchState::Queued);
    bool full = true;
    bench.setWork([&](const ComputeOptions& options, Progress&, std::stop_token) -> Computed {
      if (full) return Error{ErrorCode::CannotWrite, "The disk is full.", "OUT"};
      bench.computed << QString::fromStdString(options.number);
      (void)catalogue::Batches(bench.session.project().catalogue())
          .setState(
              catalogue::Batches(bench.session.project().catalogue()).byNumber(options.number)->row,
              BatchState::Done, {});
      return BatchFigures{};
    });
    bench.queue.setSession(&bench.session);
    QTRY_VERIFY(!bench.queue.switches()->trouble().isEmpty());
    QVERIFY(bench.queue.switches()->isPaused());
    QCOMPARE(stateOf(bench.session, number), BatchState::Queued);
    full = false;
    bench.queue.switches()->setPaused(false);
    QVERIFY(bench.queue.switches()->trouble().isEmpty());
    QTRY_COMPARE(bench.computed, QStringList{number});
  }

  // What is computed is of photographs that are put aside.
  void aBatchThatIsPhotographedAgainIsComputedNoFurther() {
    ThreadedJobRunner jobs;
    Bench bench(folder(), jobs);
    std::atomic<int> begun = 0;
    bench.setWork([&](const ComputeOptions&, Progress&, std::stop_token stop) -> Computed {
      ++begun;
      while (!stop.stop_requested()) std::this_thread::yield();
      return Error{ErrorCode::UnusableInput, "A photograph is gone.", {}};
    });
    const QString number = addBatch(bench.session, BatchState::Queued);
    bench.queue.setSession(&bench.session);
    QTRY_COMPARE(begun.load(), 1);
    catalogue::Catalogue& rows = bench.session.project().catalogue();
    QVERIFY(catalogue::Batches(rows)
                .setState(catalogue::Batches(rows).byNumber(number.toStdString())->row,
                          BatchState::Flipped, {})
                .has_value());
    bench.session.tellBatchChanged(number);
    QTRY_VERIFY(!bench.queue.computation()->isBusy());
    QCOMPARE(stateOf(bench.session, number), BatchState::Flipped);
    QCOMPARE(bench.queue.row(0).state, QueueState::Shooting);
  }

  // It would count as queued still, and be computed for ever.
  void aFailureThatCannotBeWrittenDownStopsTheQueue() {
    InlineJobRunner jobs;
    Bench bench(folder(), jobs);
    const QString number = addBatch(bench.session, BatchState::Queued);
    store::Database& database = bench.session.project().catalogue().database();
    database.run(
        "CREATE TEMP TRIGGER refuses BEFORE UPDATE OF state ON main.batch BEGIN "
        "SELECT RAISE(ABORT, 'no'); END");
    int begun = 0;
    bench.setWork([&begun](const ComputeOptions&, Progress&, std::stop_token) -> Computed {
      ++begun;
      return Error{ErrorCode::NotEnough, "There are no photographs.", "B0001"};
    });
    bench.queue.setSession(&bench.session);
    QTRY_VERIFY(!bench.queue.switches()->trouble().isEmpty());
    QCOMPARE(begun, 1);
    QVERIFY(bench.queue.switches()->isPaused());
    database.run("DROP TRIGGER refuses");
    bench.queue.switches()->setPaused(false);
    QTRY_COMPARE(stateOf(bench.session, number), BatchState::Failed);
    QCOMPARE(begun, 2);
  }

  void aCancelledBatchWaitsForThePersonToTryAgain() {
    ThreadedJobRunner jobs;
    Bench bench(folder(), jobs);
    std::atomic<int> begun = 0;
    bench.setWork([&](const ComputeOptions&, Progress&, std::stop_token stop) -> Computed {
      ++begun;
      while (!stop.stop_requested()) std::this_thread::yield();
      return Error::cancelled();
    });
    const QString number = addBatch(bench.session, BatchState::Queued);
    bench.queue.setSession(&bench.session);
    QTRY_COMPARE(begun.load(), 1);
    bench.queue.cancel(number);
    QTRY_COMPARE(bench.queue.row(0).state, QueueState::Failed);
    QVERIFY(bench.queue.row(0).cancelled);
    QCOMPARE(bench.queue.failed(), 0);  // nobody needs to be called for what was asked for
    bench.queue.retry(number);
    QTRY_COMPARE(begun.load(), 2);
    bench.queue.cancel(number);
    QTRY_VERIFY(!bench.queue.computation()->isBusy());
  }

  void everyStageOfTheChainHasWordsOfItsOwn() {
    for (const char* stage :
         {"cameras", "masks of the front side", "masks of the back side",
          "stereo of the front side", "stereo of the back side", "scans of the front side",
          "scans of the back side", "pairs", "models", "report", "candidates", "catalogue"})
      QVERIFY2(stageWords(QString::fromLatin1(stage)) != QLatin1String(stage), stage);
    QCOMPARE(stageWords(QStringLiteral("pairs")), QStringLiteral("Matching fronts and backs"));
  }

 private:
  std::filesystem::path folder() const {
    return std::filesystem::path(folder_->path().toStdString()) / "project";
  }
  std::unique_ptr<QTemporaryDir> folder_;
};

OSTRAKA_UI_TEST(BatchQueueTest)
#include "batch_queue_test.moc"
