// One batch after the other in the review: what is decided belongs to the batch whose pairs it is
// about.
#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QTest>
#include <fstream>

#include "catalogue/batches.h"
#include "files/files.h"
#include "intake/batch_figures.h"
#include "review_window.h"
#include "sherds/pair_decisions.h"
#include "tests/ui/program.h"
#include "ui/queue/batch_queue.h"
#include "ui/viewport/sherd_view.h"

namespace ostraka::ui {

class TwoBatchesTest : public ReviewWindow {
  Q_OBJECT

 private slots:
  void cleanup() { close(); }
  void theNameIsAskedForUntilItIsThere();
  void nothingIsDecidedWhileAnotherBatchOpens();
  void aBatchThatDoesNotOpenLeavesNoPairsToDecideOn();
  void nothingWaitsWhereTheProjectIsClosed();
  void aBatchThatIsBeingComputedIsNotOpened();
  void theBatchThatWaitsIsShownWhereTheOtherOneDoesNot();
  void aDecisionOnAnotherBatchIsTakenBackThere();
  void twoBatchesTakenBackAtOnceBothWantAPersonAgain();
  void enterInTheListOfBatchesOnlyChooses();
  void joiningAndCuttingEndWithTheBatch();
  void whatTheCatalogueMissedIsEnteredWhenTheBatchIsOpened();

