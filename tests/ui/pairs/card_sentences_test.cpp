// What is said of a card: what is shown, what became of its back, what waits for the computation.
#include <QSignalSpy>
#include <QTest>

#include "review_model.h"
#include "tests/ui/program.h"

namespace ostraka::ui {

using review::CardState;

class CardSentencesTest : public ReviewModel {
  Q_OBJECT

 private slots:
  void initTestCase() { make(); }
  void init() { open(); }
  void cleanup() { close(); }
  void theSentenceIsAboutWhatIsShown();
  void aPairingWithoutProbabilityClaimsNone();
  void aLikelyPairSaysWhyItIsAskedAbout();
  void aPoseThatWasGivenByHandSaysSo();
  void aFrontWhoseBackWasGivenAwayNamesItAndTakesNoOthers();
  void undoingAnAcceptShowsThePoseThatWasInHand();
  void joinedAndCutPiecesWaitForTheComputation();
};

void CardSentencesTest::theSentenceIsAboutWhatIsShown() {
  review_->select(2);
  waitForScene();
  const QString sure = review_->hand().reason();
  QVERIFY2(sure.contains("confident"), qPrintable(sure));
  review_->hand().chooseBack(0);
  QTRY_COMPARE(review_->hand().trial().back, 0);
  QTRY_VERIFY2(review_->hand().reason().startsWith("Trying back 1: under 1 %, ") &&
                   review_->hand().reason().contains("fractures") &&
                   review_->hand().reason().endsWith("The program says back 3, 99 %."),
               qPrintable(review_->hand().reason()));
  review_->hand().chooseBack(2);
  QCOMPARE(review_->hand().reason(), sure);
  review_->hand().moveByHand({0, 0, 0.5}, {20, 0, 0});
  QTRY_COMPARE(review_->hand().reason(),
               QStringLiteral("Turned by hand: 0 % of the fractures touch."));
  undo_->undo();
  QCOMPARE(review_->hand().reason(), sure);
  review_->hand().stepSample(3);
  QTRY_VERIFY2(review_->hand().reason().startsWith("Trying another start point"),
               qPrintable(review_->hand().reason()));
}

void CardSentencesTest::aPairingWithoutProbabilityClaimsNone() {
  review::ReviewCard card;
  card.score = std::nullopt;
  card.back = 0;
  QCOMPARE(doubtSentence(card, out_.table, {}),
           QStringLiteral("The nearest outline; no probability is known."));
  card.state = review::CardState::Ask;
  card.doubt = pairing::Doubt::SharedBack;
  QCOMPARE(doubtSentence(card, out_.table, {}),
           QStringLiteral("Another front takes the same back."));
  QCOMPARE(scoreWords(std::nullopt), QStringLiteral("no probability"));
}

void CardSentencesTest::aLikelyPairSaysWhyItIsAskedAbout() {
  review::ReviewCard card;
  card.score = 0.982;
  card.back = 0;
  card.state = review::CardState::Ask;
  card.doubt = pairing::Doubt::NotSure;
  QCOMPARE(doubtSentence(card, out_.table, {}),
           QStringLiteral("98 % confident; below 99 %, a person decides."));
}

void CardSentencesTest::aPoseThatWasGivenByHandSaysSo() {
  review_->select(2);
  review_->hand().moveByHand({0, 0, 0.5}, {20, 0, 0});
  QTRY_COMPARE(review_->hand().reason(),
               QStringLiteral("Turned by hand: 0 % of the fractures touch."));
  QSignalSpy said(review_.get(), &PairReview::failed);
  shown().accept();
  QCOMPARE(cardOf(2).state, CardState::Decided);
  QCOMPARE(said.count(), 1);
  QVERIFY2(said[0][0].toString().contains("only 0 % of their fractures"),
           qPrintable(said[0][0].toString()));
  const QString card =
      review_->cards().index(review_->cards().rowOf(2)).data(Qt::ToolTipRole).toString();
  QVERIFY2(card.startsWith("Decided by AP on") && card.contains("turned by hand"),
           qPrintable(card));
  review_->select(2);
  QTRY_VERIFY2(review_->hand().reason().contains("Only 0 % of the fractures"),
               qPrintable(review_->hand().reason()));
  shown().accept();  // once more: the pose stands as it was given
  QCOMPARE(onDisk().back().settle, decisions::Settle::AsGiven);
  review_->select(3);
  shown().accept();
  const QString other =
      review_->cards().index(review_->cards().rowOf(3)).data(Qt::ToolTipRole).toString();
  QVERIFY2(!other.contains("by hand"), qPrintable(other));
}

void CardSentencesTest::aFrontWhoseBackWasGivenAwayNamesItAndTakesNoOthers() {
  review_->giveBack(0, 2);
  QTRY_COMPARE(review_->hand().trial().back, 2);
  shown().accept();
  review_->select(2);
  QCOMPARE(cardOf(2).state, CardState::Alone);
  QVERIFY2(review_->hand().reason().startsWith("Its back 3 was given to front 1"),
           qPrintable(review_->hand().reason()));
  QVERIFY(review_->hand().trial().back != 2);
  // Its next best is the one that nobody holds, as soon as it is compared.
  QCOMPARE(review_->batch().review().lone_backs.size(), std::size_t{1});
  const int free = review_->batch().review().lone_backs[0];
  QTRY_COMPARE(review_->hand().trial().back, free);
  const QString name = QStringLiteral("back %1").arg(free + 1);
  QVERIFY2(review_->hand().reason().endsWith("next best " + name + ", under 1 %."),
           qPrintable(review_->hand().reason()));
  shown().accept();
  QCOMPARE(cardOf(0).back, 2);
  QCOMPARE(cardOf(0).state, CardState::Decided);
  QCOMPARE(cardOf(2).back, free);
}

void CardSentencesTest::undoingAnAcceptShowsThePoseThatWasInHand() {
  review_->select(0);
  review_->hand().choose(1);
  review_->hand().moveByHand({0, 0, 0.01}, {0.06, 0, 0});
  const Trial trial = review_->hand().trial();
  shown().accept();
  QVERIFY(review_->hand().front() != 0);
  undo_->undo();
  QCOMPARE(review_->hand().front(), 0);
  QCOMPARE(review_->hand().trial().back, trial.back);
  QCOMPARE(review_->hand().trial().made, Made::ByHand);
  QVERIFY(review_->hand().trial().front_from_back.isApprox(trial.front_from_back, 0));
  const int held = cardOf(1).back;
  review_->giveBack(1, 1 - held);  // onto another card than the one in hand
  shown().accept();
  QCOMPARE(cardOf(1).back, 1 - held);
  undo_->undo();
  QCOMPARE(review_->hand().front(), 1);
  QCOMPARE(cardOf(1).back, held);
}

void CardSentencesTest::joinedAndCutPiecesWaitForTheComputation() {
  const auto words = [this](int front) {
    const QModelIndex card = review_->cards().index(review_->cards().rowOf(front));
    return rowWord(review_->cards().at(card.row())) + ": " + card.data(Qt::ToolTipRole).toString();
  };
  const auto waits = [this](int front) {
    return review_->cards().at(review_->cards().rowOf(front)).change != PieceChange::None;
  };
  review_->select(2);
  shown().joinWith(batch::Side::Front, review_->cards().rowOf(3));
  QVERIFY(waits(2));
  QVERIFY(!waits(0));
  QVERIFY2(words(2).startsWith("Merged: Merged with front 4 by AP"), qPrintable(words(2)));
  QVERIFY2(words(3).startsWith("Merged: Merged with front 3 by AP"), qPrintable(words(3)));
  review_->select(2);
  QCOMPARE(review_->hand().reason(), words(2).mid(8));
  undo_->undo();
  QVERIFY(!waits(2));
  review_->select(1);
  shown().split(batch::Side::Front, {0, 0}, {10, 0});
  QVERIFY2(words(1).startsWith("Split: Split by AP"), qPrintable(words(1)));
  // As the computation leaves it that followed the cut.
  auto computed = openBatch(out_.output);
  QVERIFY(computed.has_value());
  computed->followed = decisions::standing(computed->decisions);
  review_->open(*computed);
  QVERIFY(!waits(1));
}

OSTRAKA_UI_TEST(CardSentencesTest)

}  // namespace ostraka::ui

#include "card_sentences_test.moc"
