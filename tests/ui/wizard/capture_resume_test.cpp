// What becomes of the batch in hand when the program, the project or the rig is another.
#include <QSignalSpy>
#include <QtTest>

#include "bench.h"
#include "catalogue/batches.h"
#include "catalogue/label_codes.h"
#include "files/files.h"
#include "rig/plate_print.h"
#include "sherds/typed_numbers.h"
#include "store/database.h"
#include "tests/ui/program.h"
#include "ui/queue/batch_queue.h"

using namespace ostraka;
using namespace ostraka::ui;
using records::BatchState;

class CaptureResumeTest : public QObject {
  Q_OBJECT

 private slots:
  void init() { folder_ = std::make_unique<QTemporaryDir>(); }

  void aCaptureThatWasInterruptedGoesOnWhereItWas() {
    InlineJobRunner jobs;
    QString number;
    {
      Bench bench(folder(), jobs);
      bench.toFlip();
      number = bench.wizard.batch().number();
    }
    Bench again(folder(), jobs);
    again.wizard.rig()->choose(sourceOf(again.rig));
    QTRY_COMPARE(again.wizard.phase(), CapturePhase::Flip);
    QCOMPARE(again.wizard.batch().number(), number);
    again.wizard.next();
    QTRY_COMPARE(again.batch().state, BatchState::Queued);
    QCOMPARE(again.rig.shot, std::vector<batch::Side>{batch::Side::Back});
  }

  // Nothing of what was seen of the fronts is remembered; their photographs are.
  void theFrontsAreCountedAgainAfterAStart() {
    InlineJobRunner jobs;
    {
      Bench bench(folder(), jobs);
      bench.toPlace();
      bench.wizard.description()->setCounted(8);
      bench.goOn(CapturePhase::Flip);
      QCOMPARE(bench.wizard.doubts().size(), 1);
    }
    for (const char* camera : {"cam0", "cam1", "cam2"})
      QVERIFY(
          writeFileAtomically(
              folder() / "batches" / "B0001" / "front" / (std::string(camera) + "_pos00.jpg"), "x")
              .has_value());
    {
      Bench again(folder(), jobs);
      again.wizard.rig()->choose(sourceOf(again.rig));
      QTRY_COMPARE(again.wizard.phase(), CapturePhase::Flip);
      QTRY_COMPARE(again.wizard.doubts().size(), 1);
      QVERIFY(again.wizard.doubts()[0].contains("You counted 8"));
    }
    Bench again(folder(), jobs);
    again.rig.back = 7;
    again.wizard.rig()->choose(sourceOf(again.rig));
    QTRY_COMPARE(again.wizard.phase(), CapturePhase::Flip);
    again.wizard.next();  // at once
    QTRY_COMPARE(again.wizard.phase(), CapturePhase::Done);
    QVERIFY2(again.wizard.doubts().join(' ').contains("on the front: 9, on the back: 7"),
             qPrintable(again.wizard.doubts().join('\n')));
  }

  // The number that the next batch was going to have was taken by others.
  void theVirtualRigIsThatOfTheBatchAfterImports() {
    InlineJobRunner jobs;
    Bench bench(folder(), jobs);
    RigSource source = sourceOf(bench.rig);
    source.anew_for_each_batch = true;
    bench.wizard.rig()->choose(source);
    QTRY_COMPARE(bench.wizard.phase(), CapturePhase::Place);
    QCOMPARE(bench.rig.opened_for, 1);
    records::BatchRecord imported;
    imported.state = BatchState::Queued;
    QVERIFY(catalogue::Batches(bench.session.project().catalogue()).add(imported, {}).has_value());
    bench.session.tellBatchChanged("B0001");
    QTRY_COMPARE(bench.wizard.phase(), CapturePhase::Place);
    QCOMPARE(bench.rig.opened_for, 2);
    // And when nobody told of it.
    QVERIFY(catalogue::Batches(bench.session.project().catalogue()).add(imported, {}).has_value());
    bench.goOn(CapturePhase::Place);
    QCOMPARE(bench.rig.opened_for, 3);
    bench.goOn(CapturePhase::Flip);
    QCOMPARE(bench.wizard.batch().number(), QStringLiteral("B0003"));
    QCOMPARE(bench.rig.opened_for, 3);
  }

