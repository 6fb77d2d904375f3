// Place - Shoot - Flip - Shoot - Done without a display and without a rig.
#include <QSignalSpy>
#include <QtTest>

#include <QImage>

#include "bench.h"
#include "catalogue/batches.h"
#include "catalogue/files.h"
#include "tests/ui/program.h"

using namespace ostraka;
using namespace ostraka::ui;
using records::BatchState;

class CaptureWizardTest : public QObject {
  Q_OBJECT

 private slots:
  void init() { folder_ = std::make_unique<QTemporaryDir>(); }

  void runners_data() {
    QTest::addColumn<bool>("threaded");
    QTest::newRow("inline") << false;
    QTest::newRow("threaded") << true;
  }

  void threeKeysMakeABatch_data() { runners_data(); }
  void threeKeysMakeABatch() {
    QFETCH(bool, threaded);
    std::unique_ptr<JobRunner> jobs;
    if (threaded)
      jobs = std::make_unique<ThreadedJobRunner>();
    else
      jobs = std::make_unique<InlineJobRunner>();
    Bench bench(folder(), *jobs);
    bench.wizard.description()->setPlace(*readPlaceText("ARM1-T3-0012-4"));
    bench.toPlace();
    QSignalSpy queued(&bench.wizard, &CaptureWizard::batchQueued);
    bench.goOn(CapturePhase::Flip);
    QCOMPARE(bench.batch().state, BatchState::Front);
    QCOMPARE(bench.batch().bags.size(), std::size_t{1});
    bench.goOn(CapturePhase::Done);
    QTRY_COMPARE(queued.count(), 1);
    QCOMPARE(bench.batch().state, BatchState::Queued);
    QCOMPARE(bench.batch().counted, 9);
    QCOMPARE(bench.rig.placed, (std::vector<batch::Side>{batch::Side::Front, batch::Side::Back}));
    QCOMPARE(bench.text.headline(), QStringLiteral("You may clear the plate."));
    const QString first = bench.wizard.batch().number();
    bench.goOn(CapturePhase::Place);
    bench.goOn(CapturePhase::Flip);
    QVERIFY(bench.wizard.batch().number() != first);
    QCOMPARE(bench.rig.opened, 1);  // a real rig stays open
  }

  void aCameraHeldByTheDesktopIsReleasedAndTriedAgain() {
    InlineJobRunner jobs;
    Bench bench(folder(), jobs);
    bench.rig.refuse_open = Error{ErrorCode::Missing, "It is held.", "camera B"};
    bench.rig.holders = {"gvfsd-gphoto2 (77)"};
    bench.wizard.rig()->choose(sourceOf(bench.rig));
    QTRY_COMPARE(bench.wizard.rig()->holders(), QStringList{QStringLiteral("gvfsd-gphoto2 (77)")});
    QVERIFY(bench.wizard.fault().has_value());
    QCOMPARE(bench.text.button(), QStringLiteral("Release camera"));
    bench.goOn(CapturePhase::Place);
    QCOMPARE(bench.rig.released, 1);
    QCOMPARE(bench.rig.opened, 2);
    QVERIFY(bench.wizard.rig()->holders().isEmpty());
  }

  void aDesktopThatDoesNotLetGoIsSaidAndAskedAgain() {
    InlineJobRunner jobs;
    Bench bench(folder(), jobs);
    bench.rig.refuse_open = Error{ErrorCode::Missing, "It is held.", "camera B"};
    bench.rig.holders = {"gvfsd-gphoto2 (77)"};
    bench.rig.stubborn = true;
    bench.wizard.rig()->choose(sourceOf(bench.rig));
    QTRY_VERIFY(!bench.wizard.rig()->holders().isEmpty());
    bench.wizard.next();
    QTRY_VERIFY(bench.wizard.fault() && bench.wizard.fault()->where == "D3200");
    QCOMPARE(bench.text.button(), QStringLiteral("Try again"));
    bench.wizard.next();
    QTRY_COMPARE(bench.text.button(), QStringLiteral("Release camera"));
    QCOMPARE(bench.rig.opened, 2);
  }

  void aFaultThatIsNoLostDeviceAsksNobodyToLetGo() {
    InlineJobRunner jobs;
    Bench bench(folder(), jobs);
    bench.rig.holders = {"gvfsd-gphoto2 (77)"};  // of a telephone, say
    bench.toPlace();
    bench.rig.refuse_shoot = Error{ErrorCode::CannotWrite, "The disk is full.", "batch"};
    bench.wizard.next();
    QTRY_VERIFY(bench.wizard.fault().has_value());
    bench.goOn(CapturePhase::Flip);
    QCOMPARE(bench.rig.released, 0);
  }

