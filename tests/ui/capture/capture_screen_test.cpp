// The wizard's screen by keys, with a rig that answers as the test says.
#include "ui/capture/capture_screen.h"
#include "ui/wizard/batch_description.h"

#include <QAction>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QtTest>

#include "capture_bench.h"
#include "catalogue/batches.h"
#include "catalogue/label_codes.h"
#include "catalogue/places.h"
#include "catalogue/settings.h"
#include "files/files.h"
#include "records/records.h"
#include "records/sherd.h"
#include "rig/rig.h"
#include "sherds/sherds.h"
#include "tests/ui/program.h"
#include "ui/capture/capture_foot.h"
#include "ui/capture/number_edit.h"
#include "ui/capture/stop_board.h"
#include "ui/frame/project_session.h"
#include "ui/import/batch_importer.h"
#include "ui/import/import_ask.h"
#include "ui/import/place_edit.h"
#include "ui/look/look.h"
#include "ui/widgets/big_button.h"
#include "ui/widgets/message_panel.h"
#include "ui/wizard/capture_wizard.h"
#include "ui/wizard/plate_pictures.h"
#include "ui/wizard/rig_connection.h"
#include "ui/wizard/sherd_numbers.h"
#include "upkeep/project.h"

using namespace ostraka;
using namespace ostraka::ui;

class CaptureScreenTest : public CaptureBench {
  Q_OBJECT

 private slots:
  void init() { open(); }
  void cleanup() { close(); }

  void withoutARigItSaysWhatToDoFirst() {
    QVERIFY(child<QWidget>("useVirtualRig")->isVisible());
    QVERIFY(child<QWidget>("importPhotographsButton")->isVisible());
    QVERIFY(!child<QWidget>("captureButton")->isVisible());
  }

  void spaceIsTheNextThingUntilTheBatchIsQueued() {
    toPlace();
    QTest::keyClick(screen_.get(), Qt::Key_Space);
    QTRY_COMPARE(wizard_->phase(), CapturePhase::Flip);
    QCOMPARE(child<QLabel>("captureHeadline")->text(), CaptureText(*wizard_).headline());
    QTest::mouseClick(child<BigButton>("captureButton"), Qt::LeftButton);
    QTRY_COMPARE(wizard_->phase(), CapturePhase::Done);
    QCOMPARE(child<QLabel>("captureHeadline")->text(), QStringLiteral("You may clear the plate."));
    // Readable from three metres: letters of 5 mm at least.
    const QFontMetricsF letters(child<QLabel>("captureHeadline")->font());
    const double per_mm = screen_->screen()->logicalDotsPerInch() / 25.4;
    QVERIFY(letters.capHeight() >= 5 * per_mm);
    // What was photographed stays in sight.
    QVERIFY(screen_->findChild<StopBoard*>()->isVisible());
  }

  void aSpaceTypedIntoTheBagIsNoShot() {
    toPlace();
    auto* bag = child<QLineEdit>("capturePlace");
    bag->setFocus();
    QTest::keyClicks(bag, "ARM1 T3 0012 4");
    QCOMPARE(wizard_->phase(), CapturePhase::Place);
    QCOMPARE(wizard_->description()->place(), (PlaceText{"ARM1", "T3", "0012", "4"}));
    QTest::keyClick(bag, Qt::Key_Return);
    QVERIFY(!bag->hasFocus());
    QTest::keyClick(screen_.get(), Qt::Key_Space);
    QTRY_COMPARE(wizard_->phase(), CapturePhase::Flip);
  }

  void whatNamesNoBagIsNotPhotographedUnderIt() {
    toPlace();
    auto* bag = child<QLineEdit>("capturePlace");
    bag->setFocus();
    QTest::keyClicks(bag, "hello world");
    QTest::keyClick(bag, Qt::Key_Return);
    QSignalSpy said(screen_.get(), &CaptureScreen::said);
    QTest::keyClick(screen_.get(), Qt::Key_Space);
    QCOMPARE(wizard_->phase(), CapturePhase::Place);
    QVERIFY(bag->hasFocus());
    QCOMPARE(said.count(), 1);
    QVERIFY(said[0][0].toString().startsWith("'hello world' names no bag"));
    bag->clear();
    QTest::keyClick(bag, Qt::Key_Return);
    QTest::keyClick(screen_.get(), Qt::Key_Space);
    QTRY_COMPARE(wizard_->phase(), CapturePhase::Flip);
  }

