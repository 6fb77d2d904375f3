// The same promises for both runners: the threaded one of the program, the inline one of tests.
#include "ui/jobs/job.h"

#include <QSignalSpy>
#include <QtTest>
#include <atomic>
#include <semaphore>
#include <stdexcept>
#include <thread>

#include "tests/ui/program.h"

using namespace ostraka;
using namespace ostraka::ui;

namespace {

std::unique_ptr<JobRunner> runnerOf(const QString& name) {
  if (name == QLatin1String("inline")) return std::make_unique<InlineJobRunner>();
  return std::make_unique<ThreadedJobRunner>();
}

// Collects what a handle says.
struct Heard {
  explicit Heard(JobHandle* handle) {
    QObject::connect(handle, &JobHandle::progressed, handle,
                     [this](const JobProgress& p) { progress.push_back(p); });
    QObject::connect(handle, &JobHandle::noted, handle,
                     [this](NoteLevel, const QString& text) { notes.push_back(text); });
    QObject::connect(handle, &JobHandle::finished, handle, [this](const JobOutcome& outcome) {
      outcomes.push_back(outcome);
      window_thread = QThread::currentThread() == QCoreApplication::instance()->thread();
    });
  }
  std::vector<JobProgress> progress;
  std::vector<QString> notes;
  std::vector<JobOutcome> outcomes;
  bool window_thread = false;
};

}  // namespace

class JobTest : public QObject {
  Q_OBJECT

 private slots:
  void bothRunners_data() {
    QTest::addColumn<QString>("runner");
    QTest::newRow("inline") << "inline";
    QTest::newRow("threaded") << "threaded";
  }
  void aValueArrivesInTheWindowsThread_data() { bothRunners_data(); }
  void aValueArrivesInTheWindowsThread() {
    QFETCH(QString, runner);
    const auto jobs = runnerOf(runner);
    JobHandle* job = jobs->start(makeJob([](Progress& progress, std::stop_token) -> Result<int> {
                                   progress.begin("adding", 0.5);
                                   progress.report(1, 2);
                                   progress.note(NoteLevel::Warning, "one of two");
                                   return 42;
                                 }),
                                 this);
    Heard heard(job);
    QVERIFY(heard.outcomes.empty());
    QTRY_COMPARE(heard.outcomes.size(), std::size_t{1});
    QVERIFY(heard.window_thread);
    QCOMPARE(*outcomeAs<int>(heard.outcomes[0]), 42);
    QCOMPARE(heard.notes, std::vector<QString>{"one of two"});
    QVERIFY(!heard.progress.empty());
    QCOMPARE(heard.progress[0].stage, QString("adding"));
  }

  void whatTheWorkTellsArrivesInOrderBeforeTheEnd_data() { bothRunners_data(); }
  void whatTheWorkTellsArrivesInOrderBeforeTheEnd() {
    QFETCH(QString, runner);
    const auto jobs = runnerOf(runner);
    JobHandle* job = jobs->start(makeJob([](Progress& progress, std::stop_token) -> Result<int> {
                                   for (int i = 0; i < 5; ++i) tell(progress, i);
                                   return 5;
                                 }),
                                 this);
    std::vector<int> heard;
    connect(job, &JobHandle::told, this,
            [&](const std::any& v) { heard.push_back(std::any_cast<int>(v)); });
    connect(job, &JobHandle::finished, this,
            [&](const JobOutcome& o) { heard.push_back(*outcomeAs<int>(o)); });
    QTRY_COMPARE(heard, (std::vector<int>{0, 1, 2, 3, 4, 5}));
  }

  void anErrorAndAnExceptionArriveAsSentences_data() { bothRunners_data(); }
  void anErrorAndAnExceptionArriveAsSentences() {
    QFETCH(QString, runner);
    const auto jobs = runnerOf(runner);
    Heard refused(jobs->start(makeJob([](Progress&, std::stop_token) -> Result<void> {
                                return Error{ErrorCode::Missing, "Not there.", "camera B"};
                              }),
                              this));
    Heard thrown(jobs->start(makeJob([](Progress&, std::stop_token) -> Result<void> {
                               throw std::runtime_error("index 7");
                             }),
                             this));
    QTRY_COMPARE(refused.outcomes.size() + thrown.outcomes.size(), std::size_t{2});
    QCOMPARE(refused.outcomes[0].error().sentence(), std::string("camera B: Not there."));
    QCOMPARE(thrown.outcomes[0].error().code, ErrorCode::Failed);
    QVERIFY(thrown.outcomes[0].error().what.english().find("index 7") != std::string::npos);
  }

  // A result in the window's queue comes before a deleteLater that is behind it.
  void nothingArrivesOfAJobThatIsDropped() {
    class AtOnce final : public JobRunner {
      void run(JobPriority, std::function<void()> body, std::stop_source, JobHandle*) override {
        body();
      }
    } jobs;
    std::stop_token asked;
    QPointer<JobHandle> job = jobs.start(makeJob([&asked](Progress& progress, std::stop_token s) {
                                           asked = std::move(s);
                                           progress.note(NoteLevel::Warning, "one");
                                           tell(progress, 7);
                                           return Result<int>(42);
                                         }),
                                         this);
    int heard = 0;
    connect(job, &JobHandle::noted, this, [&heard] { ++heard; });
    connect(job, &JobHandle::told, this, [&heard] { ++heard; });
    connect(job, &JobHandle::finished, this, [&heard] { ++heard; });
    job->drop();
    QVERIFY(asked.stop_requested());
    QTRY_VERIFY(job.isNull());
    QCOMPARE(heard, 0);
  }