  void aProjectThatWasMovedGetsNoPhotographsAtItsOldPlace() {
    InlineJobRunner jobs;
    const std::filesystem::path place = folder() / "open", moved = folder() / "moved";
    Bench bench(place, jobs);
    bench.toFlip();
    std::filesystem::rename(place, moved);
    bench.wizard.next();
    QTRY_VERIFY(bench.wizard.fault().has_value());
    QVERIFY(bench.wizard.fault()->what.english().find("not there any more") != std::string::npos);
    QVERIFY(!std::filesystem::exists(place));
    QCOMPARE(bench.rig.shot, std::vector<batch::Side>{batch::Side::Front});
    std::filesystem::rename(moved, place);  // and back: it goes on
    bench.goOn(CapturePhase::Done);
  }

  void aWrongBagIsMendedAfterTheFronts() {
    InlineJobRunner jobs;
    Bench bench(folder(), jobs);
    bench.wizard.description()->setPlace({"ARM1", "T3", "0012", "4"});
    bench.toFlip();
    QVERIFY(bench.wizard.canDescribe());
    bench.wizard.description()->setPlace({"ARM1", "T3", "0012", "5"});
    bench.wizard.next();
    QTRY_COMPARE(bench.batch().state, BatchState::Queued);
    QVERIFY(!bench.wizard.canDescribe());
    const catalogue::Catalogue& rows = bench.session.project().catalogue();
    QCOMPARE(bench.batch().bags.size(), std::size_t{1});
    const auto place = catalogue::placeOf(rows, bench.batch().bags.front());
    QVERIFY(place && *place);
    QCOMPARE(QString::fromStdString((*place)->bag), QStringLiteral("5"));
  }

  void aBatchGoesOnUnderItsOwnBag() {
    InlineJobRunner jobs;
    {
      Bench bench(folder(), jobs);
      bench.wizard.description()->setPlace({"ARM1", "T3", "0012", "4"});
      bench.toFlip();
    }
    Bench again(folder(), jobs);
    again.wizard.description()->setPlace({"ARM1", "T3", "0099", "1"});  // as the window kept it
    QSignalSpy read(again.wizard.description(), &BatchDescription::placeRead);
    again.wizard.rig()->choose(sourceOf(again.rig));
    QTRY_COMPARE(again.wizard.phase(), CapturePhase::Flip);
    QCOMPARE(again.wizard.description()->place(), (PlaceText{"ARM1", "T3", "0012", "4"}));
    QCOMPARE(read.count(), 1);
  }

  void aBatchThatNobodyWantsGivesWayAndCanComeBack() {
    InlineJobRunner jobs;
    Bench bench(folder(), jobs);
    bench.toPlace();
    QVERIFY(!bench.wizard.canSetAside());
    bench.goOn(CapturePhase::Flip);
    QVERIFY(bench.wizard.canSetAside());
    BatchQueue queue;
    queue.setSession(&bench.session);
    connect(&bench.wizard, &CaptureWizard::batchSetAside, &queue, &BatchQueue::setAside);
    bench.wizard.setAside();
    QTRY_COMPARE(bench.wizard.phase(), CapturePhase::Place);
    QCOMPARE(bench.wizard.batch().number(), QString());
    QCOMPARE(bench.batch().state, BatchState::Failed);
    queue.retry(QStringLiteral("B0001"));
    QTRY_COMPARE(bench.wizard.phase(), CapturePhase::Flip);
    QCOMPARE(bench.wizard.batch().number(), QStringLiteral("B0001"));
  }

