// What a person does in the review, without a window.
#include "ui/review/pair_review_model.h"

#include <sys/resource.h>

#include <QSignalSpy>
#include <QTest>
#include <csignal>

#include "files/files.h"
#include "review_model.h"

namespace ostraka::ui {

using decisions::DecisionKind;
using review::CardState;

class PairReviewModelTest : public ReviewModel {
  Q_OBJECT

 private slots:
  void initTestCase() { make(); }
  void init() { open(); }
  void cleanup() { close(); }
  void theMostDoubtfulIsInHandWithItsReason();
  void anotherCandidateIsAcceptedAndTheOthersFollow();
  void undoIsAWithdrawalAndRedoADecisionAgain();
  void whoTakesADecisionBackIsNamed();
  void whatIsDoneAgainIsComputedAlready();
  void nobodyDecidesNothing();
  void aBackGivenToAnotherFrontMovesTheOneThatHeldIt();
  void settingAsideAndShootingAgainAreDecisions();
  void aTurnByHandIsOneActAndTheFracturesSettleIt();
  void theBackIsSeenOnItsWayAndCanBeStopped();
  void whatWasTurnedByHandStandsAsItIs();
  void theStartPointStepsByOneSampleAndToTheNextGoodOne();
  void threeCandidatesAreOfferedAndAnyOtherBackOnDemand();
  void aBackThatWasNotComparedIsShownBeforeItIsDecided();
  void piecesAreJoinedAndCut();
  void aSmallerBatchTakesThePlaceOfALargerOne();
  void whatWasOnItsWayForTheBatchBeforeIsDropped();
  void whatIsTakenBackStandsInTheFileOfItsBatch();
  void whatWasTriedOnOtherPairsIsNotShownOnThese();
  void aWithdrawalThatCannotBeWrittenIsStillToBeMade();
  void aDamagedFileOfDecisionsIsSaidAndKept();
};

void PairReviewModelTest::theMostDoubtfulIsInHandWithItsReason() {
  QCOMPARE(model_->rowCount(), 4);
  QCOMPARE(model_->waiting(), 2);
  QCOMPARE(model_->card()->state, CardState::Ask);
  QVERIFY2(model_->reason().startsWith("Back 2 and back 1 both fit front 1"),
           qPrintable(model_->reason()));
  QCOMPARE(model_->chosen(), 0);
  QVERIFY(model_->canAccept());
  QTRY_VERIFY(!model_->index(0).data(CardRole::FrontPicture).value<QImage>().isNull());
  const QString words = model_->index(0).data(Qt::AccessibleTextRole).toString();
  QVERIFY2(words.contains("Check"), qPrintable(words));
  waitForScene();
}

void PairReviewModelTest::anotherCandidateIsAcceptedAndTheOthersFollow() {
  model_->select(0);
  QCOMPARE(model_->trial().back, 1);
  model_->choose(1);
  QCOMPARE(model_->trial().back, 0);
  QCOMPARE(model_->holderOf(0), 1);
  QSignalSpy decided(model_.get(), &PairReviewModel::decided);
  model_->accept();
  QCOMPARE(decided.count(), 1);
  QCOMPARE(onDisk().size(), std::size_t{1});
  QCOMPARE(onDisk()[0].by, std::string("AP"));
  QCOMPARE(cardOf(0).back, 0);
  QCOMPARE(cardOf(0).state, CardState::Decided);
  QCOMPARE(cardOf(1).back, 1);
  QCOMPARE(model_->front(), 1);  // the displaced one is on top and in hand
  QCOMPARE(model_->rowOf(1), 0);
  QCOMPARE(model_->reason(),
           QStringLiteral("Its back 1 was given to front 1: is back 2 the right one now?"));
  model_->accept();
  QCOMPARE(model_->waiting(), 0);
}

void PairReviewModelTest::undoIsAWithdrawalAndRedoADecisionAgain() {
  model_->select(0);
  model_->choose(1);
  model_->accept();
  QVERIFY2(undo_->undoText().contains("front 1"), qPrintable(undo_->undoText()));
  undo_->undo();
  QCOMPARE(cardOf(0).back, 1);
  QCOMPARE(model_->front(), 0);
  QCOMPARE(onDisk().size(), std::size_t{2});
  QCOMPARE(onDisk()[1].kind, DecisionKind::Withdraw);
  undo_->redo();
  QCOMPARE(cardOf(0).back, 0);
  QCOMPARE(onDisk().size(), std::size_t{3});
  QCOMPARE(onDisk()[2].kind, DecisionKind::Pair);
}

// One decides; another sits down and takes it back.
void PairReviewModelTest::whoTakesADecisionBackIsNamed() {
  model_->accept();
  model_->setPerson("MH");
  undo_->undo();
  undo_->redo();
  model_->setPerson({});
  undo_->undo();
  QCOMPARE(onDisk().size(), std::size_t{4});
  QCOMPARE(onDisk()[0].by, std::string("AP"));
  QCOMPARE(onDisk()[1].by, std::string("MH"));
  QCOMPARE(onDisk()[2].by, std::string("MH"));
  QCOMPARE(onDisk()[3].by, std::string("MH"));  // nobody has said another name since
}

void PairReviewModelTest::whatIsDoneAgainIsComputedAlready() {
  const std::string report = *readFile(out_.output / "report.json");
  model_->select(0);
  model_->choose(1);
  model_->accept();
  QVERIFY(model_->wantsComputing());
  // As the computation leaves it that followed the decision.
  const std::string computed = R"({"decisions": [")" + onDisk()[0].id + R"("]})";
  QVERIFY(writeFileAtomically(out_.output / "report.json", computed).has_value());
  const auto batch = openBatch(out_.output);
  QVERIFY(batch.has_value());
  model_->open(*batch);
  QVERIFY(!model_->wantsComputing());
  undo_->undo();  // of the choice of its back nothing is left to take back
  QVERIFY(model_->wantsComputing());
  undo_->redo();
  QVERIFY(!model_->wantsComputing());
  QVERIFY(writeFileAtomically(out_.output / "report.json", report).has_value());
}

void PairReviewModelTest::nobodyDecidesNothing() {
  model_->setPerson("  ");
  QSignalSpy failed(model_.get(), &PairReviewModel::failed);
  model_->accept();
  model_->setAside();
  model_->giveBack(0, 0);
  QCOMPARE(failed.count(), 3);
  QVERIFY(failed[0][0].toString().contains("initials"));
  QVERIFY(onDisk().empty());
}

void PairReviewModelTest::aBackGivenToAnotherFrontMovesTheOneThatHeldIt() {
  model_->giveBack(1, 1);
  QCOMPARE(cardOf(1).back, 1);
  QCOMPARE(cardOf(1).state, CardState::Decided);
  QCOMPARE(cardOf(0).back, 0);
  QCOMPARE(cardOf(0).doubt, pairing::Doubt::Displaced);
  QCOMPARE(model_->front(), 0);
}

void PairReviewModelTest::settingAsideAndShootingAgainAreDecisions() {
  model_->select(2);
  model_->setAside();
  QCOMPARE(cardOf(2).state, CardState::Aside);
  QCOMPARE(cardOf(2).decided_by, std::string("AP"));
  QCOMPARE(model_->review().lone_backs, std::vector<int>{2});
  QCOMPARE(model_->waiting(), 3);  // a back that is nobody's wants a person too
  model_->select(3);
  model_->reshoot();
  QCOMPARE(cardOf(3).state, CardState::Reshoot);
  QVERIFY(model_->review().lone_backs == std::vector<int>{2});  // its back is shot again with it
  undo_->undo();
  undo_->undo();
  QCOMPARE(cardOf(2).state, CardState::Sure);
  QCOMPARE(model_->waiting(), 2);
}

void PairReviewModelTest::aTurnByHandIsOneActAndTheFracturesSettleIt() {
  model_->select(2);
  waitForScene();
  const double before = model_->fit().fracture_rms_mm;
  const Eigen::Isometry3d begun = model_->trial().front_from_back;
  for (int i = 0; i < 5; ++i) model_->moveByHand({0, 0, 0.01}, {0.06, 0, 0});
  QCOMPARE(undo_->count(), 1);
  QCOMPARE(model_->trial().made, Made::ByHand);
  QTRY_VERIFY(model_->fit().fracture_rms_mm > 1.2 * before);
  model_->settle();
  QTRY_COMPARE(model_->trial().made, Made::Settled);
  const double off = decisions::apart_mm(out_.table.backs[2], model_->trial().front_from_back,
                                         out_.front_from_back[2]);
  QVERIFY2(off < 0.15, qPrintable(QString::number(off)));
  undo_->undo();
  QCOMPARE(model_->trial().made, Made::ByHand);
  undo_->undo();
  QVERIFY(model_->trial().front_from_back.isApprox(begun));
  QVERIFY(onDisk().empty());
}

void PairReviewModelTest::theBackIsSeenOnItsWayAndCanBeStopped() {
  model_->select(2);
  waitForScene();
  model_->moveByHand({0, 0, 0.05}, {0.6, 0.3, 0});
  const Eigen::Isometry3d by_hand = model_->trial().front_from_back;
  const auto start = model_->live()->measured(2, model_->trial().back, by_hand);
  QVERIFY(start.has_value());
  std::vector<Eigen::Isometry3d> seen;
  connect(model_.get(), &PairReviewModel::settlingAt, this,
          [&](const Eigen::Isometry3d& pose) { seen.push_back(pose); });
  QSignalSpy failed(model_.get(), &PairReviewModel::failed);
  model_->settle();
  QVERIFY(model_->isSettling());
  model_->stopSettling();
  QTRY_VERIFY(!model_->isSettling());
  QCOMPARE(failed.count(), 1);
  QVERIFY(failed[0][0].toString().startsWith("Cancelled"));
  QVERIFY(model_->trial().front_from_back.isApprox(by_hand, 0));
  QCOMPARE(model_->trial().made, Made::ByHand);
  QVERIFY(seen.empty());

  model_->settle();
  QTRY_COMPARE(model_->trial().made, Made::Settled);
  // After the coarse rounds, after the fine ones, and where it came to rest.
  QCOMPARE(seen.size(), std::size_t{3});
  QCOMPARE(model_->settlingRms().size(), std::size_t{3});
  QVERIFY(!seen[0].isApprox(by_hand, 1e-6));
  QVERIFY(seen[2].isApprox(model_->trial().front_from_back, 1e-12));
  QVERIFY(model_->settlingRms().back() < start->fracture_rms_mm);
  disconnect(model_.get(), &PairReviewModel::settlingAt, this, nullptr);
}

void PairReviewModelTest::whatWasTurnedByHandStandsAsItIs() {
  model_->select(2);
  model_->moveByHand({0, 0, 0.05}, {0.5, 0, 0});
  const Eigen::Isometry3d pose = model_->trial().front_from_back;
  model_->accept();
  QCOMPARE(onDisk().size(), std::size_t{1});
  QCOMPARE(onDisk()[0].settle, decisions::Settle::AsGiven);
  QVERIFY(onDisk()[0].front_from_back->isApprox(pose, 1e-12));
  QVERIFY(cardOf(2).front_from_back.isApprox(pose, 1e-12));
}

void PairReviewModelTest::theStartPointStepsByOneSampleAndToTheNextGoodOne() {
  model_->select(2);
  QCOMPARE(model_->trial().shift, 40);
  model_->stepSample(1);
  QTRY_COMPARE(model_->trial().shift, 41);
  QCOMPARE(model_->trial().made, Made::StartPoint);
  model_->stepSample(-1);
  QTRY_COMPARE(model_->trial().shift, 40);
  model_->stepStart(1);  // the fixture's good ones are 40 and 120
  QTRY_COMPARE(model_->trial().shift, 120);
  QCOMPARE(model_->trial().made, Made::Settled);
}

void PairReviewModelTest::threeCandidatesAreOfferedAndAnyOtherBackOnDemand() {
  model_->select(2);
  QCOMPARE(model_->candidates().size(), std::size_t{1});
  QTRY_COMPARE(model_->candidates().size(), std::size_t{3});
  int missing = 0;
  for (int back = 0; back < 4; ++back) {
    bool offered = false;
    for (const auto& c : model_->candidates()) offered = offered || c.back == back;
    if (!offered) missing = back;
  }
  model_->chooseBack(missing);
  QTRY_COMPARE(model_->trial().back, missing);
  QCOMPARE(model_->candidates().size(), std::size_t{4});
}

void PairReviewModelTest::aBackThatWasNotComparedIsShownBeforeItIsDecided() {
  int back = 0;
  while (model_->live()->table().find(3, back) != nullptr) ++back;
  QVERIFY(back < 4);
  model_->giveBack(3, back);
  QVERIFY(onDisk().empty());
  QTRY_COMPARE(model_->trial().back, back);
  QCOMPARE(model_->front(), 3);
  model_->accept();
  QCOMPARE(onDisk().size(), std::size_t{1});
  QCOMPARE(cardOf(3).back, back);
}

void PairReviewModelTest::piecesAreJoinedAndCut() {
  model_->select(2);
  model_->joinWith(batch::Side::Front, model_->rowOf(3));
  QCOMPARE(onDisk().size(), std::size_t{1});
  QCOMPARE(onDisk()[0].kind, DecisionKind::Join);
  QCOMPARE(onDisk()[0].scans[1].id, std::string("f004"));
  undo_->undo();
  model_->select(2);
  // A line through the middle of the back as it is shown lies over its middle on its own plate.
  const Eigen::Vector2d middle = out_.table.fronts[2].place_mm;
  model_->split(batch::Side::Back, middle - Eigen::Vector2d(10, 0),
                middle + Eigen::Vector2d(10, 0));
  const decisions::PairDecision cut = onDisk().back();
  QCOMPARE(cut.kind, DecisionKind::Split);
  QCOMPARE(cut.scans[0].id, std::string("b003"));
  const Eigen::Vector2d centre = 0.5 * (cut.cut_mm[0] + cut.cut_mm[1]);
  QVERIFY((centre - out_.table.backs[2].place_mm).norm() < 1);
  QVERIFY(std::abs((cut.cut_mm[1] - cut.cut_mm[0]).norm() - 20) < 0.01);
}

// Whoever hears of the new batch must not be handed candidates of the one before.
void PairReviewModelTest::aSmallerBatchTakesThePlaceOfALargerOne() {
  waitForScene();
  model_->selectRow(model_->rowCount() - 1);
  pipeline::SyntheticOptions options;
  options.sherds = 1;
  options.swapped_look_alikes = false;
  const auto small = pipeline::writeSyntheticOut(folder_.path().toStdString() + "/small", options);
  const auto batch = openBatch(small.output);
  QVERIFY(batch.has_value());
  bool all_there = true;
  const auto look = [&] {
    for (const review::ReviewCandidate& c : model_->candidates())
      all_there &= c.back < static_cast<int>(model_->live()->table().backs.size());
  };
  connect(model_.get(), &PairReviewModel::waitingChanged, this, look);
  connect(model_.get(), &PairReviewModel::candidatesChanged, this, look);
  connect(model_.get(), &PairReviewModel::cardChanged, this, look);
  model_->open(*batch);
  QVERIFY(all_there);
  QCOMPARE(model_->rowCount(), 1);
  waitForScene();
  QVERIFY(all_there);
}

// The job is done and its result in the window's queue when the other batch is opened.
void PairReviewModelTest::whatWasOnItsWayForTheBatchBeforeIsDropped() {
  class AtOnce final : public JobRunner {
    void run(JobPriority, std::function<void()> body, std::stop_source, JobHandle*) override {
      body();
    }
  } at_once;
  const auto other =
      pipeline::writeSyntheticOut(folder_.path().toStdString() + "/other", {.noise_mm = 0.05});
  const auto before = openBatch(out_.output), after = openBatch(other.output);
  QVERIFY(before.has_value() && after.has_value());
  PairReviewModel model(at_once, *undo_);
  std::vector<double> shown_mm;
  connect(&model, &PairReviewModel::sceneChanged, &model,
          [&](const auto& scene) { shown_mm.push_back(scene->fit.fracture_rms_mm); });
  QSignalSpy models(&model, &PairReviewModel::failed);
  model.open(*before);
  model.fetchModel();
  model.settle();
  model.open(*after);
  QVERIFY(!model.isSettling());
  const Trial trial = model.trial();
  const auto fit = after->live->measured(trial.front, trial.back, trial.front_from_back);
  QTRY_VERIFY(!shown_mm.empty());
  QTest::qWait(0);
  QCOMPARE(shown_mm, std::vector<double>{fit->fracture_rms_mm});
  QCOMPARE(undo_->count(), 0);
  QCOMPARE(models.count(), 0);
  QVERIFY(model.trial().front_from_back.isApprox(trial.front_from_back, 0));
}

void PairReviewModelTest::whatIsTakenBackStandsInTheFileOfItsBatch() {
  model_->accept();
  QCOMPARE(onDisk().size(), std::size_t{1});
  const auto other = pipeline::writeSyntheticOut(folder_.path().toStdString() + "/third", {});
  const auto batch = openBatch(other.output);
  QVERIFY(batch.has_value());
  model_->open(*batch);
  QSignalSpy decided(model_.get(), &PairReviewModel::decided);
  undo_->undo();
  QCOMPARE(decided.count(), 1);
  QCOMPARE(onDisk().size(), std::size_t{2});
  QCOMPARE(onDisk()[1].kind, DecisionKind::Withdraw);
  QVERIFY(decisions::readDecisions(other.output)->empty());
  QCOMPARE(model_->waiting(), 2);
  undo_->redo();
  QCOMPARE(decisions::standing(onDisk()).size(), std::size_t{1});
  QVERIFY(decisions::readDecisions(other.output)->empty());
}

// The same batch after it was computed anew with fewer pieces, say.
void PairReviewModelTest::whatWasTriedOnOtherPairsIsNotShownOnThese() {
  model_->select(2);
  model_->moveByHand({0, 0, 0.01}, {0.06, 0, 0});
  std::filesystem::remove_all(folder_.path().toStdString() + "/again");
  std::filesystem::copy(out_.output, folder_.path().toStdString() + "/kept",
                        std::filesystem::copy_options::recursive);
  const pipeline::SyntheticOptions fewer{.sherds = 1, .swapped_look_alikes = false};
  std::filesystem::remove_all(out_.output);
  pipeline::writeSyntheticOut(out_.output, fewer);
  const auto batch = openBatch(out_.output);
  QVERIFY(batch.has_value());
  model_->open(*batch);
  QSignalSpy failed(model_.get(), &PairReviewModel::failed);
  undo_->undo();
  QCOMPARE(model_->front(), 0);
  QCOMPARE(undo_->count(), 0);
  QCOMPARE(failed.count(), 1);
  model_->accept();
  QCOMPARE(onDisk().size(), std::size_t{1});
  std::filesystem::remove_all(out_.output);
  std::filesystem::rename(folder_.path().toStdString() + "/kept", out_.output);
}

void PairReviewModelTest::aWithdrawalThatCannotBeWrittenIsStillToBeMade() {
  model_->accept();
  QSignalSpy failed(model_.get(), &PairReviewModel::failed);
  // A limit on file sizes fails a write as a full disk does.
  struct rlimit before {};
  QCOMPARE(getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  struct rlimit full = before;
  full.rlim_cur = 16;
  QCOMPARE(setrlimit(RLIMIT_FSIZE, &full), 0);
  undo_->undo();
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, old_handler);
  QCOMPARE(failed.count(), 1);
  QTRY_VERIFY(undo_->canUndo());
  QCOMPARE(onDisk().size(), std::size_t{1});
  undo_->undo();
  QCOMPARE(onDisk().size(), std::size_t{2});
  QVERIFY(decisions::standing(onDisk()).empty());
  QVERIFY(undo_->canRedo());
}

void PairReviewModelTest::aDamagedFileOfDecisionsIsSaidAndKept() {
  QFile file(QString::fromStdString((out_.output / "decisions.json").string()));
  QVERIFY(file.open(QIODevice::WriteOnly));
  file.write("{ half");
  file.close();
  QSignalSpy failed(model_.get(), &PairReviewModel::failed);
  model_->accept();
  QCOMPARE(failed.count(), 1);
  QVERIFY(failed[0][0].toString().contains("decisions.json"));
  QCOMPARE(undo_->count(), 0);
  QVERIFY(file.open(QIODevice::ReadOnly));
  QCOMPARE(file.readAll(), QByteArray("{ half"));
}

}  // namespace ostraka::ui

QTEST_GUILESS_MAIN(ostraka::ui::PairReviewModelTest)
#include "pair_review_model_test.moc"