  void aJobCancelledBeforeItBeganDoesNotRun_data() { bothRunners_data(); }
  void aJobCancelledBeforeItBeganDoesNotRun() {
    QFETCH(QString, runner);
    const auto jobs = runnerOf(runner);
    // Both threads of the threaded runner are held, so that the third job has to wait.
    std::counting_semaphore<> go(0);
    if (runner == "threaded")
      for (int i = 0; i < 2; ++i)
        jobs->start(makeJob([&go](Progress&, std::stop_token) -> Result<void> {
                      go.acquire();
                      return {};
                    }),
                    this);
    std::atomic<bool> ran = false;
    JobHandle* job = jobs->start(makeJob([&ran](Progress&, std::stop_token) -> Result<void> {
                                   ran = true;
                                   return {};
                                 }),
                                 this);
    Heard heard(job);
    job->cancel();
    go.release(2);
    QTRY_COMPARE(heard.outcomes.size(), std::size_t{1});
    QCOMPARE(heard.outcomes[0].error().code, ErrorCode::Cancelled);
    QVERIFY(!ran);
  }

  void whatWasPromisedIsDoneThoughItsHandleWentBeforeItBegan() {
    ThreadedJobRunner jobs;
    std::counting_semaphore<> busy(0), go(0);
    std::atomic<int> done = 0;
    const auto wait = [&](Progress&, std::stop_token) -> Result<void> {
      busy.release();
      go.acquire();
      return {};
    };
    const auto work = [&done](Progress&, std::stop_token) -> Result<void> {
      ++done;
      return {};
    };
    jobs.start(makeJob(wait), this);  // both threads
    jobs.start(makeJob(wait), this);
    busy.acquire();
    busy.acquire();
    Job promised = makeJob(work);
    promised.is_promised = true;
    delete jobs.start(makeJob(work), this);
    delete jobs.start(std::move(promised), this);
    go.release(2);
    QTRY_COMPARE(done.load(), 1);
  }

  void progressComesAtMostTenTimesASecond() {
    ThreadedJobRunner jobs;
    const auto start = std::chrono::steady_clock::now();
    Heard heard(jobs.start(makeJob([](Progress& progress, std::stop_token) -> Result<int> {
                             for (int i = 0; i < 200000; ++i) progress.report(i, 200000);
                             return 0;
                           }),
                           this));
    QTRY_COMPARE(heard.outcomes.size(), std::size_t{1});
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    QVERIFY(static_cast<double>(heard.progress.size()) <= 10 * seconds + 2);
  }

  void aPausedJobStandsStillAndGoesOn() {
    ThreadedJobRunner jobs;
    std::binary_semaphore begun(0), go(0);
    std::atomic<int> steps = 0;
    JobHandle* job = jobs.start(makeJob([&](Progress& progress, std::stop_token) -> Result<int> {
                                  begun.release();
                                  go.acquire();
                                  progress.report(1, 2);  // stands still here
                                  ++steps;
                                  return 7;
                                }),
                                this);
    Heard heard(job);
    begun.acquire();
    job->pause();
    QSignalSpy stood(job, &JobHandle::stoodStill);
    go.release();
    QTRY_COMPARE(stood.count(), 1);
    QCOMPARE(steps.load(), 0);
    job->resume();
    QTRY_COMPARE(heard.outcomes.size(), std::size_t{1});
    QCOMPARE(steps.load(), 1);
    QCOMPARE(*outcomeAs<int>(heard.outcomes[0]), 7);
  }

  void aPausedJobCanBeCancelled() {
    ThreadedJobRunner jobs;
    JobHandle* job =
        jobs.start(makeJob([](Progress& progress, std::stop_token stop) -> Result<int> {
                     while (!stop.stop_requested()) progress.report(0, 1);
                     return Error::cancelled();
                   }),
                   this);
    Heard heard(job);
    job->pause();
    job->cancel();
    QTRY_COMPARE(heard.outcomes.size(), std::size_t{1});
    QCOMPARE(heard.outcomes[0].error().code, ErrorCode::Cancelled);
  }

  void aDeletedHandleStopsItsJobAndNothingArrives() {
    std::atomic<bool> stopped = false;
    {
      ThreadedJobRunner jobs;
      auto* owner = new QObject;
      std::binary_semaphore begun(0);
      JobHandle* job = jobs.start(makeJob([&](Progress&, std::stop_token stop) -> Result<int> {
                                    begun.release();
                                    while (!stop.stop_requested()) std::this_thread::yield();
                                    stopped = true;
                                    return 1;
                                  }),
                                  owner);
      QSignalSpy spy(job, &QObject::destroyed);
      begun.acquire();
      delete owner;
      QCOMPARE(spy.count(), 1);
    }  // the runner waits for its threads
    QVERIFY(stopped);
    QCoreApplication::processEvents();
  }

  void theEndOfTheRunnerStopsAllJobs() {
    std::atomic<int> stopped = 0;
    {
      ThreadedJobRunner jobs;
      for (const JobPriority priority : {JobPriority::Quick, JobPriority::Background})
        jobs.start(makeJob(
                       [&stopped](Progress&, std::stop_token stop) -> Result<int> {
                         while (!stop.stop_requested()) std::this_thread::yield();
                         return ++stopped;
                       },
                       priority),
                   this);
    }
    QVERIFY(stopped <= 2);  // a job that had not begun does not begin
    QCoreApplication::processEvents();
  }
};

OSTRAKA_UI_TEST(JobTest)
#include "job_test.moc"