  void ofTwoUnfinishedBatchesTheOtherOneWaits() {
    InlineJobRunner jobs;
    Bench bench(folder(), jobs);
    records::BatchRecord other;
    other.state = BatchState::Front;
    QVERIFY(catalogue::Batches(bench.session.project().catalogue()).add(other, {}).has_value());
    bench.wizard.rig()->choose(sourceOf(bench.rig));
    QTRY_COMPARE(bench.wizard.phase(), CapturePhase::Flip);  // B0001 goes on
    BatchQueue queue;
    queue.setSession(&bench.session);
    connect(&bench.wizard, &CaptureWizard::batchSetAside, &queue, &BatchQueue::setAside);
    QVERIFY(catalogue::Batches(bench.session.project().catalogue()).add(other, {}).has_value());
    const int opened = bench.rig.opened;
    bench.wizard.setAside();
    QTRY_COMPARE(bench.wizard.phase(), CapturePhase::Place);
    QCOMPARE(bench.wizard.batch().number(), QString());
    QCOMPARE(bench.rig.opened, opened + 1);
    bench.wizard.description()->setPlace({"ARM1", "T3", "0012", "4"});
    bench.session.tellBatchChanged("B0001");  // any batch: what lies here is nobody else's
    QCOMPARE(bench.wizard.batch().number(), QString());
    QCOMPARE(bench.wizard.description()->place(), (PlaceText{"ARM1", "T3", "0012", "4"}));
  }

  void aMendedBagIsTheBatchsAtOnce() {
    InlineJobRunner jobs;
    Bench bench(folder(), jobs);
    bench.wizard.description()->setPlace({"ARM1", "T3", "0012", "4"});
    bench.toFlip();
    bench.wizard.description()->setPlace({"ARM1", "T3", "0013", "1"});
    bench.wizard.keepDescribed();
    const auto number =
        sherds::wholeNumber(bench.session.project().catalogue(), bench.batch().row, "7");
    QCOMPARE(QString::fromStdString(*number), QStringLiteral("ARM1-T3-0013-0007"));
  }

  void oneThatWasClosedInMidShootTellsWhatIsSafeAndGoesOnAtItsStop() {
    InlineJobRunner jobs;
    {
      Bench bench(folder(), jobs);
      bench.rig.refuse_shoot = Error::cancelled();
      bench.toPlace();
      bench.wizard.next();
      QTRY_VERIFY(bench.wizard.fault().has_value());
      QVERIFY(!bench.text.instruction().contains("Hands off"));
    }
    const std::filesystem::path side = folder() / "batches" / "B0001" / "front";
    Bench again(folder(), jobs);
    const RigSource source = sourceOf(again.rig);
    std::filesystem::create_directories(side);
    again.wizard.rig()->choose(source);
    QTRY_COMPARE(again.wizard.phase(), CapturePhase::Place);  // nothing was taken yet
    const int cameras = again.wizard.rig()->cameras();
    for (int camera = 0; camera < cameras; ++camera)
      for (const char* stop : {"00", "01"})
        QVERIFY(writeFileAtomically(
                    side / ("cam" + std::to_string(camera) + "_pos" + stop + ".jpg"), "x")
                    .has_value());
    again.wizard.rig()->choose(source);
    QTRY_COMPARE(again.wizard.phase(), CapturePhase::ShootFront);
    QVERIFY(again.wizard.fault().has_value());
    QVERIFY2(QString::fromStdString(again.wizard.fault()->what.english())
                 .contains(QString::number(2 * cameras) + " photograph"),
             again.wizard.fault()->what.english().c_str());
    QCOMPARE(again.wizard.side()->stopsDone(), 2);
    QCOMPARE(again.wizard.side()->shots().size(), static_cast<std::size_t>(2 * cameras));
    QCOMPARE(again.text.button(), QStringLiteral("Resume at position 3"));
    again.goOn(CapturePhase::Flip);
    QCOMPARE(again.wizard.batch().number(), QStringLiteral("B0001"));
  }

