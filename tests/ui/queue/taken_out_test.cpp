// A batch that is asked for again, and asked for no more.
#include <QtTest>
#include <atomic>
#include <thread>

#include "catalogue/settings.h"
#include "queue_bench.h"
#include "review/review.h"
#include "synthetic_out.h"
#include "tests/ui/program.h"

using namespace ostraka;
using namespace ostraka::ui;

class TakenOutTest : public QObject {
  Q_OBJECT

 private slots:
  void init() { folder_ = std::make_unique<QTemporaryDir>(); }

  void whatWaitsToBeComputedAgainIsWhatItWas() {
    InlineJobRunner jobs;
    Bench bench(folder(), jobs);
    const QString number = reviewed(bench);
    bench.queue.retry(number);  // by mistake
    QCOMPARE(stateOf(bench.session, number), BatchState::Queued);
    bench.queue.cancel(number);
    QCOMPARE(bench.queue.row(0).state, QueueState::Review);
    QVERIFY(bench.queue.row(0).failure.isEmpty());
    QTest::qWait(0);
    QCOMPARE(stateOf(bench.session, number), BatchState::Review);
    QCOMPARE(bench.queue.failed(), 0);
    bench.queue.switches()->setPaused(false);
    QTest::qWait(0);
    QVERIFY(bench.computed.isEmpty());
  }

  void whatIsAnsweredWhileItWaitsCounts() {
    InlineJobRunner jobs;
    Bench bench(folder(), jobs);
    const QString number = reviewed(bench);
    bench.queue.retry(number);
    const auto review = review::loadReview(out_.output);
    QVERIFY(review.has_value());
    QCOMPARE(review->waiting(), 2);
    for (const review::ReviewCard& card : review->cards) {
      if (card.state != review::CardState::Ask) continue;
      decisions::PairDecision confirmed;
      confirmed.by = "AP";
      confirmed.scans = {out_.table.fronts.at(static_cast<std::size_t>(card.front)),
                         out_.table.backs.at(static_cast<std::size_t>(card.back))};
      confirmed.front_from_back = card.front_from_back;
      QVERIFY(decisions::appendDecision(out_.output, confirmed).has_value());
    }
    bench.queue.cancel(number);
    QTRY_COMPARE(stateOf(bench.session, number), BatchState::Done);
    QTRY_COMPARE(bench.queue.row(0).state, QueueState::Done);
  }

  void whatWasNeverComputedIsStopped() {
    InlineJobRunner jobs;
    Bench bench(folder(), jobs);
    bench.queue.setSession(&bench.session);
    bench.queue.switches()->setPaused(true);
    const QString number = addBatch(bench.session, BatchState::Queued);
    bench.session.tellBatchChanged(number);
    bench.queue.cancel(number);
    QCOMPARE(bench.queue.row(0).state, QueueState::Failed);
    QCOMPARE(bench.queue.row(0).failure, QStringLiteral("You removed it from the queue."));
    QCOMPARE(bench.queue.failed(), 0);
  }

  // Masks are mended while a batch is computed, and their page asks for it again.
  void whatIsAskedOfABatchInWorkIsKept() {
    ThreadedJobRunner jobs;
    Bench bench(folder(), jobs);
    std::atomic<bool> begun = false;
    bench.setWork([&begun](const intake::ComputeOptions&, Progress&,
                           std::stop_token stop) -> Result<intake::BatchFigures> {
      begun = true;
      while (!stop.stop_requested()) std::this_thread::yield();
      return Error::cancelled();
    });
    const QString number = addBatch(bench.session, BatchState::Queued);
    bench.queue.setSession(&bench.session);
    QTRY_VERIFY(begun);
    bench.queue.retry(number);
    QCOMPARE(bench.queue.row(0).state, QueueState::Busy);
    const auto asked =
        catalogue::Settings(bench.session.project().catalogue()).value("queue.again.B0001");
    QVERIFY(!asked->empty());
    bench.queue.setSession(nullptr);
  }

 private:
  std::filesystem::path folder() const {
    return std::filesystem::path(folder_->path().toStdString()) / "project";
  }
  // In a queue that stands still: computed, with two questions.
  QString reviewed(Bench& bench) {
    const QString number = addBatch(bench.session, BatchState::Review);
    out_ = pipeline::writeSyntheticOut(folder() / "results" / number.toStdString(), {});
    bench.queue.setSession(&bench.session);
    bench.queue.switches()->setPaused(true);
    return number;
  }
  std::unique_ptr<QTemporaryDir> folder_;
  pipeline::SyntheticOut out_;
};

OSTRAKA_UI_TEST(TakenOutTest)
#include "taken_out_test.moc"