 private:
  pipeline::SyntheticOut addBatch(const std::string& number);
  std::size_t entered(const std::string& number);
  QString shown() {
    if (!review()->batch().isOpen()) return {};
    return QString::fromStdString(review()->batch().live()->output().filename().string());
  }
};

pipeline::SyntheticOut TwoBatchesTest::addBatch(const std::string& number) {
  auto out = pipeline::writeSyntheticOut(session_->folder() / "results" / number, {});
  enterBatch(session_->project(), 4, number);
  session_->tellBatchChanged(QString::fromStdString(number));
  return out;
}

// Decisions on pairs that the catalogue holds of a batch.
std::size_t TwoBatchesTest::entered(const std::string& number) {
  catalogue::Catalogue& rows = session_->project().catalogue();
  return sherds::PairDecisions(rows).all(catalogue::Batches(rows).byNumber(number)->row)->size();
}

// The window asks for it at the first Enter, see open().
void TwoBatchesTest::theNameIsAskedForUntilItIsThere() {
  open(4, true);
  const auto* message = screen_->findChild<QLabel*>("message");
  QVERIFY2(message->text().isEmpty(), qPrintable(message->text()));
}

void TwoBatchesTest::nothingIsDecidedWhileAnotherBatchOpens() {
  open(4, true);
  const pipeline::SyntheticOut second = addBatch("B0002");
  QCOMPARE(shown(), QStringLiteral("B0001"));
  screen_->showItem("B0002");
  key(Qt::Key_Return);  // the card that was there a moment ago
  QTRY_COMPARE(shown(), QStringLiteral("B0002"));
  QVERIFY(standingOnDisk().empty());
  QVERIFY(decisions::readDecisions(second.output)->empty());
  QCOMPARE(entered("B0001") + entered("B0002"), std::size_t{0});
  key(Qt::Key_Return);
  QTRY_COMPARE(decisions::readDecisions(second.output)->size(), std::size_t{1});
  QCOMPARE(entered("B0002"), std::size_t{1});
  QCOMPARE(entered("B0001"), std::size_t{0});
}

// The sidebar would show the questions of one project in the next.
void TwoBatchesTest::nothingWaitsWhereTheProjectIsClosed() {
  open(4, true);
  QVERIFY(screen_->waiting() > 0);
  int waiting = -1;
  connect(screen_, &Screen::waitingChanged, this, [&] { waiting = screen_->waiting(); });
  screen_->closeProject();
  QCOMPARE(waiting, 0);
}

void TwoBatchesTest::aBatchThatDoesNotOpenLeavesNoPairsToDecideOn() {
  open(4, true);
  const pipeline::SyntheticOut second = addBatch("B0002");
  std::ofstream(second.output / "work" / "pairs" / "candidates.json") << "{ half";
  screen_->showItem("B0002");
  auto* message = screen_->findChild<QLabel*>("message");
  QTRY_VERIFY2(message->text().contains("candidates.json"), qPrintable(message->text()));
  QVERIFY(!review()->batch().isOpen());
  key(Qt::Key_Return);
  QVERIFY(standingOnDisk().empty());
  QCOMPARE(entered("B0001") + entered("B0002"), std::size_t{0});
}

// Its scans may be new while its table is the old one, and its cards would show others' sherds.
void TwoBatchesTest::aBatchThatIsBeingComputedIsNotOpened() {
  open(4, true);
  const pipeline::SyntheticOut second = addBatch("B0002");
  const std::filesystem::path report = second.output / "report.json";
  const std::string bytes = *readFile(report);
  std::filesystem::remove(report);
  screen_->showItem("B0002");
  auto* message = screen_->findChild<QLabel*>("message");
  QTRY_VERIFY2(message->text().contains("not fully processed"), qPrintable(message->text()));
  QVERIFY(!review()->batch().isOpen());
  key(Qt::Key_Return);
  QCOMPARE(entered("B0001") + entered("B0002"), std::size_t{0});
  QVERIFY(writeFileAtomically(report, bytes));
  session_->tellBatchChanged("B0002");
  QTRY_COMPARE(shown(), QStringLiteral("B0002"));
}

// Who comes to the screen comes for what waits.
void TwoBatchesTest::theBatchThatWaitsIsShownWhereTheOtherOneDoesNot() {
  open(4, true);
  addBatch("B0002");
  intake::BatchFigures figures;
  figures.sherds = 4;
  figures.ask = 1;
  QVERIFY(intake::keepFigures(session_->project().catalogue(), "B0002", figures).has_value());
  session_->tellBatchChanged("B0002");
  QVERIFY(review()->waiting() > 0);
  screen_->takeChosen({});
  QCOMPARE(shown(), QStringLiteral("B0001"));  // it waits as well
  for (int waiting = review()->waiting(); waiting > 0; waiting = review()->waiting()) {
    key(Qt::Key_Return);
    QTRY_VERIFY(review()->waiting() < waiting);
  }
  auto* message = screen_->findChild<QLabel*>("message");
  QTRY_VERIFY(message->text().startsWith("Saved."));
  screen_->setInFront(false);
  QVERIFY(message->text().isEmpty());
  screen_->takeChosen({});
  QTRY_VERIFY2(shown() == QStringLiteral("B0002"), qPrintable(message->text()));
}

void TwoBatchesTest::aDecisionOnAnotherBatchIsTakenBackThere() {
  open(4, true);
  BatchQueue queue;
  queue.setSession(session_.get());
  key(Qt::Key_Return);
  QTRY_COMPARE(entered("B0001"), std::size_t{1});
  const pipeline::SyntheticOut second = addBatch("B0002");
  screen_->showItem("B0002");
  QTRY_COMPARE(shown(), QStringLiteral("B0002"));
  QTRY_VERIFY(review()->hand().fit().fracture_rms_mm > 0);
  key(Qt::Key_2);
  QTRY_COMPARE(review()->hand().chosen(), 1);
  key(Qt::Key_Return);
  QTRY_COMPARE(entered("B0002"), std::size_t{1});
  screen_->showItem("B0001");
  QTRY_COMPARE(shown(), QStringLiteral("B0001"));
  // What is taken back is shown, for it is not what one is looking at.
  key(Qt::Key_Z, Qt::ControlModifier);
  QTRY_COMPARE(shown(), QStringLiteral("B0002"));
  QVERIFY(decisions::standing(*decisions::readDecisions(second.output)).empty());
  QCOMPARE(standingOnDisk().size(), std::size_t{1});
  QCOMPARE(entered("B0002"), std::size_t{2});
  QCOMPARE(entered("B0001"), std::size_t{1});
  QTRY_COMPARE(queue.row(queue.rowOf("B0002")).figures->decided, 0);
  QCOMPARE(queue.row(queue.rowOf("B0001")).figures->decided, 1);
  // Of the choice nothing is left to take back; then comes the decision before it.
  key(Qt::Key_Z, Qt::ControlModifier);
  QCOMPARE(shown(), QStringLiteral("B0002"));
  QVERIFY(standingOnDisk().size() == 1);
  key(Qt::Key_Z, Qt::ControlModifier);
  QTRY_COMPARE(shown(), QStringLiteral("B0001"));
  QVERIFY(standingOnDisk().empty());
  QCOMPARE(entered("B0001"), std::size_t{2});
  queue.setSession(nullptr);
}

// The second act opens another batch before the first one was read.
void TwoBatchesTest::twoBatchesTakenBackAtOnceBothWantAPersonAgain() {
  open(4, true);
  const pipeline::SyntheticOut second = addBatch("B0002");
  const auto decided = [this](const char* number) {
    return intake::keptFigures(session_->project().catalogue(), number)
        .value_or(intake::BatchFigures{})
        .decided;
  };
  for (const char* number : {"B0001", "B0002"}) {
    screen_->showItem(number);
    QTRY_COMPARE(shown(), QString(number));
    key(Qt::Key_Return);
    QTRY_COMPARE(decided(number), 1);
  }
  const pipeline::SyntheticOut third = addBatch("B0003");
  screen_->showItem("B0003");
  QTRY_COMPARE(shown(), QStringLiteral("B0003"));
  session_->undo().undo();
  session_->undo().undo();
  QTRY_COMPARE(decided("B0001"), 0);
  QTRY_COMPARE(decided("B0002"), 0);
}

// As keys come from a keyboard: to the window that has them, and past every shortcut.
void TwoBatchesTest::enterInTheListOfBatchesOnlyChooses() {
  open(4, true);
  const pipeline::SyntheticOut second = addBatch("B0002");
  auto* batches = screen_->findChild<QComboBox*>("batch");
  QCOMPARE(batches->count(), 2);
  QTest::mouseClick(batches, Qt::LeftButton);
  QTRY_VERIFY(QApplication::activePopupWidget() != nullptr);
  QTest::keyClick(window_->windowHandle(), Qt::Key_Up);
  QTest::keyClick(window_->windowHandle(), Qt::Key_Return);
  QTRY_COMPARE(shown(), QStringLiteral("B0002"));
  QVERIFY(standingOnDisk().empty());
  QVERIFY(decisions::readDecisions(second.output)->empty());
  auto* message = screen_->findChild<QLabel*>("message");
  QVERIFY2(message->text().isEmpty(), qPrintable(message->text()));
  batches->setFocus(Qt::TabFocusReason);  // the list is closed: there is nothing to choose
  QTest::keyClick(window_->windowHandle(), Qt::Key_Return);
  QVERIFY(standingOnDisk().empty() && decisions::readDecisions(second.output)->empty());
}

// Enter means another thing in each of them.
void TwoBatchesTest::joiningAndCuttingEndWithTheBatch() {
  open(4, true);
  const pipeline::SyntheticOut second = addBatch("B0002");
  const auto isOn = [this](const char* mode) {
    return screen_->findChild<QAction*>(mode)->isChecked();
  };
  key(Qt::Key_K);
  QVERIFY(isOn("cut"));
  screen_->showItem("B0002");
  QTRY_COMPARE(shown(), QStringLiteral("B0002"));
  QVERIFY(!isOn("cut"));
  key(Qt::Key_J);
  QVERIFY(isOn("join"));
  session_->tellBatchChanged("B0002");  // nothing of it is new
  QVERIFY(isOn("join"));
  screen_->showItem("B0001");
  QTRY_COMPARE(shown(), QStringLiteral("B0001"));
  QVERIFY(!isOn("join"));
  key(Qt::Key_Return);
  QTRY_COMPARE(standingOnDisk().size(), std::size_t{1});
  QCOMPARE(standingOnDisk()[0].kind, decisions::DecisionKind::Pair);
}

// The program ended between decisions.json and the catalogue, at the last two questions.
void TwoBatchesTest::whatTheCatalogueMissedIsEnteredWhenTheBatchIsOpened() {
  open(4, true);
  BatchQueue queue;
  queue.setSession(session_.get());
  for (const review::ReviewCard& card : review()->batch().review().cards) {
    if (card.state != review::CardState::Ask) continue;
    decisions::PairDecision confirmed;
    confirmed.by = "AP";
    confirmed.scans = {out_.table.fronts.at(static_cast<std::size_t>(card.front)),
                       out_.table.backs.at(static_cast<std::size_t>(card.back))};
    confirmed.front_from_back = card.front_from_back;
    QVERIFY(decisions::appendDecision(out_.output, confirmed).has_value());
  }
  QCOMPARE(entered("B0001"), std::size_t{0});
  screen_->showItem("B0001");
  QTRY_COMPARE(entered("B0001"), std::size_t{2});
  QTRY_COMPARE(batchState(), records::BatchState::Done);
  QCOMPARE(queue.row(0).state, QueueState::Done);
  QCOMPARE(queue.row(0).figures->decided, 2);
  queue.setSession(nullptr);
}

OSTRAKA_UI_TEST(TwoBatchesTest)

}  // namespace ostraka::ui

#include "records/records.h"
#include "two_batches_test.moc"