  void aRigThatDoesNotAnswerIsTriedAgain() {
    InlineJobRunner jobs;
    Bench bench(folder(), jobs);
    bench.rig.refuse_open = Error{ErrorCode::Missing, "It does not answer.", "camera B"};
    bench.wizard.rig()->choose(sourceOf(bench.rig));
    QTRY_VERIFY(bench.wizard.fault().has_value());
    QVERIFY(bench.wizard.canGoOn());
    bench.rig.refuse_open.reset();
    bench.goOn(CapturePhase::Place);
    QVERIFY(!bench.wizard.fault());
  }

  void aRigThatDoesNotOpenLeavesItsPlaceToTheOneThatWorked() {
    InlineJobRunner jobs;
    Bench bench(folder(), jobs);
    bench.toPlace();
    std::optional<Error> why_not;
    connect(bench.wizard.rig(), &RigConnection::tried, this, [&](const std::optional<Error>& why) {
      if (why) why_not = why;
    });
    FakeRig bad;
    bad.refuse_open = Error{ErrorCode::UnusableInput, "It is not a rig.", "RIG.json"};
    for (const bool by_way_of_the_page : {false, true}) {
      why_not.reset();
      if (by_way_of_the_page) bench.wizard.rig()->clear();
      bench.wizard.rig()->choose(sourceOf(bad));
      QTRY_VERIFY(why_not.has_value());
      QCOMPARE(why_not->where, std::string("RIG.json"));
      QTRY_COMPARE(bench.wizard.phase(), CapturePhase::Place);
      QVERIFY(!bench.wizard.fault());
    }
    QCOMPARE(bad.opened, 2);
    QCOMPARE(bench.rig.opened, 3);
    bench.wizard.rig()->clear();
    QVERIFY(bench.wizard.rig()->canRestore());
    bench.wizard.rig()->restore();
    QTRY_COMPARE(bench.wizard.phase(), CapturePhase::Place);
    QVERIFY(!bench.wizard.rig()->canRestore());
  }

  void theHeadlineOfARigThatDoesNotOpenSaysSo() {
    InlineJobRunner jobs;
    Bench bench(folder(), jobs);
    bench.rig.refuse_open = Error{ErrorCode::UnusableInput, "It is not a rig.", "RIG.json"};
    bench.wizard.rig()->choose(sourceOf(bench.rig));
    QCOMPARE(bench.text.headline(), QStringLiteral("Opening the rig"));
    QTRY_VERIFY(bench.wizard.fault().has_value());
    QCOMPARE(bench.text.headline(), QStringLiteral("The rig does not open"));
  }

  void aRigThatTurnsItsSherdsAsksNobodyToTurnThem() {
    InlineJobRunner jobs;
    Bench bench(folder(), jobs);
    RigSource source = sourceOf(bench.rig);
    source.turns_sherds = true;
    bench.wizard.rig()->choose(source);
    QTRY_COMPARE(bench.wizard.phase(), CapturePhase::Place);
    bench.goOn(CapturePhase::Flip);
    QVERIFY2(bench.text.headline().contains("virtual rig"), qPrintable(bench.text.headline()));
    QCOMPARE(bench.text.button(), QStringLiteral("Shoot the backs"));
  }

  void aWaitSaysForWhichPhotographs() {
    InlineJobRunner jobs;
    Bench bench(folder(), jobs);
    RigSource source = sourceOf(bench.rig);
    source.prepare = [](const std::filesystem::path&, int, Progress& progress,
                        std::stop_token) -> Result<void> {
      tell(progress, PreparedPhotographs{3, 36});
      return {};
    };
    QStringList buttons, headlines;
    connect(&bench.wizard, &CaptureWizard::changed, this, [&] {
      buttons << bench.text.button();
      headlines << bench.text.headline();
    });
    bench.wizard.rig()->choose(source);
    QTRY_COMPARE(bench.wizard.phase(), CapturePhase::Place);
    bench.goOn(CapturePhase::Flip);
    QVERIFY(buttons.contains(QStringLiteral("Calibration photograph 4 of 36")));
    const qsizetype calibration = headlines.indexOf("Taking calibration photographs");
    QVERIFY(calibration >= 0);
    QVERIFY2(headlines.lastIndexOf("Photographing the fronts") > calibration,
             "the sherds are photographed under the headline of the calibration");
  }

