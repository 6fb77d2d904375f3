// What a batch's row in the queue shows.
#include <QtTest>

#include "batch/batch.h"
#include "catalogue/batches.h"
#include "catalogue/label_codes.h"
#include "catalogue/places.h"
#include "files/files.h"
#include "queue_bench.h"
#include "records/records.h"
#include "records/sherd.h"
#include "sherds/sherd_changes.h"
#include "sherds/sherds.h"
#include "tests/ui/program.h"
#include "ui/queue/batch_queue.h"

using namespace ostraka;
using namespace ostraka::ui;
using intake::BatchFigures, intake::ComputeOptions;
using Computed = Result<BatchFigures>;

class QueueRowsTest : public QObject {
  Q_OBJECT

 private slots:
  void init() { folder_ = std::make_unique<QTemporaryDir>(); }

  void aBatchIsShownByAPhotographOfItsFrontAlsoWhereItWasImported() {
    InlineJobRunner jobs;
    Bench bench(folder(), jobs);
    const QString number = addBatch(bench.session, BatchState::Review);
    const auto front =
        bench.session.project().batchFolder(number.toStdString()) / batch::name(batch::Side::Front);
    for (const char* name : {"IMG_10.jpg", "IMG_9.jpg"})
      QVERIFY(writeFileAtomically(front / name, "a photograph").has_value());
    bench.queue.setSession(&bench.session);
    QVERIFY2(bench.queue.row(0).picture.endsWith("/front/IMG_9.jpg"),
             qPrintable(bench.queue.row(0).picture));
  }

  void whatIsProcessedSaysThatItIsADraftAndHowLongItTakes() {
    QueueRow row;
    row.progress = {QStringLiteral("models"), 0.75, -1};
    QCOMPARE(progressWords(row), QStringLiteral("Closing the models, 75 %"));
    row.draft = true;
    row.estimate_s = 480;
    QCOMPARE(progressWords(row),
             QStringLiteral("Draft: Closing the models, 75 %, about 2 min left"));
    row.progress.fraction = 0.5;
    QCOMPARE(progressWords(row),
             QStringLiteral("Draft: Closing the models, 50 %, about 4 min left"));
    row.progress.fraction = 0.75;
    row.progress.seconds_left = 120;
    QCOMPARE(progressWords(row),
             QStringLiteral("Draft: Closing the models, 75 %, about 2 min left"));
  }

  void aBatchOfTheVirtualRigIsMarkedAsInvented() {
    InlineJobRunner jobs;
    Bench bench(folder(), jobs);
    const QString number = addBatch(bench.session, BatchState::Review);
    catalogue::Batches batches(bench.session.project().catalogue());
    records::PhotographRecord photograph;
    photograph.batch = batches.byNumber(number.toStdString())->row;
    photograph.path = "batches/B0001/front/cam0_pos00.jpg";
    photograph.serial = std::string(batch::kVirtualSerial) + "A";
    QVERIFY(batches.save(photograph, {}).has_value());
    bench.queue.setSession(&bench.session);
    QVERIFY2(bench.queue.row(0).about.contains("invented"), qPrintable(bench.queue.row(0).about));
  }

  void aBatchIsWhereAllOfItsSherdsAreByNow() {
    InlineJobRunner jobs;
    Bench bench(folder(), jobs);
    const catalogue::Catalogue& rows = bench.session.project().catalogue();
    const auto wrong = catalogue::bagAt(rows, {"ARM1", "T3", "12", "4"}, {});
    QVERIFY(wrong && catalogue::bagAt(rows, {"ARM1", "T3", "0012", "4"}, {}));
    records::BatchRecord batch;
    batch.bags = {*wrong};
    batch.state = records::BatchState::Review;
    records::SherdRecord sherd;
    sherd.batch = *catalogue::Batches(rows).add(batch, {});
    sherd.bag = *wrong;
    sherd.context = *catalogue::Places(rows).contextByPlace("ARM1", "T3", "12");
    const auto added = sherds::Sherds(rows).add(sherd, {});
    bench.queue.setSession(&bench.session);
    QCOMPARE(bench.queue.row(0).about, QStringLiteral("ARM1 / T3 / 12 bag 4"));
    const records::FieldChange move{*added, "context", "0012"};
    QVERIFY(sherds::SherdChanges(rows).apply(std::span(&move, 1), {}).has_value());
    bench.session.tellSherdsChanged();
    QCOMPARE(bench.queue.row(0).about, QStringLiteral("ARM1 / T3 / 0012 bag 4"));
  }

  void aBatchWithoutABagSaysSo() {
    InlineJobRunner jobs;
    Bench bench(folder(), jobs);
    addBatch(bench.session, BatchState::Review);
    bench.queue.setSession(&bench.session);
    QVERIFY(bench.queue.row(0).without_bag);
    QVERIFY(bench.queue.data(bench.queue.index(0), Qt::AccessibleTextRole)
                .toString()
                .contains(withoutBagWords()));
  }

  void aBatchWithADoubtfulScaleDoesNotLookDone() {
    InlineJobRunner jobs;
    QString number;
    {
      Bench bench(folder(), jobs);
      number = addBatch(bench.session, BatchState::Queued);
      bench.setWork([&](const ComputeOptions&, Progress&, std::stop_token) -> Computed {
        catalogue::Catalogue& rows = bench.session.project().catalogue();
        records::BatchRecord record = *catalogue::Batches(rows).byNumber(number.toStdString());
        record.state = BatchState::Review;
        record.scale_doubts = {"The scale is wrong: 50 mm measure 49.5 mm."};
        (void)catalogue::Batches(rows).save(record, {});
        BatchFigures figures;
        figures.sherds = figures.sure = 3;
        figures.counted = 4;
        figures.numbers_left = {"A-7"};
        return figures;
      });
      bench.queue.setSession(&bench.session);
      QTRY_COMPARE(bench.queue.row(0).state, QueueState::Review);
      QVERIFY(stateWords(bench.queue.row(0)).startsWith(QLatin1String("Scale in doubt")));
      QVERIFY(bench.queue.row(0).scale_doubts.contains(QLatin1String("49.5 mm")));
    }
    Bench again(folder(), jobs);
    again.queue.setSession(&again.session);
    QCOMPARE(again.queue.row(0).state, QueueState::Review);
    const QString figures = figuresWords(*again.queue.row(0).figures);
    QVERIFY2(figures.contains("4 counted on the plate; the number A-7"), qPrintable(figures));
    QVERIFY(stateWords(again.queue.row(0)).startsWith(QLatin1String("Scale in doubt")));
    QVERIFY(again.computed.isEmpty());
  }

 private:
  std::filesystem::path folder() const {
    return std::filesystem::path(folder_->path().toStdString()) / "project";
  }
  std::unique_ptr<QTemporaryDir> folder_;
};

OSTRAKA_UI_TEST(QueueRowsTest)
#include "queue_rows_test.moc"