  void aNewPlaceIsMarkedAndEscTakesItBack() {
    QVERIFY(bagRowOf(session_->project().catalogue(), {"ARM1", "T3", "0012", "4"}, {}).has_value());
    screen_->closeProject();
    screen_->openProject(*session_);
    toPlace();
    auto* place = child<QLineEdit>("capturePlace");
    auto* note = child<QLabel>("capturePlaceNote");
    place->setFocus();
    QTest::keyClicks(place, "ARM1-T3-0012-4");
    QCOMPARE(note->text(), QString());
    place->selectAll();
    QTest::keyClicks(place, "XX-9-foo-77");
    QVERIFY2(note->text().endsWith("site XX, trench 9, context foo, bag 77"),
             qPrintable(note->text()));
    QTest::keyClick(place, Qt::Key_Escape);
    QCOMPARE(place->text(), QStringLiteral("ARM1-T3-0012-4"));
    QCOMPARE(note->text(), QString());
    QCOMPARE(wizard_->description()->place(), (PlaceText{"ARM1", "T3", "0012", "4"}));
    QCOMPARE(catalogue::Places(session_->project().catalogue()).sites()->size(), std::size_t{1});
  }

  void theSherdsAreCountedByKeysAndSpaceIsStillTheNextThing() {
    rig_->front = 11;
    toPlace();
    QTest::keyClick(screen_.get(), Qt::Key_S);
    QWidget* count = child<QSpinBox>("captureCounted");
    QTRY_VERIFY(count->hasFocus());
    QTest::keyClicks(count, "12");
    QCOMPARE(wizard_->batch().counted(), 12);
    QTest::keyClick(screen_->window()->focusWidget(), Qt::Key_Space);
    QTRY_COMPARE(wizard_->phase(), CapturePhase::Flip);
    auto* doubts = child<MessagePanel>("captureDoubts");
    QTRY_VERIFY(doubts->isVisible());
    QVERIFY(doubts->words().contains("You counted 12 sherds"));
    // A slip is mended here, too.
    QTRY_VERIFY(count->isEnabled());
    child<QSpinBox>("captureCounted")->setValue(11);
    QVERIFY(!doubts->isVisible());
  }

  void theCalibrationPhotographsAreCountedOnTheBoardAndAtTheFoot() {
    RigSource source = sourceOf(*rig_);
    source.prepare = [](const std::filesystem::path&, int, Progress& progress,
                        std::stop_token) -> Result<void> {
      tell(progress, PreparedPhotographs{9, 36});
      return {};
    };
    double furthest = 0;
    QStringList boards;
    connect(screen_.get(), &Screen::working, this, [&](const QString& words, double fraction) {
      if (words.contains("Calibration photograph 10 of 36")) furthest = fraction;
    });
    connect(wizard_->side(), &SideProgress::preparing, this,
            [&] { boards << screen_->findChild<StopBoard*>()->accessibleDescription(); });
    wizard_->rig()->choose(source);
    QTRY_COMPARE(wizard_->phase(), CapturePhase::Place);
    QTest::keyClick(screen_.get(), Qt::Key_Space);
    QTRY_COMPARE(wizard_->phase(), CapturePhase::Flip);
    QCOMPARE(furthest, 0.25);
    QVERIFY(boards.contains(QStringLiteral("9 of 36 calibration photographs taken")));
    QVERIFY2(boards.last().endsWith("positions done"), qPrintable(boards.last()));
  }

  void whoPressesROverGoodPhotographsKeepsThemByEscOrSpace() {
    toPlace();
    QTest::keyClick(screen_.get(), Qt::Key_Space);
    QTRY_COMPARE(wizard_->phase(), CapturePhase::Flip);
    QTRY_VERIFY(!wizard_->rig()->isBusy());
    auto* doubts = child<MessagePanel>("captureDoubts");
    for (const Qt::Key key : {Qt::Key_Escape, Qt::Key_Space}) {
      screen_->setFocus();
      QTest::keyClick(screen_.get(), Qt::Key_R);
      QTRY_VERIFY(doubts->isVisible());
      QVERIFY(doubts->words().contains("Space or Esc keeps them"));
      QCOMPARE(child<BigButton>("captureButton")->text(), QString("Keep the photographs"));
      QTest::keyClick(screen_.get(), key);
      QVERIFY(!doubts->isVisible());
      QVERIFY(!wizard_->rig()->isBusy());
      QCOMPARE(wizard_->phase(), CapturePhase::Flip);
    }
    QCOMPARE(rig_->shot, std::vector<batch::Side>{batch::Side::Front});
  }