  void aFaultSaysWhatIsSafeAndTheSameKeyGoesOn() {
    InlineJobRunner jobs;
    Bench bench(folder(), jobs);
    bench.toPlace();
    bench.rig.refuse_shoot =
        Error{ErrorCode::Missing, "Camera B did not answer at stop 5. Check its cable.", ""};
    bench.wizard.next();
    QTRY_VERIFY(bench.wizard.fault().has_value());
    QVERIFY(bench.wizard.fault()->what.english().find("1 photograph") != std::string::npos);
    QCOMPARE(bench.batch().state, BatchState::Placed);
    bench.goOn(CapturePhase::Flip);
    QCOMPARE(bench.rig.asked.size(), std::size_t{2});
    QCOMPARE(bench.rig.asked[0].batch, bench.rig.asked[1].batch);  // the same batch goes on
  }

  void escapeStopsTheTableAtOnce() {
    ThreadedJobRunner jobs;
    Bench bench(folder(), jobs);
    bench.toPlace();
    bench.rig.wait_for_stop = true;
    bench.wizard.next();
    QVERIFY(bench.wizard.rig()->isBusy());
    bench.wizard.stop();
    QCOMPARE(bench.text.headline(), QStringLiteral("Stopping…"));
    QCOMPARE(bench.rig.stopped.load(), 1);
    QTRY_VERIFY(bench.wizard.fault().has_value());
    QCOMPARE(bench.wizard.fault()->code, ErrorCode::Cancelled);
    QVERIFY(bench.text.headline() != QStringLiteral("Stopping…"));
    bench.rig.wait_for_stop = false;
    bench.goOn(CapturePhase::Flip);
  }

  void aLostSherdKeepsTheBatchOutOfTheQueueUntilThePersonSaysSo() {
    InlineJobRunner jobs;
    Bench bench(folder(), jobs);
    bench.rig.back = 8;
    bench.toDone();
    QVERIFY(!bench.wizard.doubts().isEmpty());
    QVERIFY(bench.text.headline() != QStringLiteral("You may clear the plate."));
    QCOMPARE(bench.batch().state, BatchState::Back);
    bench.rig.back = 9;
    bench.wizard.again();
    QTRY_COMPARE(bench.batch().state, BatchState::Queued);
    QCOMPARE(bench.rig.asked.back().retake.size(), std::size_t{24});  // the whole side
    QVERIFY(bench.wizard.doubts().isEmpty());
  }

  // What vanishes before the batch is processed is missed by 'catalogue check' and archives.
  void aQueuedBatchHasItsPhotographsInTheCatalogue() {
    InlineJobRunner jobs;
    Bench bench(folder(), jobs);
    bench.toFlip();
    const auto batch = bench.session.project().batchFolder(bench.batch().number);
    for (const char* side : {"front", "back"}) {
      std::filesystem::create_directories(batch / side);
      for (int stop = 0; stop < 4; ++stop) {
        QImage picture(16, 12, QImage::Format_RGB32);
        picture.fill(QColor(40 * stop, 0, side[0] == 'f' ? 0 : 90));
        const std::string name = "cam1_pos0" + std::to_string(stop) + ".jpg";
        QVERIFY(picture.save(QString::fromStdString((batch / side / name).string())));
      }
    }
    bench.goOn(CapturePhase::Done);
    QTRY_COMPARE(bench.batch().state, BatchState::Queued);
    const catalogue::Catalogue& rows = bench.session.project().catalogue();
    const auto recorded = [&] { return catalogue::Files(rows).of(bench.batch().row)->size(); };
    QTRY_COMPARE(recorded(), std::size_t{8});
  }

  // What is in the queue are the photographs before.
  void aSideThatIsPhotographedAgainAfterItWasQueuedIsQueuedOnceMore() {
    InlineJobRunner jobs;
    Bench bench(folder(), jobs);
    bench.toFlip();
    bench.wizard.next();
    QTRY_COMPARE(bench.batch().state, BatchState::Queued);
    const QString number = bench.wizard.batch().number();
    bench.rig.back = 8;
    // Nobody doubted them: one key puts nothing away.
    bench.wizard.again();
    QVERIFY(!bench.wizard.rig()->isBusy());
    QVERIFY(bench.wizard.doubts().join(' ').contains("R once more puts all of them aside"));
    QCOMPARE(bench.batch().state, BatchState::Queued);
    // What comes first to hand keeps them, and nothing else begins.
    QCOMPARE(bench.text.button(), QStringLiteral("Keep the photographs"));
    bench.wizard.next();
    QVERIFY(bench.wizard.doubts().isEmpty() && !bench.wizard.rig()->isBusy());
    QCOMPARE(bench.wizard.phase(), CapturePhase::Done);
    QCOMPARE(bench.wizard.batch().number(), number);
    bench.wizard.again();
    bench.wizard.again();
    QTRY_COMPARE(bench.wizard.phase(), CapturePhase::Done);
    QVERIFY(!bench.wizard.doubts().isEmpty());
    QCOMPARE(bench.batch().state, BatchState::Back);
    bench.wizard.next();
    QTRY_COMPARE(bench.batch().state, BatchState::Queued);
    QCOMPARE(bench.wizard.batch().number(), number);
  }