  void aBatchThatTheCatalogueDoesNotTakeIsNotSaidToBeQueued() {
    InlineJobRunner jobs;
    Bench bench(folder(), jobs);
    bench.toFlip();
    store::Database& database = bench.session.project().catalogue().database();
    database.run(
        "CREATE TEMP TRIGGER full BEFORE UPDATE ON batch BEGIN SELECT RAISE(ABORT, 'full'); "
        "END");
    QSignalSpy queued(&bench.wizard, &CaptureWizard::batchQueued);
    bench.wizard.next();
    QTRY_VERIFY(bench.wizard.fault().has_value());
    QCOMPARE(queued.count(), 0);
    database.run("DROP TRIGGER full");
    QVERIFY(bench.wizard.canGoOn());
    bench.wizard.next();
    QCOMPARE(bench.batch().state, BatchState::Queued);
    QCOMPARE(queued.count(), 1);
    QVERIFY(!bench.wizard.fault());
    QCOMPARE(bench.wizard.phase(), CapturePhase::Done);
  }

  // A calibration that ends while the plate is photographed.
  void aRigThatChangesInMidShootWaitsForTheSideToEnd() {
    ThreadedJobRunner jobs;
    Bench bench(folder(), jobs);
    bench.toPlace();
    bench.rig.wait_for_stop = true;
    bench.wizard.next();
    RigSource renewed = sourceOf(bench.rig);
    renewed.words = "renewed";
    bench.wizard.rig()->choose(renewed);
    QCOMPARE(bench.wizard.phase(), CapturePhase::ShootFront);
    QCOMPARE(bench.rig.opened, 1);  // its devices belong to the photographs that are being taken
    QVERIFY(bench.wizard.rig()->isBusy());
    bench.wizard.stop();  // and Esc still reaches the table
    QCOMPARE(bench.rig.stopped.load(), 1);
    QTRY_COMPARE(bench.wizard.rig()->source().words, QStringLiteral("renewed"));
    QTRY_COMPARE(bench.wizard.phase(), CapturePhase::Place);
    QCOMPARE(bench.rig.opened, 2);
    QCOMPARE(bench.wizard.batch().number(), QStringLiteral("B0001"));  // the same batch goes on
  }

  void aRigThatIsTakenAwayInMidShootLeavesNoPhaseWithoutABatch() {
    ThreadedJobRunner jobs;
    Bench bench(folder(), jobs);
    bench.toPlace();
    bench.rig.wait_for_stop = true;
    bench.wizard.next();
    bench.wizard.rig()->clear();
    QCOMPARE(bench.wizard.phase(), CapturePhase::ShootFront);
    bench.rig.wait_for_stop = false;
    QTRY_COMPARE(bench.wizard.phase(), CapturePhase::NoRig);
    QCOMPARE(bench.batch().state, BatchState::Front);
    QVERIFY(!bench.wizard.rig()->isBusy());
    bench.wizard.rig()->choose(sourceOf(bench.rig));
    QTRY_COMPARE(bench.wizard.phase(), CapturePhase::Flip);
  }

  void aRigThatHangsIsLeftForAnother() {
    ThreadedJobRunner jobs;
    Bench bench(folder(), jobs);
    bench.rig.ask = true;  // and nobody answers
    bench.wizard.rig()->choose(sourceOf(bench.rig));
    QTRY_VERIFY(!bench.wizard.rig()->question().isEmpty());
    bench.wizard.rig()->clear();
    QTRY_COMPARE(bench.wizard.phase(), CapturePhase::NoRig);
    QVERIFY(!bench.wizard.rig()->isBusy());
    QVERIFY(!bench.wizard.fault());
  }