  void aFaultTakesThePlaceOfTheButtonAndSpaceTriesAgain() {
    toPlace();
    rig_->refuse_shoot = Error{ErrorCode::Missing, "Camera B did not answer at stop 5.", "rig"};
    QTest::keyClick(screen_.get(), Qt::Key_Space);
    auto* fault = child<MessagePanel>("captureFault");
    QTRY_VERIFY(fault->isVisible());
    QVERIFY(!child<BigButton>("captureButton")->isVisible());
    QVERIFY(fault->words().contains("Camera B did not answer"));
    QTest::keyClick(screen_.get(), Qt::Key_Space);
    QTRY_COMPARE(wizard_->phase(), CapturePhase::Flip);
    QVERIFY(!fault->isVisible());
    QVERIFY(child<BigButton>("captureButton")->isVisible());
  }

  void aCameraThatTheDesktopHoldsIsReleasedByTheOneButton() {
    toPlace();
    rig_->refuse_shoot = Error{ErrorCode::Missing, "Camera B is held by another program.", "7"};
    rig_->holders = {"gvfsd-gphoto2 (77)"};
    QTest::keyClick(screen_.get(), Qt::Key_Space);
    auto* fault = child<MessagePanel>("captureFault");
    QTRY_VERIFY(fault->words().contains("by its program gvfsd-gphoto2 (77)"));
    auto* button = fault->findChild<BigButton*>(QStringLiteral("messageAct"));
    QCOMPARE(button->text(), QStringLiteral("Release camera"));
    QTest::mouseClick(button, Qt::LeftButton);
    QTRY_COMPARE(wizard_->phase(), CapturePhase::Flip);
    QCOMPARE(rig_->released, 1);
    QVERIFY(!fault->isVisible());
  }

  void aBumpedCameraIsCalibratedAwayByABatch() {
    const std::filesystem::path file = folder_->filePath("RIG.json").toStdString();
    const auto rigAt = [](double height_mm) {
      rig::Rig rig;
      rig.cameras.resize(1);
      rig.cameras[0].intrinsics = {1600, 1200, 2200, 2200, 800, 600, {}};
      rig.cameras[0].camera_from_turntable.translation().z() = height_mm;
      rig.stops = {0};
      rig.stop_angles_rad = {0};
      return rig;
    };
    QVERIFY(rig::writeRig(file, rigAt(500)).has_value());
    QVERIFY(
        rig::writeRig(session_->project().resultsFolder("B0001") / "work/rig/rig.json", rigAt(507))
            .has_value());
    QSignalSpy said(screen_.get(), &Screen::said);
    QSignalSpy renewed(screen_.get(), &CaptureScreen::rigRenewed);
    screen_->showItem("calibrate:B0001");  // of a project that has no rig's file
    QCOMPARE(said.count(), 1);
    RigChoice choice;
    choice.kind = RigChoice::Kind::File;
    choice.file = file;
    screen_->chooseRig(choice);
    screen_->showItem("calibrate:B0001");
    QTRY_COMPARE(renewed.count(), 1);
    QCOMPARE(renewed[0][0].toString(), QStringLiteral("B0001"));
    QCOMPARE(rig::readRig(file)->cameras[0].camera_from_turntable.translation().z(), 507.0);
    QVERIFY(said.last()[0].toString().contains("RIG.before-1.json"));
    QVERIFY(QFile::exists(folder_->filePath("RIG.before-1.json")));
    // A project that is closed meanwhile says nothing to the next one.
    screen_->showItem("calibrate:B0001");
    screen_->closeProject();
    screen_->openProject(*session_);
    QCoreApplication::processEvents();  // an inline job ends with the events that it posted
    QCOMPARE(renewed.count(), 1);
  }