  void whoStillHasTheSherdsInHandIsToldThatTheyAreComputed() {
    InlineJobRunner jobs;
    Bench bench(folder(), jobs);
    bench.toFlip();
    bench.wizard.next();
    QTRY_COMPARE(bench.batch().state, BatchState::Queued);
    const auto told = [&] {
      for (const CaptureFact& fact : bench.text.facts())
        if (fact.words.contains("review")) return true;
      return false;
    };
    QVERIFY(!told());
    QSignalSpy changed(&bench.wizard, &CaptureWizard::changed);
    QVERIFY(catalogue::Batches(bench.session.project().catalogue())
                .setState(bench.batch().row, BatchState::Review, {})
                .has_value());
    bench.session.tellBatchChanged(bench.wizard.batch().number());
    QCOMPARE(changed.count(), 1);
    QVERIFY(told());
  }

  void aCountThatDiffersFromThePhotographsAsksBeforeTheFlip() {
    InlineJobRunner jobs;
    Bench bench(folder(), jobs);
    bench.rig.front = 8;
    bench.toPlace();
    bench.wizard.description()->setCounted(9);
    bench.goOn(CapturePhase::Flip);
    QCOMPARE(bench.wizard.doubts().size(), 1);
    QVERIFY(bench.wizard.doubts()[0].contains("9") && bench.wizard.doubts()[0].contains("8"));
    bench.rig.front = 9;  // it lay under another
    bench.wizard.again();
    QTRY_VERIFY(bench.wizard.doubts().isEmpty() && !bench.wizard.rig()->isBusy());
    bench.wizard.next();
    QTRY_COMPARE(bench.batch().state, BatchState::Queued);
    QCOMPARE(bench.batch().counted, 9);
    // The next plate is counted anew.
    bench.goOn(CapturePhase::Place);
    QCOMPARE(bench.wizard.batch().counted(), 0);
  }

  void aSlipInTheCountIsMendedAfterTheFronts() {
    InlineJobRunner jobs;
    Bench bench(folder(), jobs);
    bench.toPlace();
    bench.wizard.description()->setCounted(8);
    bench.goOn(CapturePhase::Flip);
    QCOMPARE(bench.wizard.doubts().size(), 1);
    bench.wizard.description()->setCounted(10);
    QVERIFY(bench.wizard.doubts()[0].contains("look for one that is hidden"));
    bench.wizard.description()->setCounted(7);
    QCOMPARE(bench.wizard.doubts().size(), 1);
    QVERIFY(bench.wizard.doubts()[0].contains("7"));
    QVERIFY2(bench.wizard.doubts()[0].contains("correct the count"), "none hides of seven");
    bench.wizard.description()->setCounted(9);
    QVERIFY(bench.wizard.doubts().isEmpty());
    bench.wizard.next();
    QTRY_COMPARE(bench.batch().state, BatchState::Queued);
    QCOMPARE(bench.batch().counted, 9);
  }

  void aCountThatIsStillOtherOnTheBackKeepsThePlate() {
    InlineJobRunner jobs;
    Bench bench(folder(), jobs);
    bench.toPlace();
    bench.wizard.description()->setCounted(10);
    bench.goOn(CapturePhase::Flip);
    bench.goOn(CapturePhase::Done);
    QCOMPARE(bench.wizard.doubts().size(), 1);
    QVERIFY(bench.text.headline() != QStringLiteral("You may clear the plate."));
    bench.wizard.next();  // the person says that it is right
    QTRY_COMPARE(bench.batch().state, BatchState::Queued);
    QCOMPARE(bench.batch().counted, 10);  // what the scans are compared with
  }

  void theCountOutlivesTheWindow() {
    InlineJobRunner jobs;
    {
      Bench bench(folder(), jobs);
      bench.toPlace();
      bench.wizard.description()->setCounted(10);
      bench.wizard.description()->setPlace(*readPlaceText("ARM1-T3-0012-4"));
      bench.goOn(CapturePhase::Flip);
      bench.wizard.description()->setPlace({});  // another bag is half typed
      bench.wizard.description()->setCounted(11);
    }
    Bench again(folder(), jobs);
    again.wizard.rig()->choose(sourceOf(again.rig));
    QTRY_COMPARE(again.wizard.phase(), CapturePhase::Flip);
    QCOMPARE(again.wizard.batch().counted(), 11);
    QCOMPARE(again.wizard.description()->place(), (PlaceText{"ARM1", "T3", "0012", "4"}));
  }

