// What is typed on the capture screen and not yet entered when something else is done.
#include <QLabel>
#include <QLineEdit>
#include <QtTest>

#include "capture_bench.h"
#include "catalogue/label_codes.h"
#include "files/files.h"
#include "flat_rig.h"
#include "sherds/typed_numbers.h"
#include "tests/ui/program.h"
#include "ui/capture/capture_screen.h"
#include "ui/widgets/big_button.h"
#include "ui/widgets/message_panel.h"

using namespace ostraka;
using namespace ostraka::ui;
using records::BatchState;

class CaptureTypingTest : public CaptureBench {
  Q_OBJECT

 private slots:
  void init() {
    open();
    QVERIFY(bagRowOf(rows(), {"ARM1", "T3", "0012", "4"}, {}).has_value());
  }
  void cleanup() { close(); }

  void aHalfTypedBagIsNotDroppedByTryingAgain() {
    RigSource source = sourceOf(bench_->rig);
    wizard().rig()->choose(source);
    shootTheFronts();
    bench_->rig.refuse_shoot = Error{ErrorCode::Missing, "Camera B did not answer.", "rig"};
    QTest::keyClick(screen_.get(), Qt::Key_Space);
    auto* fault = child<MessagePanel>("captureFault");
    QTRY_VERIFY(fault->isVisible());
    typeHalfABag();
    const auto asked = bench_->rig.asked.size();
    QTest::mouseClick(fault->findChild<BigButton*>("messageAct"), Qt::LeftButton);
    QCOMPARE(bench_->rig.asked.size(), asked);
    QVERIFY(child<QLineEdit>("capturePlace")->hasFocus());
    QTest::keyClicks(child<QLineEdit>("capturePlace"), "ARM1-T3-0012-5");
    QTest::mouseClick(fault->findChild<BigButton*>("messageAct"), Qt::LeftButton);
    QTRY_COMPARE(bench_->batch().state, BatchState::Queued);
    QCOMPARE(bagOfTheBatch(), QStringLiteral("5"));
  }

  void aHalfTypedBagIsNotDroppedByPhotographingAgain() {
    bench_->rig.back = 8;  // of nine
    wizard().rig()->choose(sourceOf(bench_->rig));
    shootTheFronts();
    QTest::keyClick(screen_.get(), Qt::Key_Space);
    auto* doubts = child<MessagePanel>("captureDoubts");
    QTRY_VERIFY(doubts->isVisible());
    typeHalfABag();
    bench_->rig.back = 9;
    QTest::mouseClick(doubts->findChild<BigButton*>("messageAct"), Qt::LeftButton);
    QTest::qWait(0);
    QCOMPARE(bench_->batch().state, BatchState::Back);
    QCOMPARE(bagOfTheBatch(), QStringLiteral("4"));
    QTest::keyClicks(child<QLineEdit>("capturePlace"), "ARM1-T3-0012-5");
    QTest::mouseClick(doubts->findChild<BigButton*>("messageAct"), Qt::LeftButton);
    QTRY_COMPARE(bench_->batch().state, BatchState::Queued);
    QCOMPARE(bagOfTheBatch(), QStringLiteral("5"));
  }

  void aNumberThatStandsInItsLineIsKeptWhenTheProjectCloses() {
    wizard().rig()->choose(sourceWithPicture());
    shootTheFronts();
    auto* line = child<QLineEdit>("sherdNumber");
    QTRY_VERIFY(line->isVisible());
    line->setFocus();
    QTest::keyClicks(line, "7");
    const store::BatchRow batch = bench_->batch().row;
    screen_->closeProject();
    const auto typed = sherds::typedNumbers(rows(), batch);
    QVERIFY(typed.has_value());
    QCOMPARE(typed->size(), std::size_t{1});
    QCOMPARE(QString::fromStdString(typed->front().number), QStringLiteral("ARM1-T3-0012-0007"));
  }