  // "All right" means that it was read: nothing else may happen, wherever the wizard stands.
  void whoReadThatAnImportFailedShootsNothing_data() {
    QTest::addColumn<bool>("at_flip");
    QTest::newRow("while sherds are laid") << false;
    QTest::newRow("before the flip") << true;
  }
  void whoReadThatAnImportFailedShootsNothing() {
    QFETCH(bool, at_flip);
    toPlace();
    if (at_flip) QTest::keyClick(screen_.get(), Qt::Key_Space);
    const CapturePhase phase = at_flip ? CapturePhase::Flip : CapturePhase::Place;
    QTRY_COMPARE(wizard_->phase(), phase);
    const auto shot = rig_->asked.size();
    QVERIFY(QDir(folder_->path()).mkpath("half/front"));
    screen_->importer()->start(folder_->filePath("half"), ImportKind::Scans, {});
    QTRY_VERIFY(shownMessage() != nullptr);
    QVERIFY(shownMessage()->words().contains("There are no scans"));
    emit wizard_->changed();  // what the rig says meanwhile does not take it away unread
    QVERIFY(shownMessage() != nullptr);
    QTest::mouseClick(shownMessage()->findChild<BigButton*>("messageAct"), Qt::LeftButton);
    QVERIFY(shownMessage() == nullptr);
    QTest::qWait(0);
    QVERIFY(!wizard_->rig()->isBusy());
    QCOMPARE(wizard_->phase(), phase);
    QCOMPARE(rig_->asked.size(), shot);
  }

  void anImportThatFailsWithoutARigIsShownToo() {
    screen_->importer()->start(folder_->filePath("absent"), ImportKind::Scans, {});
    QTRY_VERIFY(shownMessage() != nullptr);
    QTest::mouseClick(shownMessage()->findChild<BigButton*>("messageAct"), Qt::LeftButton);
    QVERIFY(shownMessage() == nullptr);
    QCOMPARE(wizard_->phase(), CapturePhase::NoRig);
  }

  void anImportSaysHowFarItIsAndCanBeStopped() {
    auto* stop = child<QPushButton>("importStop");
    auto* bar = child<QProgressBar>("importProgress");
    QVERIFY(!stop->isVisible());
    for (const char* file : {"scans/front/a.ply", "scans/back/b.ply"})
      QVERIFY(writeFileAtomically(folder_->filePath(file).toStdString(), "x").has_value());
    QSignalSpy said(screen_.get(), &Screen::said);
    BatchImporter* importer = screen_->importer();
    QSignalSpy working(screen_.get(), &Screen::working);
    importer->start(folder_->filePath("scans"), ImportKind::Scans, {});
    QVERIFY(stop->isVisible());
    QVERIFY(working.last()[0].toString().startsWith(importer->title()));
    QVERIFY(!child<QPushButton>("importPhotographsButton")->isEnabled());
    QVERIFY(!child<QAction>("importScans")->isEnabled());
    emit importer->progressed(0.25);
    QCOMPARE(bar->value(), 25);
    QTest::mouseClick(stop, Qt::LeftButton);
    QTRY_COMPARE(said.count(), 1);
    QVERIFY(said[0][0].toString().contains("cancelled"));
    QVERIFY(!stop->isVisible());
    QCOMPARE(working.last()[0].toString(), QString());
    QVERIFY(child<QPushButton>("importPhotographsButton")->isEnabled());
    QVERIFY(shownMessage() == nullptr);
    QVERIFY(catalogue::Batches(session_->project().catalogue()).all()->empty());
    QVERIFY(!QFile::exists(folder_->filePath("p/batches/import.partial")));
    importer->start(folder_->filePath("scans"), ImportKind::Scans, {});
    QVERIFY(stop->isVisible());
    QCOMPARE(bar->value(), 0);
    QTRY_COMPARE(catalogue::Batches(session_->project().catalogue()).all()->size(), std::size_t{1});
    QTRY_VERIFY(!stop->isVisible());
    QVERIFY(child<QAction>("importScans")->isEnabled());
  }