  void aBlurredPhotographIsNamedAndOnlyItIsTakenAgain() {
    InlineJobRunner jobs;
    Bench bench(folder(), jobs);
    bench.rig.flagged = {{0, 1}};
    bench.toFlip();
    QCOMPARE(bench.wizard.doubts().size(), 1);
    QVERIFY(bench.wizard.doubts()[0].contains("B"));
    QVERIFY(bench.wizard.doubts()[0].contains("1"));
    bench.wizard.again();
    QTRY_VERIFY(bench.wizard.doubts().isEmpty() && !bench.wizard.rig()->isBusy());
    QCOMPARE(bench.rig.asked.back().retake, (std::vector<capture::ShotName>{{0, 1}}));
  }

  // Of 24 photographs 3 would show the sherd elsewhere.
  void whatIsMovedIsTakenAgainAtAllStops() {
    InlineJobRunner jobs;
    Bench bench(folder(), jobs);
    bench.rig.flagged = {{0, 1}};
    bench.rig.cut_off = true;
    bench.toFlip();
    bench.wizard.again();
    QTRY_VERIFY(bench.wizard.doubts().isEmpty() && !bench.wizard.rig()->isBusy());
    QCOMPARE(bench.rig.asked.back().retake.size(), std::size_t{24});
    // A blurred photograph beside a sherd that is missing: somebody will lay it down.
    bench.rig.flagged = {{0, 1}};
    bench.rig.back = 8;
    bench.goOn(CapturePhase::Done);
    QCOMPARE(bench.wizard.doubts().size(), 2);
    bench.rig.back = 9;
    bench.wizard.again();
    QTRY_COMPARE(bench.batch().state, BatchState::Queued);
    QCOMPARE(bench.rig.asked.back().retake.size(), std::size_t{24});
  }

  void whatWasAskedForAgainIsNotForgottenByAFault() {
    InlineJobRunner jobs;
    Bench bench(folder(), jobs);
    bench.rig.front = 8;
    bench.toPlace();
    bench.wizard.description()->setCounted(9);
    bench.goOn(CapturePhase::Flip);
    bench.rig.front = 9;
    bench.rig.refuse_shoot = Error{ErrorCode::CannotWrite, "The disk is full.", {}};
    bench.wizard.again();
    QTRY_VERIFY(bench.wizard.fault().has_value());
    QCOMPARE(bench.batch().state, BatchState::Placed);  // its fronts are not whole
    bench.goOn(CapturePhase::Flip);
    // One was kept before the disk was full.
    QCOMPARE(bench.rig.asked.back().retake.size(), std::size_t{23});
  }

  void aBagThatLacksItsContextIsRefusedBeforeAnythingIsShot() {
    InlineJobRunner jobs;
    Bench bench(folder(), jobs);
    bench.wizard.description()->setPlace({"ARM1", "", "", "4"});
    bench.toPlace();
    bench.wizard.next();
    QVERIFY(bench.wizard.fault().has_value());
    QVERIFY(catalogue::Batches(bench.session.project().catalogue()).all()->empty());
  }

  void whatARigAsksOfAPersonIsDoneWithTheSameKey() {
    ThreadedJobRunner jobs;
    Bench bench(folder(), jobs);
    bench.rig.ask = true;
    bench.wizard.rig()->choose(sourceOf(bench.rig));
    QTRY_COMPARE(bench.text.headline(), QStringLiteral("Switch the table on."));
    QVERIFY(bench.wizard.canGoOn());
    bench.goOn(CapturePhase::Place);
    QVERIFY(bench.wizard.rig()->question().isEmpty());
  }

  void aCameraWithoutALivePictureIsNoFault() {
    InlineJobRunner jobs;
    Bench bench(folder(), jobs);
    bench.wizard.rig()->choose(sourceOf(bench.rig));
    bench.wizard.pictures()->setLive(true);
    QTRY_COMPARE(bench.wizard.phase(), CapturePhase::Place);
    QTRY_VERIFY(!bench.text.facts().empty());
    QVERIFY(bench.text.facts()[0].good);
    QVERIFY(!bench.wizard.fault());
  }

 private:
  std::filesystem::path folder() const {
    return std::filesystem::path(folder_->path().toStdString()) / "project";
  }
  std::unique_ptr<QTemporaryDir> folder_;
};

OSTRAKA_UI_TEST(CaptureWizardTest)
#include "capture_wizard_test.moc"