  void numbersThatAChangedBagLeavesBehindAreToldUntilTheyAreSettled() {
    wizard().rig()->choose(sourceWithPicture());
    shootTheFronts();
    auto* line = child<QLineEdit>("sherdNumber");
    QTRY_VERIFY(line->isVisible());
    const auto type = [&](QLineEdit* into, const QString& text) {
      into->setFocus();
      into->selectAll();
      QTest::keyClicks(into, text);
      QTest::keyClick(into, Qt::Key_Return);
    };
    auto* bag = child<QLineEdit>("capturePlace");
    auto* told = child<MessagePanel>("numbersOfAnotherBag");
    type(line, "7");
    QVERIFY(!told->isVisible());
    type(bag, "ARM1-T3-0013-1");
    QVERIFY(told->isVisible());
    QVERIFY2(told->words().contains("ARM1-T3-0012-0007"), qPrintable(told->words()));
    type(bag, "ARM1-T3-0012-4");
    QVERIFY(!told->isVisible());
    type(bag, "ARM1-T3-0013-1");
    QVERIFY(told->isVisible());
    child<QAction>("numberSherds")->trigger();  // the first sherd was left behind
    QTest::keyClick(line, Qt::Key_Up);
    type(line, "7");
    QCOMPARE(
        QString::fromStdString(sherds::typedNumbers(rows(), bench_->batch().row)->front().number),
        QStringLiteral("ARM1-T3-0013-0007"));
    QVERIFY(!told->isVisible());
    type(bag, "ARM1-T3-0012-4");
    QVERIFY(told->words().contains("ARM1-T3-0013-0007"));
    QTest::mouseClick(told->findChild<BigButton*>("messageAct"), Qt::LeftButton);
    QVERIFY(!told->isVisible());
    QTest::keyClick(screen_.get(), Qt::Key_Space);
    QTRY_COMPARE(bench_->batch().state, BatchState::Queued);
    QVERIFY(!told->isVisible());
  }

 private:
  RigSource sourceWithPicture() {
    RigSource source = sourceOf(bench_->rig);
    source.open = [open = source.open](int batch, const devices::AskPerson& ask,
                                       std::stop_token stop) {
      auto devices = open(batch, ask, stop);
      if (devices) (*devices)->plate = capture::testing::flatPlate();
      return devices;
    };
    source.shoot = [shoot = source.shoot](capture::RigDevices& devices,
                                          const capture::SideOptions& options,
                                          const capture::OnCaptureEvent& told, Progress& progress,
                                          std::stop_token stop) -> Result<capture::SideSummary> {
      const auto photograph = options.batch / "front" / "cam2_pos00.jpg";
      if (const auto taken = writeFileAtomically(
              photograph, capture::testing::flatPicture({.width = 1600}, 2, 0, "front"));
          !taken)
        return taken.error();
      return shoot(devices, options, told, progress, stop);
    };
    return source;
  }
  CaptureWizard& wizard() { return bench_->wizard; }
  catalogue::Catalogue& rows() { return bench_->session.project().catalogue(); }
  void shootTheFronts() {
    QTRY_COMPARE(wizard().phase(), CapturePhase::Place);
    auto* bag = child<QLineEdit>("capturePlace");
    bag->setFocus();
    QTest::keyClicks(bag, "ARM1-T3-0012-4");
    QTest::keyClick(bag, Qt::Key_Return);
    QTest::keyClick(screen_.get(), Qt::Key_Space);
    QTRY_COMPARE(wizard().phase(), CapturePhase::Flip);
    QCOMPARE(bagOfTheBatch(), QStringLiteral("4"));
  }
  void typeHalfABag() {
    auto* bag = child<QLineEdit>("capturePlace");
    QTRY_VERIFY(bag->isEnabled());
    bag->setFocus();
    bag->selectAll();
    QTest::keyClicks(bag, "ARM1-T3-");
  }
  QString bagOfTheBatch() {
    const auto bags = bench_->batch().bags;
    if (bags.empty()) return {};
    const auto place = catalogue::placeOf(rows(), bags.front());
    return place && *place ? QString::fromStdString((*place)->bag) : QString();
  }
};

OSTRAKA_UI_TEST(CaptureTypingTest)
#include "capture_typing_test.moc"
