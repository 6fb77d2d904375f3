// What a person does in the review, without a window.
#include "ui/pairs/pair_review.h"

#include <sys/resource.h>

#include <QSignalSpy>
#include <QTest>
#include <csignal>

#include "files/files.h"
#include "review_model.h"
#include "tests/ui/program.h"

namespace ostraka::ui {

using decisions::DecisionKind;
using review::CardState;

class PairReviewTest : public ReviewModel {
  Q_OBJECT

 private slots:
  void initTestCase() { make(); }
  void init() { open(); }
  void cleanup() { close(); }
  void theMostDoubtfulIsInHandWithItsReason();
  void anotherCandidateIsAcceptedAndTheOthersFollow();
  void whatIsDoneAgainIsComputedAlready();
  void nothingIsDecidedBeforeItIsShown();
  void nobodyDecidesNothing();
  void nothingIsDecidedInAReadOnlyProject();
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

void PairReviewTest::theMostDoubtfulIsInHandWithItsReason() {
  QCOMPARE(review_->cards().rowCount(), 4);
  QCOMPARE(review_->waiting(), 2);
  QCOMPARE(review_->hand().card()->state, CardState::Ask);
  QVERIFY2(review_->hand().reason().startsWith("Back 2 and back 1 both fit front 1"),
           qPrintable(review_->hand().reason()));
  QCOMPARE(review_->hand().chosen(), 0);
  QVERIFY(shown().whyNotAccept().isEmpty());
  QTRY_VERIFY(!review_->cards().picture(batch::Side::Front, review_->cards().at(0).front).isNull());
  const QString words = review_->cards().index(0).data(Qt::AccessibleTextRole).toString();
  QVERIFY2(words.contains("Check"), qPrintable(words));
}

void PairReviewTest::anotherCandidateIsAcceptedAndTheOthersFollow() {
  review_->select(0);
  QCOMPARE(review_->hand().trial().back, 1);
  review_->hand().choose(1);
  QCOMPARE(review_->hand().trial().back, 0);
  QCOMPARE(review_->batch().holderOf(0), 1);
  QSignalSpy decided(review_.get(), &PairReview::decided);
  shown().accept();
  QCOMPARE(decided.count(), 1);
  QCOMPARE(onDisk().size(), std::size_t{1});
  QCOMPARE(onDisk()[0].by, std::string("AP"));
  QCOMPARE(cardOf(0).back, 0);
  QCOMPARE(cardOf(0).state, CardState::Decided);
  QCOMPARE(cardOf(1).back, 1);
  QCOMPARE(review_->hand().front(), 1);  // the displaced one is on top and in hand
  QCOMPARE(review_->cards().rowOf(1), 0);
  QCOMPARE(review_->hand().reason(),
           QStringLiteral("Its back 1 was given to front 1: is back 2 the right one now?"));
  shown().accept();
  QCOMPARE(review_->waiting(), 0);
}

void PairReviewTest::whatIsDoneAgainIsComputedAlready() {
  const std::string report = *readFile(out_.output / "report.json");
  review_->select(0);
  review_->hand().choose(1);
  shown().accept();
  QVERIFY(review_->batch().wantsComputing());
  // As the computation leaves it that followed the decision.
  const std::string computed = R"({"decisions": [")" + onDisk()[0].id + R"("]})";
  QVERIFY(writeFileAtomically(out_.output / "report.json", computed).has_value());
  const auto batch = openBatch(out_.output);
  QVERIFY(batch.has_value());
  review_->open(*batch);
  QVERIFY(!review_->batch().wantsComputing());
  undo_->undo();  // of the choice of its back nothing is left to take back
  QVERIFY(review_->batch().wantsComputing());
  undo_->redo();
  QVERIFY(!review_->batch().wantsComputing());
  QVERIFY(writeFileAtomically(out_.output / "report.json", report).has_value());
}

// Of the pair before nothing is said either.
void PairReviewTest::nothingIsDecidedBeforeItIsShown() {
  review_->select(2);
  waitForScene();
  QVERIFY(review_->hand().figuresText().startsWith("Fractures "));
  QSignalSpy failed(review_.get(), &PairReview::failed);
  QSignalSpy person(review_.get(), &PairReview::personWanted);
  review_->select(3);
  QVERIFY(review_->hand().isLoading());
  QVERIFY(!review_->hand().isMeasured());
  QCOMPARE(review_->hand().figuresText(), QStringLiteral("Loading…"));
  review_->accept();
  review_->setAside();
  review_->reshoot();
  review_->joinWith(batch::Side::Front, review_->cards().rowOf(2));
  review_->split(batch::Side::Front, {0, 0}, {10, 0});
  QCOMPARE(failed.count(), 5);
  for (const auto& said : failed) QVERIFY(said[0].toString().contains("once it is shown"));
  QCOMPARE(person.count(), 0);
  QVERIFY(onDisk().empty());
  waitForScene();
  QVERIFY(review_->hand().figuresText().startsWith("Fractures "));
  review_->setAside();
  QCOMPARE(onDisk().size(), std::size_t{1});
}

void PairReviewTest::nobodyDecidesNothing() {
  review_->setPerson("  ");
  QSignalSpy failed(review_.get(), &PairReview::failed);
  shown().accept();
  shown().setAside();
  QCOMPARE(failed.count(), 2);
  QVERIFY(failed[0][0].toString().contains("initials"));
  QVERIFY(onDisk().empty());
}

void PairReviewTest::nothingIsDecidedInAReadOnlyProject() {
  review_->setPerson({});
  review_->setReadOnly("This project is read-only.");
  QSignalSpy failed(review_.get(), &PairReview::failed);
  QSignalSpy person(review_.get(), &PairReview::personWanted);
  shown().accept();
  shown().setAside();
  QCOMPARE(failed.count(), 2);
  for (const auto& said : failed) QCOMPARE(said[0].toString(), review_->whyReadOnly());
  QCOMPARE(review_->whyNotAccept(), review_->whyReadOnly());
  QCOMPARE(person.count(), 0);  // initials would not help
  QVERIFY(onDisk().empty());
}

void PairReviewTest::aBackGivenToAnotherFrontMovesTheOneThatHeldIt() {
  review_->giveBack(1, 1);
  QVERIFY2(onDisk().empty(), "how they fit is seen first");
  shown().accept();
  QCOMPARE(cardOf(1).back, 1);
  QCOMPARE(cardOf(1).state, CardState::Decided);
  QCOMPARE(cardOf(0).back, 0);
  QCOMPARE(cardOf(0).doubt, pairing::Doubt::Displaced);
  QCOMPARE(review_->hand().front(), 0);
}

void PairReviewTest::settingAsideAndShootingAgainAreDecisions() {
  review_->select(2);
  shown().setAside();
  QCOMPARE(cardOf(2).state, CardState::Aside);
  QCOMPARE(cardOf(2).decided_by, std::string("AP"));
  QCOMPARE(review_->batch().review().lone_backs, std::vector<int>{2});
  QCOMPARE(review_->waiting(), 3);  // a back that is nobody's wants a person too
  review_->select(3);
  shown().reshoot();
  QCOMPARE(cardOf(3).state, CardState::Reshoot);
  QVERIFY(review_->batch().review().lone_backs ==
          std::vector<int>{2});  // its back is shot again with it
  undo_->undo();
  undo_->undo();
  QCOMPARE(cardOf(2).state, CardState::Sure);
  QCOMPARE(review_->waiting(), 2);
}

void PairReviewTest::aTurnByHandIsOneActAndTheFracturesSettleIt() {
  review_->select(2);
  waitForScene();
  const double before = review_->hand().fit().fracture_rms_mm;
  const Eigen::Isometry3d begun = review_->hand().trial().front_from_back;
  for (int i = 0; i < 5; ++i) review_->hand().moveByHand({0, 0, 0.01}, {0.06, 0, 0});
  QCOMPARE(undo_->count(), 1);
  QCOMPARE(review_->hand().trial().made, Made::ByHand);
  QTRY_VERIFY(review_->hand().fit().fracture_rms_mm > 1.2 * before);
  review_->hand().settle();
  QTRY_COMPARE(review_->hand().trial().made, Made::Settled);
  const double off = decisions::apart_mm(
      out_.table.backs[2], review_->hand().trial().front_from_back, out_.front_from_back[2]);
  QVERIFY2(off < 0.15, qPrintable(QString::number(off)));
  undo_->undo();
  QCOMPARE(review_->hand().trial().made, Made::ByHand);
  undo_->undo();
  QVERIFY(review_->hand().trial().front_from_back.isApprox(begun));
  QVERIFY(onDisk().empty());
}

void PairReviewTest::theBackIsSeenOnItsWayAndCanBeStopped() {
  review_->select(2);
  waitForScene();
  review_->hand().moveByHand({0, 0, 0.05}, {0.6, 0.3, 0});
  const Eigen::Isometry3d by_hand = review_->hand().trial().front_from_back;
  const auto start = review_->batch().live()->measured(2, review_->hand().trial().back, by_hand);
  QVERIFY(start.has_value());
  std::vector<Eigen::Isometry3d> seen;
  std::vector<double> rms_mm;
  connect(&review_->hand(), &CardInHand::settlingAt, this,
          [&](const Eigen::Isometry3d& pose, const std::vector<double>& rms) {
            seen.push_back(pose);
            rms_mm = rms;
          });
  QSignalSpy failed(review_.get(), &PairReview::failed);
  review_->hand().settle();
  QVERIFY(review_->hand().isSettling());
  review_->hand().stopSettling();
  QTRY_VERIFY(!review_->hand().isSettling());
  QCOMPARE(failed.count(), 1);
  QVERIFY(failed[0][0].toString().startsWith("Cancelled"));
  QVERIFY(review_->hand().trial().front_from_back.isApprox(by_hand, 0));
  QCOMPARE(review_->hand().trial().made, Made::ByHand);
  QVERIFY(seen.empty());

  review_->hand().settle();
  QTRY_COMPARE(review_->hand().trial().made, Made::Settled);
  // After the coarse rounds, after the fine ones, and where it came to rest.
  QCOMPARE(seen.size(), std::size_t{3});
  QCOMPARE(rms_mm.size(), std::size_t{3});
  QVERIFY(!seen[0].isApprox(by_hand, 1e-6));
  QVERIFY(seen[2].isApprox(review_->hand().trial().front_from_back, 1e-12));
  QVERIFY(rms_mm.back() < start->fracture_rms_mm);
  disconnect(&review_->hand(), &CardInHand::settlingAt, this, nullptr);
}

void PairReviewTest::whatWasTurnedByHandStandsAsItIs() {
  review_->select(2);
  review_->hand().moveByHand({0, 0, 0.05}, {0.5, 0, 0});
  const Eigen::Isometry3d pose = review_->hand().trial().front_from_back;
  shown().accept();
  QCOMPARE(onDisk().size(), std::size_t{1});
  QCOMPARE(onDisk()[0].settle, decisions::Settle::AsGiven);
  QVERIFY(onDisk()[0].front_from_back->isApprox(pose, 1e-12));
  QVERIFY(cardOf(2).front_from_back.isApprox(pose, 1e-12));
}

void PairReviewTest::theStartPointStepsByOneSampleAndToTheNextGoodOne() {
  review_->select(2);
  QCOMPARE(review_->hand().trial().shift, 40);
  review_->hand().stepSample(1);
  QTRY_COMPARE(review_->hand().trial().shift, 41);
  QCOMPARE(review_->hand().trial().made, Made::StartPoint);
  review_->hand().stepSample(-1);
  QTRY_COMPARE(review_->hand().trial().shift, 40);
  review_->hand().stepStart(1);  // the fixture's good ones are 40 and 120
  QTRY_COMPARE(review_->hand().trial().shift, 120);
  QCOMPARE(review_->hand().trial().made, Made::Settled);
}

void PairReviewTest::threeCandidatesAreOfferedAndAnyOtherBackOnDemand() {
  review_->select(2);
  QCOMPARE(review_->hand().candidates().size(), std::size_t{1});
  QTRY_COMPARE(review_->hand().candidates().size(), std::size_t{3});
  int missing = 0;
  for (int back = 0; back < 4; ++back) {
    bool offered = false;
    for (const auto& c : review_->hand().candidates()) offered = offered || c.back == back;
    if (!offered) missing = back;
  }
  review_->hand().chooseBack(missing);
  QTRY_COMPARE(review_->hand().trial().back, missing);
  QCOMPARE(review_->hand().candidates().size(), std::size_t{4});
}

void PairReviewTest::aBackThatWasNotComparedIsShownBeforeItIsDecided() {
  int back = 0;
  while (review_->batch().table().find(3, back) != nullptr) ++back;
  QVERIFY(back < 4);
  review_->giveBack(3, back);
  QVERIFY(onDisk().empty());
  QTRY_COMPARE(review_->hand().trial().back, back);
  QCOMPARE(review_->hand().front(), 3);
  shown().accept();
  QCOMPARE(onDisk().size(), std::size_t{1});
  QCOMPARE(cardOf(3).back, back);
}

void PairReviewTest::piecesAreJoinedAndCut() {
  review_->select(2);
  shown().joinWith(batch::Side::Front, review_->cards().rowOf(3));
  QCOMPARE(onDisk().size(), std::size_t{1});
  QCOMPARE(onDisk()[0].kind, DecisionKind::Join);
  QCOMPARE(onDisk()[0].scans[1].id, std::string("f004"));
  undo_->undo();
  review_->select(2);
  // A line through the middle of the back as it is shown lies over its middle on its own plate.
  const Eigen::Vector2d middle = out_.table.fronts[2].place_mm;
  shown().split(batch::Side::Back, middle - Eigen::Vector2d(10, 0),
                middle + Eigen::Vector2d(10, 0));
  const decisions::PairDecision cut = onDisk().back();
  QCOMPARE(cut.kind, DecisionKind::Split);
  QCOMPARE(cut.scans[0].id, std::string("b003"));
  const Eigen::Vector2d centre = 0.5 * (cut.cut_mm[0] + cut.cut_mm[1]);
  QVERIFY((centre - out_.table.backs[2].place_mm).norm() < 1);
  QVERIFY(std::abs((cut.cut_mm[1] - cut.cut_mm[0]).norm() - 20) < 0.01);
}

// Whoever hears of the new batch must not be handed candidates of the one before.
void PairReviewTest::aSmallerBatchTakesThePlaceOfALargerOne() {
  waitForScene();
  review_->selectRow(review_->cards().rowCount() - 1);
  pipeline::SyntheticOptions options;
  options.sherds = 1;
  options.swapped_look_alikes = false;
  const auto small = pipeline::writeSyntheticOut(folder_.path().toStdString() + "/small", options);
  const auto batch = openBatch(small.output);
  QVERIFY(batch.has_value());
  bool all_there = true;
  const auto look = [&] {
    for (const review::ReviewCandidate& c : review_->hand().candidates())
      all_there &= c.back < static_cast<int>(review_->batch().table().backs.size());
  };
  connect(review_.get(), &PairReview::waitingChanged, this, look);
  connect(&review_->hand(), &CardInHand::candidatesChanged, this, look);
  connect(&review_->hand(), &CardInHand::cardChanged, this, look);
  review_->open(*batch);
  QVERIFY(all_there);
  QCOMPARE(review_->cards().rowCount(), 1);
  waitForScene();
  QVERIFY(all_there);
}

// The job is done and its result in the window's queue when the other batch is opened.
void PairReviewTest::whatWasOnItsWayForTheBatchBeforeIsDropped() {
  class AtOnce final : public JobRunner {
    void run(JobPriority, std::function<void()> body, std::stop_source, JobHandle*) override {
      body();
    }
  } at_once;
  const auto other =
      pipeline::writeSyntheticOut(folder_.path().toStdString() + "/other", {.noise_mm = 0.05});
  const auto before = openBatch(out_.output), after = openBatch(other.output);
  QVERIFY(before.has_value() && after.has_value());
  PairReview model(at_once, *undo_);
  std::vector<double> shown_mm;
  connect(&model.hand(), &CardInHand::sceneChanged, &model,
          [&](const auto& scene) { shown_mm.push_back(scene->fit.fracture_rms_mm); });
  QSignalSpy models(&model, &PairReview::failed);
  model.open(*before);
  model.hand().fetchModel();
  model.hand().settle();
  model.open(*after);
  QVERIFY(!model.hand().isSettling());
  const Trial trial = model.hand().trial();
  const auto fit = after->live->measured(trial.front, trial.back, trial.front_from_back);
  QTRY_VERIFY(!shown_mm.empty());
  QTest::qWait(0);
  QCOMPARE(shown_mm, std::vector<double>{fit->fracture_rms_mm});
  QCOMPARE(undo_->count(), 0);
  QCOMPARE(models.count(), 0);
  QVERIFY(model.hand().trial().front_from_back.isApprox(trial.front_from_back, 0));
}

void PairReviewTest::whatIsTakenBackStandsInTheFileOfItsBatch() {
  shown().accept();
  QCOMPARE(onDisk().size(), std::size_t{1});
  const auto other = pipeline::writeSyntheticOut(folder_.path().toStdString() + "/third", {});
  const auto batch = openBatch(other.output);
  QVERIFY(batch.has_value());
  review_->open(*batch);
  QSignalSpy decided(review_.get(), &PairReview::decided);
  undo_->undo();
  QCOMPARE(decided.count(), 1);
  QCOMPARE(onDisk().size(), std::size_t{2});
  QCOMPARE(onDisk()[1].kind, DecisionKind::Withdraw);
  QVERIFY(decisions::readDecisions(other.output)->empty());
  QCOMPARE(review_->waiting(), 2);
  undo_->redo();
  QCOMPARE(decisions::standing(onDisk()).size(), std::size_t{1});
  QVERIFY(decisions::readDecisions(other.output)->empty());
}

// The same batch after it was computed anew with fewer pieces, say.
void PairReviewTest::whatWasTriedOnOtherPairsIsNotShownOnThese() {
  review_->select(2);
  review_->hand().moveByHand({0, 0, 0.01}, {0.06, 0, 0});
  std::filesystem::remove_all(folder_.path().toStdString() + "/again");
  std::filesystem::copy(out_.output, folder_.path().toStdString() + "/kept",
                        std::filesystem::copy_options::recursive);
  const pipeline::SyntheticOptions fewer{.sherds = 1, .swapped_look_alikes = false};
  std::filesystem::remove_all(out_.output);
  pipeline::writeSyntheticOut(out_.output, fewer);
  const auto batch = openBatch(out_.output);
  QVERIFY(batch.has_value());
  review_->open(*batch);
  QSignalSpy failed(review_.get(), &PairReview::failed);
  undo_->undo();
  QCOMPARE(review_->hand().front(), 0);
  QCOMPARE(undo_->count(), 0);
  QCOMPARE(failed.count(), 1);
  shown().setAside();
  QCOMPARE(onDisk().size(), std::size_t{1});
  std::filesystem::remove_all(out_.output);
  std::filesystem::rename(folder_.path().toStdString() + "/kept", out_.output);
}

void PairReviewTest::aWithdrawalThatCannotBeWrittenIsStillToBeMade() {
  shown().accept();
  QSignalSpy failed(review_.get(), &PairReview::failed);
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

void PairReviewTest::aDamagedFileOfDecisionsIsSaidAndKept() {
  QFile file(QString::fromStdString((out_.output / "decisions.json").string()));
  QVERIFY(file.open(QIODevice::WriteOnly));
  file.write("{ half");
  file.close();
  QSignalSpy failed(review_.get(), &PairReview::failed);
  shown().accept();
  QCOMPARE(failed.count(), 1);
  QVERIFY(failed[0][0].toString().contains("decisions.json"));
  QCOMPARE(undo_->count(), 0);
  QVERIFY(file.open(QIODevice::ReadOnly));
  QCOMPARE(file.readAll(), QByteArray("{ half"));
}

OSTRAKA_UI_TEST(PairReviewTest)

}  // namespace ostraka::ui

#include "pair_review_test.moc"