  void aBatchIsNotGoneOnWithOnAnotherPlate() {
    InlineJobRunner jobs;
    Bench bench(folder(), jobs);
    bench.rig.refuse_shoot = Error{ErrorCode::Missing, "Camera B did not answer.", "rig"};
    bench.toPlace();
    bench.wizard.next();
    QTRY_VERIFY(bench.wizard.fault().has_value());
    QCOMPARE(bench.rig.prepared, 1);
    const std::filesystem::path batch = folder() / "batches" / "B0001";
    batch::Plate first;
    first.dictionary = "DICT_5X5_100";
    first.diameter_mm = 200;
    first.markers.push_back({1, {{{0, 0, 0}, {10, 0, 0}, {10, -10, 0}, {0, -10, 0}}}});
    QVERIFY(rig::writePlate(batch / "plate.json", first).has_value());
    capture::Manifest manifest;
    manifest.stops = 8;
    manifest.cameras = 3;
    manifest.entries.resize(1);
    manifest.entries[0].file = "front/cam0_pos00.jpg";
    QVERIFY(capture::writeManifest(batch, manifest).has_value());
    bench.wizard.next();
    QTRY_VERIFY(bench.wizard.fault() &&
                bench.wizard.fault()->what.english().find("another plate") != std::string::npos);
    QCOMPARE(bench.rig.prepared, 1);  // which would have written its own plate there
  }

  void doubtsAboutABatchOutliveAnotherRig() {
    InlineJobRunner jobs;
    Bench bench(folder(), jobs);
    bench.rig.back = 8;
    bench.toDone();
    QVERIFY(!bench.wizard.doubts().isEmpty());
    bench.wizard.rig()->choose(sourceOf(bench.rig));
    QTRY_COMPARE(bench.wizard.phase(), CapturePhase::Done);
    QCOMPARE(bench.batch().state, BatchState::Back);  // nobody has said that it is right
    QVERIFY(!bench.wizard.doubts().isEmpty());
  }

  void aBatchThatNobodySaidToBeRightIsNotQueuedByItself() {
    InlineJobRunner jobs;
    {
      Bench bench(folder(), jobs);
      bench.rig.back = 8;
      bench.toDone();
    }
    Bench again(folder(), jobs);
    again.wizard.rig()->choose(sourceOf(again.rig));
    QTRY_COMPARE(again.wizard.phase(), CapturePhase::Done);
    QCOMPARE(again.batch().state, BatchState::Back);
    QVERIFY2(again.wizard.doubts().join(' ').contains("B0001"),
             qPrintable(again.wizard.doubts().join(' ')));
    again.wizard.next();
    QTRY_COMPARE(again.batch().state, BatchState::Queued);
  }

  void aNewerBatchFromElsewhereDoesNotHideTheOneThatWasInterrupted() {
    InlineJobRunner jobs;
    {
      Bench bench(folder(), jobs);
      bench.toFlip();
      records::BatchRecord imported;
      imported.state = BatchState::Queued;
      QVERIFY(
          catalogue::Batches(bench.session.project().catalogue()).add(imported, {}).has_value());
    }
    Bench again(folder(), jobs);
    again.wizard.rig()->choose(sourceOf(again.rig));
    QTRY_COMPARE(again.wizard.phase(), CapturePhase::Flip);
    QCOMPARE(again.wizard.batch().number(), QStringLiteral("B0001"));
  }

  // The project is closed in the moment in which its job ends.
  void aJobThatEndsAsTheProjectClosesSaysNothingMore() {
    InlineJobRunner jobs;
    Bench bench(folder(), jobs);
    bench.toPlace();
    bench.wizard.next();
    // Behind the job itself, before its end is told.
    QMetaObject::invokeMethod(
        &bench.wizard, [&] { bench.wizard.setSession(nullptr); }, Qt::QueuedConnection);
    QTRY_COMPARE(bench.rig.asked.size(), std::size_t{1});
    QTest::qWait(0);
    QCOMPARE(bench.wizard.phase(), CapturePhase::NoRig);
    QVERIFY(!bench.wizard.rig()->isBusy());
    QCOMPARE(bench.batch().state, BatchState::Placed);
  }

 private:
  std::filesystem::path folder() const {
    return std::filesystem::path(folder_->path().toStdString()) / "project";
  }
  std::unique_ptr<QTemporaryDir> folder_;
};

OSTRAKA_UI_TEST(CaptureResumeTest)
#include "capture_resume_test.moc"
