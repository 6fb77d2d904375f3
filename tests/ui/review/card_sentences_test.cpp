// What is said of a card: what is shown, what became of its back, what waits for the computation.
#include <QSignalSpy>
#include <QTest>

#include "review_model.h"

namespace ostraka::ui {

using review::CardState;

class CardSentencesTest : public ReviewModel {
  Q_OBJECT

 private slots:
  void initTestCase() { make(); }
  void init() { open(); }
  void cleanup() { close(); }
  void theSentenceIsAboutWhatIsShown();
  void aPoseThatWasGivenByHandSaysSo();
  void aFrontWhoseBackWasGivenAwayNamesItAndTakesNoOthers();
  void undoingAnAcceptShowsThePoseThatWasInHand();
  void joinedAndCutPiecesWaitForTheComputation();
};

void CardSentencesTest::theSentenceIsAboutWhatIsShown() {
  model_->select(2);
  waitForScene();
  const QString sure = model_->reason();
  QVERIFY2(sure.contains("confident"), qPrintable(sure));
  model_->chooseBack(0);
  QTRY_COMPARE(model_->trial().back, 0);
  QTRY_VERIFY2(model_->reason().startsWith("Trying back 1: under 1 %, ") &&
                   model_->reason().contains("fractures") &&
                   model_->reason().endsWith("The program says back 3, 99 %."),
               qPrintable(model_->reason()));
  model_->chooseBack(2);
  QCOMPARE(model_->reason(), sure);
  model_->moveByHand({0, 0, 0.5}, {20, 0, 0});
  QTRY_COMPARE(model_->reason(), QStringLiteral("Turned by hand: 0 % of the fractures touch."));
  undo_->undo();
  QCOMPARE(model_->reason(), sure);
  model_->stepSample(3);
  QTRY_VERIFY2(model_->reason().startsWith("Trying another start point"),
               qPrintable(model_->reason()));
}

void CardSentencesTest::aPoseThatWasGivenByHandSaysSo() {
  model_->select(2);
  model_->moveByHand({0, 0, 0.5}, {20, 0, 0});
  QTRY_COMPARE(model_->reason(), QStringLiteral("Turned by hand: 0 % of the fractures touch."));
  QSignalSpy said(model_.get(), &PairReviewModel::failed);
  model_->accept();
  QCOMPARE(cardOf(2).state, CardState::Decided);
  QCOMPARE(said.count(), 1);
  QVERIFY2(said[0][0].toString().contains("barely touch: 0 %"), qPrintable(said[0][0].toString()));
  const QString card = model_->index(model_->rowOf(2)).data(CardRole::Words).toString();
  QVERIFY2(card.startsWith("Decided by AP on") && card.contains("turned by hand"),
           qPrintable(card));
  model_->select(2);
  QTRY_VERIFY2(model_->reason().contains("barely touch"), qPrintable(model_->reason()));
  model_->accept();  // once more: the pose stands as it was given
  QCOMPARE(onDisk().back().settle, decisions::Settle::AsGiven);
  model_->select(3);
  model_->accept();
  const QString other = model_->index(model_->rowOf(3)).data(CardRole::Words).toString();
  QVERIFY2(!other.contains("by hand"), qPrintable(other));
}

void CardSentencesTest::aFrontWhoseBackWasGivenAwayNamesItAndTakesNoOthers() {
  model_->giveBack(0, 2);
  QTRY_COMPARE(model_->trial().back, 2);
  model_->accept();
  model_->select(2);
  QCOMPARE(cardOf(2).state, CardState::Alone);
  QVERIFY2(model_->reason().startsWith("Its back 3 was given to front 1"),
           qPrintable(model_->reason()));
  QVERIFY(model_->trial().back != 2);
  // Its next best is the one that nobody holds, as soon as it is compared.
  QCOMPARE(model_->review().lone_backs.size(), std::size_t{1});
  const int free = model_->review().lone_backs[0];
  QTRY_COMPARE(model_->trial().back, free);
  const QString name = QStringLiteral("back %1").arg(free + 1);
  QVERIFY2(model_->reason().endsWith("next best " + name + ", under 1 %."),
           qPrintable(model_->reason()));
  model_->accept();
  QCOMPARE(cardOf(0).back, 2);
  QCOMPARE(cardOf(0).state, CardState::Decided);
  QCOMPARE(cardOf(2).back, free);
}

void CardSentencesTest::undoingAnAcceptShowsThePoseThatWasInHand() {
  model_->select(0);
  model_->choose(1);
  model_->moveByHand({0, 0, 0.01}, {0.06, 0, 0});
  const Trial trial = model_->trial();
  model_->accept();
  QVERIFY(model_->front() != 0);
  undo_->undo();
  QCOMPARE(model_->front(), 0);
  QCOMPARE(model_->trial().back, trial.back);
  QCOMPARE(model_->trial().made, Made::ByHand);
  QVERIFY(model_->trial().front_from_back.isApprox(trial.front_from_back, 0));
  const int held = cardOf(1).back;
  model_->giveBack(1, 1 - held);  // onto another card than the one in hand
  QCOMPARE(cardOf(1).back, 1 - held);
  undo_->undo();
  QCOMPARE(model_->front(), 1);
  QCOMPARE(model_->trial().back, held);
}

void CardSentencesTest::joinedAndCutPiecesWaitForTheComputation() {
  const auto words = [this](int front) {
    const QModelIndex card = model_->index(model_->rowOf(front));
    return card.data(CardRole::StateWord).toString() + ": " + card.data(CardRole::Words).toString();
  };
  model_->select(2);
  model_->joinWith(batch::Side::Front, model_->rowOf(3));
  QVERIFY(model_->index(model_->rowOf(2)).data(CardRole::Waits).toBool());
  QVERIFY(!model_->index(model_->rowOf(0)).data(CardRole::Waits).toBool());
  QVERIFY2(words(2).startsWith("Merged: Merged with front 4 by AP"), qPrintable(words(2)));
  QVERIFY2(words(3).startsWith("Merged: Merged with front 3 by AP"), qPrintable(words(3)));
  model_->select(2);
  QCOMPARE(model_->reason(), words(2).mid(8));
  undo_->undo();
  QVERIFY(!model_->index(model_->rowOf(2)).data(CardRole::Waits).toBool());
  model_->select(1);
  model_->split(batch::Side::Front, {0, 0}, {10, 0});
  QVERIFY2(words(1).startsWith("Split: Split by AP"), qPrintable(words(1)));
  // As the computation leaves it that followed the cut.
  auto computed = openBatch(out_.output);
  QVERIFY(computed.has_value());
  computed->followed = decisions::standing(computed->decisions);
  model_->open(*computed);
  QVERIFY(!model_->index(model_->rowOf(1)).data(CardRole::Waits).toBool());
}

}  // namespace ostraka::ui

QTEST_GUILESS_MAIN(ostraka::ui::CardSentencesTest)
#include "card_sentences_test.moc"