  void anImportAsksForItsBagInTheOneFieldForIt() {
    QTemporaryDir scans;
    for (const char* file : {"front/a.ply", "back/b.ply"})
      QVERIFY(writeFileAtomically(std::filesystem::path(scans.path().toStdString()) / file, file)
                  .has_value());
    auto* ask = screen_->findChild<ImportAsk*>();
    QSignalSpy imported(screen_->importer(), &BatchImporter::imported);
    auto* turntable = screen_->findChild<CaptureFoot*>()->place();
    turntable->setText("ARM1-T3-0012-4");
    ask->ask(scans.path(), ImportKind::Scans);
    QVERIFY(ask->isVisible());
    QVERIFY(turntable->isHidden());
    QVERIFY(turntable->note()->isHidden());
    auto* line = ask->place()->findChild<QLineEdit*>();
    QCOMPARE(line->text(), QString());
    QTRY_VERIFY(line->hasFocus());
    QTest::keyClicks(line, "no bag at all, never");
    QVERIFY(!ask->findChild<QPushButton*>("importStart")->isEnabled());
    QTest::keyClick(line, Qt::Key_Return);
    QVERIFY(ask->isVisible());
    line->selectAll();
    QTest::keyClicks(line, "ARM1-T3-0012-5");
    QTest::keyClick(line, Qt::Key_Return);
    QVERIFY(!ask->isVisible());
    QTRY_COMPARE(imported.count(), 1);
    const auto batch = catalogue::Batches(session_->project().catalogue())
                           .byNumber(imported[0][0].toString().toStdString());
    QCOMPARE(batch->bags.size(), std::size_t{1});
    const auto place = catalogue::placeOf(session_->project().catalogue(), batch->bags.front());
    QCOMPARE(QString::fromStdString((*place)->bag), QStringLiteral("5"));
    QVERIFY(!turntable->isHidden());
    QCOMPARE(turntable->text(), QStringLiteral("ARM1-T3-0012-4"));
    ask->ask(scans.path(), ImportKind::Scans);
    QTest::keyClick(ask, Qt::Key_Escape);
    QVERIFY(!ask->isVisible());
    QVERIFY(!turntable->isHidden());
  }

  void anotherRigIsNotToBeHadWhileThePlateIsPhotographed() {
    auto* another = child<QAction>("changeRig");
    toPlace();
    QVERIFY(another->isEnabled());
    wizard_->next();
    QVERIFY(wizard_->rig()->isBusy());
    QVERIFY(!another->isEnabled());
    QTRY_COMPARE(wizard_->phase(), CapturePhase::Flip);
    QVERIFY(another->isEnabled());
  }

  void aDoubtIsShownAndRTakesItAgain() {
    rig_->flagged = {{0, 1}};
    toPlace();
    QTest::keyClick(screen_.get(), Qt::Key_Space);
    auto* doubts = child<MessagePanel>("captureDoubts");
    QTRY_VERIFY(doubts->isVisible());
    QTest::keyClick(screen_.get(), Qt::Key_R);
    QTRY_COMPARE(wizard_->phase(), CapturePhase::Flip);
    QVERIFY(!doubts->isVisible());
  }

  void theKeysOfTheCamerasChooseTheLivePicture() {
    toPlace();
    QCOMPARE(wizard_->pictures()->camera(), 2);
    QTest::keyClick(screen_.get(), Qt::Key_A);
    QCOMPARE(wizard_->pictures()->camera(), 0);
    QTest::keyClick(screen_.get(), Qt::Key_B);
    QCOMPARE(wizard_->pictures()->camera(), 1);
  }

