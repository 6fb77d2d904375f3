// What undo and redo do with decisions.
#include <QSignalSpy>
#include <QTest>

#include "review_model.h"
#include "tests/ui/program.h"

namespace ostraka::ui {

using decisions::DecisionKind;

class UndoneDecisionsTest : public ReviewModel {
  Q_OBJECT

 private slots:
  void initTestCase() { make(); }
  void init() { open(); }
  void cleanup() { close(); }
  void undoIsAWithdrawalAndRedoADecisionAgain();
  void whoTakesADecisionBackIsNamed();
  void whatAnotherDecidedSinceIsNeitherUndoneNorRedone();
};

void UndoneDecisionsTest::undoIsAWithdrawalAndRedoADecisionAgain() {
  review_->select(0);
  review_->hand().choose(1);
  shown().accept();
  QVERIFY2(undo_->undoText().contains("front 1"), qPrintable(undo_->undoText()));
  undo_->undo();
  QCOMPARE(cardOf(0).back, 1);
  QCOMPARE(review_->hand().front(), 0);
  QCOMPARE(onDisk().size(), std::size_t{2});
  QCOMPARE(onDisk()[1].kind, DecisionKind::Withdraw);
  undo_->redo();
  QCOMPARE(cardOf(0).back, 0);
  QCOMPARE(onDisk().size(), std::size_t{3});
  QCOMPARE(onDisk()[2].kind, DecisionKind::Pair);
}

// One decides; another sits down and takes it back.
void UndoneDecisionsTest::whoTakesADecisionBackIsNamed() {
  shown().accept();
  review_->setPerson("MH");
  undo_->undo();
  undo_->redo();
  review_->setPerson({});
  undo_->undo();
  QCOMPARE(onDisk().size(), std::size_t{4});
  QCOMPARE(onDisk()[0].by, std::string("AP"));
  QCOMPARE(onDisk()[1].by, std::string("MH"));
  QCOMPARE(onDisk()[2].by, std::string("MH"));
  QCOMPARE(onDisk()[3].by, std::string("MH"));  // nobody has said another name since
}

// In another window, or by a merge.
void UndoneDecisionsTest::whatAnotherDecidedSinceIsNeitherUndoneNorRedone() {
  decisions::PairDecision aside;
  aside.kind = DecisionKind::Aside;
  aside.by = "MH";
  aside.scans = {review_->batch().front(0)};
  review_->select(0);
  review_->hand().choose(1);
  shown().accept();
  undo_->undo();
  QVERIFY(decisions::appendDecision(out_.output, aside).has_value());
  QSignalSpy failed(review_.get(), &PairReview::failed);
  undo_->redo();
  QCOMPARE(failed.count(), 1);
  QCOMPARE(failed[0][0].toString(),
           QStringLiteral("The field pair was changed meanwhile; nothing was undone or redone."));
  QVERIFY(!undo_->canRedo());
  QCOMPARE(onDisk().size(), std::size_t{3});
  QCOMPARE(decisions::standing(onDisk())[0].by, std::string("MH"));

  undo_->clear();
  shown().accept();  // a decision, which may replace what stands
  QVERIFY(decisions::appendDecision(out_.output, aside).has_value());
  failed.clear();
  undo_->undo();
  QCOMPARE(failed.count(), 1);
  QVERIFY(!undo_->canUndo() && !undo_->canRedo());
  QCOMPARE(decisions::standing(onDisk()).back().by, std::string("MH"));
}

OSTRAKA_UI_TEST(UndoneDecisionsTest)

}  // namespace ostraka::ui

#include "undone_decisions_test.moc"
