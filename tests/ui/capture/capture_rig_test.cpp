// Another rig is tried beside one that works; and what the status bar hears meanwhile.
#include <QAction>
#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QtTest>

#include "capture_bench.h"
#include "catalogue/settings.h"
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

QTEST_MAIN(CaptureRigTest)
#include "capture_rig_test.moc"