  void numbersTypedOnTheFrontsAreKeptWithTheBatch() {
    auto& rows = session_->project().catalogue();
    records::BatchRecord batch;
    const auto bag = bagRowOf(rows, {"ARM1", "T3", "0012", "4"}, {});
    QVERIFY(bag.has_value());
    batch.bags = {{*bag}};
    const auto row = catalogue::Batches(rows).add(batch, {});
    QVERIFY(row.has_value());
    capture::PlateInspection inspection;
    inspection.pixel_from_plate = Eigen::Matrix3d::Identity();
    inspection.sherds.resize(3);
    for (const int i : {0, 1, 2})
      inspection.sherds[static_cast<std::size_t>(i)].centre_mm = {60 * i, 5};
    SherdNumbers numbers;
    NumberEdit edit(&numbers);
    edit.show();
    auto* line = edit.findChild<QLineEdit*>("sherdNumber");
    numbers.follow(session_, "B0001", &inspection);
    QCOMPARE(numbers.count(), 3);
    QSignalSpy finished(&edit, &NumberEdit::finished);
    edit.choose(0);
    QTest::keyClicks(line, "7");
    QTest::keyClick(line, Qt::Key_Return);
    QCOMPARE(numbers.of(0), QStringLiteral("ARM1-T3-0012-0007"));
    QCOMPARE(edit.sherd(), 1);
    QTest::keyClicks(line, "7");
    QTest::keyClick(line, Qt::Key_Return);
    QCOMPARE(edit.sherd(), 1);
    QVERIFY(edit.findChild<QLabel*>("sherdNumberNote")->text().startsWith("Sherd 1 of this plate"));
    QTest::keyClick(line, Qt::Key_Down);
    QCOMPARE(edit.sherd(), 1);  // what is refused is not thrown away
    line->clear();
    QTest::keyClick(line, Qt::Key_Down);
    QTest::keyClicks(line, "OST1:S:OLD-9:7F3K9Q2M");
    QTest::keyClick(line, Qt::Key_Return);
    QCOMPARE(finished.count(), 1);
    QCOMPARE(numbers.all(), (QStringList{"ARM1-T3-0012-0007", {}, "OLD-9"}));
    // Whoever goes on without Return has typed all the same.
    edit.choose(1);
    QTest::keyClicks(line, "8");
    QTest::keyClick(line, Qt::Key_Up);
    QCOMPARE(numbers.of(1), QStringLiteral("ARM1-T3-0012-0008"));
    QCOMPARE(edit.sherd(), 0);
    QTest::keyClicks(line, "8");
    edit.choose(2);  // by a click on the plate: what is typed next is that one's
    QCOMPARE(edit.sherd(), 2);
    QCOMPARE(line->text(), QStringLiteral("OLD-9"));
    QVERIFY(edit.findChild<QLabel*>("sherdNumberNote")
                ->text()
                .startsWith("Sherd 1 got no number. Sherd 2 of this plate"));
    QTest::keyClick(line, Qt::Key_Escape);
    QCOMPARE(numbers.of(0), QStringLiteral("ARM1-T3-0012-0007"));
    edit.choose(1);
    line->clear();
    QVERIFY(edit.keepTyped());
    QCOMPARE(numbers.of(1), QString());
    QCOMPARE(finished.count(), 2);
    // The fronts are photographed again: the numbers stay where the sherds lie.
    std::swap(inspection.sherds[0], inspection.sherds[2]);
    inspection.sherds[0].centre_mm.x() += 3;
    numbers.follow(session_, "B0001", &inspection);
    QCOMPARE(numbers.all(), (QStringList{"OLD-9", {}, "ARM1-T3-0012-0007"}));
    QCOMPARE(numbers.give(0, {}), QString());
    QCOMPARE(numbers.of(0), QString());
    const auto before = catalogue::Batches(rows).add({}, {});
    QVERIFY(before.has_value());
    records::SherdRecord other;
    other.batch = *before;
    other.context = catalogue::Places(rows).contexts()->front().row;
    other.number = "OLD-8";
    const auto made = sherds::Sherds(rows).add(other, {});
    QVERIFY(made.has_value());
    QCOMPARE(numbers.give(0, "old-8"), QString());  // it waits for photographs
    QCOMPARE(numbers.give(0, {}), QString());
    QVERIFY(sherds::Sherds(rows).setModel(*made, "models/B0002/1/model.ply", "").has_value());
    QCOMPARE(numbers.give(0, "old-8"),
             QStringLiteral("A sherd of B0002 has the number old-8 already; type another."));
    // A number of another context than the bag's is kept, and doubted.
    QCOMPARE(numbers.give(1, "ARM1-T3-0099-0001"), QString());
    QVERIFY2(numbers.doubtOf(1).contains("(ARM1-T3-0012-0001)"), qPrintable(numbers.doubtOf(1)));
    QCOMPARE(numbers.give(1, "33"), QString());
    QCOMPARE(numbers.doubtOf(1), QString());
    QCOMPARE(numbers.give(1, "OLD-08"), QString());  // of a sherd that is there: OLD-8
    QVERIFY2(numbers.doubtOf(1).contains("OLD-8 only in zeros"),
             qPrintable(numbers.doubtOf(1)));
    QCOMPARE(numbers.give(1, {}), QString());
    // What no sherd has is refused, with the reason.
    for (const char* typed : {"x y/z", "no number", "12 a"})
      QVERIFY2(numbers.give(0, typed).contains("no sherd's number"), typed);
    QVERIFY(numbers.give(0, QString(60, QLatin1Char('7'))).contains("at most"));
    QCOMPARE(numbers.give(0, "AR/12:7b"), QString());
  }
};

OSTRAKA_UI_TEST(CaptureScreenTest)
#include "capture_screen_test.moc"
