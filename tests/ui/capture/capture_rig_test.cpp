// Which rig is chosen, and another that is tried beside one that works.
#include <QAction>
#include <QCheckBox>
#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QtTest>

#include "capture_bench.h"
#include "catalogue/settings.h"
#include "tests/ui/program.h"
#include "ui/capture/capture_screen.h"
#include "ui/capture/rig_page.h"
#include "ui/frame/project_session.h"
#include "ui/jobs/job.h"
#include "ui/widgets/message_panel.h"
#include "ui/wizard/capture_wizard.h"
#include "ui/wizard/rig_connection.h"
#include "upkeep/project.h"

using namespace ostraka;
using namespace ostraka::ui;

class CaptureRigTest : public CaptureBench {
  Q_OBJECT

 private slots:
  void init() { open(); }
  void cleanup() { close(); }

  void aBadRigFileLeavesTheWorkingRigItsPlaceAndSaysWhy() {
    toPlace();
    const QString file = folder_->filePath("RIG.json");
    QFile bad(file);
    QVERIFY(bad.open(QIODevice::WriteOnly) && bad.write("{\"cameras\": 3}") > 0);
    bad.close();
    RigChoice choice;
    choice.kind = RigChoice::Kind::File;
    choice.file = file.toStdString();
    const std::string before = *catalogue::Settings(session_->project().catalogue()).value("rig");
    child<QAction>("changeRig")->trigger();
    QTRY_COMPARE(wizard_->phase(), CapturePhase::NoRig);
    emit screen_->findChild<RigPage*>()->chosen(choice);
    auto* failure = child<MessagePanel>("captureFailure");
    QTRY_VERIFY(failure->isVisible());
    QVERIFY2(failure->headline().contains("RIG.json"), qPrintable(failure->headline()));
    QVERIFY2(failure->words().contains("stays in use"), qPrintable(failure->words()));
    QTRY_COMPARE(wizard_->phase(), CapturePhase::Place);
    QCOMPARE(child<QLabel>("captureHeadline")->text(),
             QStringLiteral("Lay the sherds on the plate"));
    QCOMPARE(screen_->rigWords(), QStringLiteral("ready"));
    QCOMPARE(*catalogue::Settings(session_->project().catalogue()).value("rig"), before);
    QTest::mouseClick(failure->act(), Qt::LeftButton);
    QVERIFY(!failure->isVisible());
    QTest::keyClick(screen_.get(), Qt::Key_Space);
    QTRY_COMPARE(wizard_->phase(), CapturePhase::Flip);
  }

  // Its invented sherds would enter a real catalogue.
  void spaceNeverTakesTheVirtualRig() {
    auto* alike = child<QCheckBox>("virtualLookalikes");
    alike->setFocus();
    QTest::keyClick(alike, Qt::Key_Space);
    QVERIFY(alike->isChecked());
    QCOMPARE(wizard_->phase(), CapturePhase::NoRig);
    screen_->setFocus();
    QCOMPARE(screen_->primary(), child<QAbstractButton>("importPhotographsButton"));
    auto* import = child<QAction>("importPhotographs");
    import->setEnabled(false);  // its dialog would be in the way
    QTest::keyClick(screen_.get(), Qt::Key_Space);
    QCOMPARE(wizard_->phase(), CapturePhase::NoRig);
  }

  void theVirtualRigAsksOnceAndCanBeTakenAway() {
    const auto rig = [this] { return RigChoice::fromJson(session_->setting("rig")).kind; };
    auto* ask = child<MessagePanel>("virtualAsk");
    QVERIFY(!child<QWidget>("noRig")->isVisible());
    QTest::mouseClick(child<QPushButton>("useVirtualRig"), Qt::LeftButton);
    QVERIFY(ask->isVisible());
    QVERIFY2(ask->words().contains("invented"), qPrintable(ask->words()));
    QTest::mouseClick(named<QPushButton>(*ask, "messageSecondAct"), Qt::LeftButton);
    QVERIFY(!ask->isVisible());
    QCOMPARE(rig(), RigChoice::Kind::None);
    QTest::mouseClick(child<QPushButton>("useVirtualRig"), Qt::LeftButton);
    QTest::mouseClick(ask->act(), Qt::LeftButton);
    QVERIFY(wizard_->phase() != CapturePhase::NoRig);
    QCOMPARE(rig(), RigChoice::Kind::Virtual);
    child<QAction>("changeRig")->trigger();
    QTRY_COMPARE(wizard_->phase(), CapturePhase::NoRig);
    QVERIFY(!ask->isVisible());
    QTest::mouseClick(child<QPushButton>("noRig"), Qt::LeftButton);
    QCOMPARE(rig(), RigChoice::Kind::None);
    for (const char* gone : {"noRig", "keepRig"}) QVERIFY(!child<QWidget>(gone)->isVisible());
    QTest::mouseClick(child<QPushButton>("useVirtualRig"), Qt::LeftButton);
    QVERIFY2(ask->isVisible(), "it is taken anew");
  }

  // Whatever screen the person is on.
  void theStatusBarSaysThatThePlateIsPhotographed() {
    const QSignalSpy working(screen_.get(), &Screen::working);
    toPlace();
    QCOMPARE(working.count(), 0);
    QTest::keyClick(screen_.get(), Qt::Key_Space);
    QTRY_COMPARE(wizard_->phase(), CapturePhase::Flip);
    QVERIFY(working.count() > 1);
    QVERIFY2(working.front().front().toString().startsWith("Photographing the fronts"),
             qPrintable(working.front().front().toString()));
    QCOMPARE(working.back().front().toString(), QString());
  }
};

OSTRAKA_UI_TEST(CaptureRigTest)
#include "capture_rig_test.moc"
