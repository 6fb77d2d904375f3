#include "ui/pairs/pair_review.h"

#include <QUndoStack>
#include <algorithm>

#include "ui/jobs/when_done.h"
#include "ui/pairs/free_words.h"
#include "ui/pairs/review_commands.h"
#include "ui/words/sentence.h"

namespace ostraka::ui {
namespace {

using batch::Side;
using decisions::DecisionKind;
using decisions::PairDecision;
using review::ReviewCandidate;

}  // namespace

PairReview::PairReview(JobRunner& runner, QUndoStack& undo, QObject* parent)
    : QObject(parent),
      runner_(runner),
      undo_(undo),
      apply_(intake::applyToFileAlone),
      cards_(batch_),
      hand_(runner, undo, batch_, cards_) {
  connect(&hand_, &CardInHand::failed, this, &PairReview::failed);
  connect(&hand_, &CardInHand::sceneFetched, this, &PairReview::fetchMore);
}

void PairReview::open(OpenedBatch batch) {
  close();
  const Result<void> readable = batch_.open(std::move(batch));
  if (!readable) emit failed(sentenceOf(readable.error()));
  cards_.update();
  emit waitingChanged();
  fetchPictures();
  selectRow(0);
}

void PairReview::fetchPictures() {
  pictures_job_ = runner_.start(makeJob([live = batch_.live()](Progress&, std::stop_token stop) {
                                  return scanPictures(live, stop);
                                }),
                                this);
  whenDone<ScanPictures>(pictures_job_, this, [this](const auto& pictures) {
    if (pictures) cards_.setPictures(*pictures);  // cards without pictures still have names
  });
}

// What is on its way is dropped: the fronts and backs of the next batch are others.
void PairReview::close() {
  dropJob(pictures_job_);
  dropJob(more_job_);
  batch_.close();
  cards_.clear();
  hand_.clear();
  emit waitingChanged();
}

void PairReview::setPerson(const QString& initials) {
  person_ = initials.trimmed();
  emit personChanged();
}

QString PairReview::whyNotDecide() const {
  if (!read_only_.isEmpty()) return read_only_;
  if (person_.isEmpty()) return tr("Enter your initials first: each decision keeps its name.");
  return hand_.isLoading() ? tr("A pair can be decided once it is shown.") : QString();
}

bool PairReview::isDone() const {
  const review::ReviewCard* card = hand_.card();
  return batch_.isOpen() && waiting() == 0 && card != nullptr && !hand_.isTried() &&
         (card->state == review::CardState::Sure || card->state == review::CardState::Decided);
}

QString PairReview::whyNotAccept() const {
  if (!batch_.isOpen() || hand_.front() < 0)
    return tr("No pair is chosen: give this back to a front first.");
  if (hand_.trial().back < 0) return tr("Choose a back first.");
  const QString why_not = whyNotDecide();
  return why_not.isEmpty() && isDone() ? tr("All pairs of this batch are decided.") : why_not;
}

void PairReview::selectRow(int row) {
  if (row < 0 || row >= cards_.rowCount()) return;
  if (!cards_.at(row).isLoneBack()) return select(cards_.at(row).front);
  Trial trial;
  trial.back = cards_.at(row).back;
  hand_.hold(trial);
}

void PairReview::next() {
  selectRow(std::min(hand_.row() + 1, cards_.rowCount() - 1));
}

void PairReview::previous() {
  selectRow(std::max(hand_.row() - 1, 0));
}

void PairReview::select(int front) {
  const review::ReviewCard* card = batch_.review().ofFront(front);
  if (card != nullptr) hand_.hold(batch_.standing(*card));
}

void PairReview::show(const decisions::ScanRef& scan, const Trial& tried) {
  const bool front = scan.side == Side::Front;
  const int at = decisions::resolved(scan, front ? batch_.table().fronts : batch_.table().backs);
  const int row = front ? cards_.rowOf(at)
                        : std::max(cards_.rowOfLoneBack(at), cards_.rowOf(batch_.holderOf(at)));
  if (row >= 0 && tried.back >= 0 && cards_.at(row).isAbout(tried.front, tried.back))
    return hand_.hold(tried);
  selectRow(row);
}

PairDecision PairReview::about(DecisionKind kind) const {
  PairDecision decision;
  decision.kind = kind;
  decision.by = person_.toStdString();
  const Trial& trial = hand_.trial();
  decision.scans = {trial.front >= 0 ? batch_.front(trial.front) : batch_.back(trial.back)};
  return decision;
}

void PairReview::accept() {
  if (!isAllowed(whyNotAccept())) return;
  PairDecision decision = about(DecisionKind::Pair);
  const Trial& trial = hand_.trial();
  decision.scans.push_back(batch_.back(trial.back));
  decision.front_from_back = trial.front_from_back;
  decision.settle =
      trial.made == Made::ByHand ? decisions::Settle::AsGiven : decisions::Settle::ByFractures;
  const QString front = batch_.nameOf(hand_.trial()), back = nameOf(batch_.back(trial.back));
  const bool hardly_meets = hand_.isMeasured() && hand_.fit().hardlyMeets();
  const QString meeting = percent(hand_.fit().fracture_overlap);
  const std::size_t before = batch_.decisions().size();
  decide(decision, tr("pair %1 – %2").arg(front, back));
  if (batch_.decisions().size() > before && hardly_meets)
    emit failed(
        tr("Saved. Check %1 – %2: only %3 of their fractures touch.").arg(front, back, meeting));
}

void PairReview::setAside() {
  if (hand_.row() < 0 || !mayDecide()) return;
  decide(about(DecisionKind::Aside), tr("setting aside %1").arg(batch_.nameOf(hand_.trial())));
}

void PairReview::reshoot() {
  if (hand_.row() < 0 || !mayDecide()) return;
  PairDecision decision = about(DecisionKind::Reshoot);
  if (const review::ReviewCard* card = hand_.card(); card != nullptr && card->back >= 0)
    decision.scans.push_back(batch_.back(card->back));
  decide(decision, tr("reshooting %1").arg(batch_.nameOf(hand_.trial())));
}

void PairReview::giveBack(int front, int back) {
  if (!batch_.isOpen() || front < 0 || back < 0) return;
  select(front);
  hand_.chooseBack(back);
}

void PairReview::joinWith(Side side, int row) {
  const int mine = hand_.row();
  if (mine < 0 || row < 0 || row >= cards_.rowCount() || row == mine || !mayDecide()) return;
  const ReviewRow &one = cards_.at(mine), &other = cards_.at(row);
  PairDecision decision = about(DecisionKind::Join);
  if (side == Side::Front && !one.isLoneBack() && !other.isLoneBack()) {
    decision.scans.push_back(batch_.front(other.front));
  } else {
    if (one.back < 0 || other.back < 0)
      return emit failed(tr("One of the two has no back to merge."));
    decision.scans = {batch_.back(one.back), batch_.back(other.back)};
  }
  decide(decision,
         tr("merging %1 and %2").arg(nameOf(decision.scans[0]), nameOf(decision.scans[1])));
}

void PairReview::split(Side side, const Eigen::Vector2d& a_mm, const Eigen::Vector2d& b_mm) {
  if (hand_.row() < 0 || !mayDecide()) return;
  if ((side == Side::Back ? hand_.trial().back : hand_.trial().front) < 0) return;
  PairDecision decision = about(DecisionKind::Split);
  decision.cut_mm = {a_mm, b_mm};
  if (side == Side::Back) {
    const decisions::ScanRef back = batch_.back(hand_.trial().back);
    decision.scans = {back};
    for (Eigen::Vector2d& p : decision.cut_mm)
      if (hand_.trial().front >= 0)  // a back alone is shown as it lies on its own plate
        p = review::onBackPlate(hand_.trial().front_from_back, back, p);
  }
  decide(decision, tr("splitting %1").arg(nameOf(decision.scans[0])));
}

bool PairReview::isAllowed(const QString& why_not) {
  if (why_not.isEmpty()) return true;
  emit failed(why_not);
  if (person_.isEmpty() && read_only_.isEmpty()) emit personWanted();
  return false;
}

void PairReview::decide(PairDecision decision, const QString& text) {
  const int row = hand_.row();
  undo_.push(new DecideCommand(*this, std::move(decision), text));
  // On to what wants a person most; without any to the card that moved up to here.
  selectRow(cards_.rowCount() > 0 && cards_.at(0).wantsPerson()
                ? 0
                : std::min(row, cards_.rowCount() - 1));
}

Result<void> PairReview::write(const std::filesystem::path& output, PairDecision& decision) {
  const Result<intake::AppliedDecision> applied = apply_(output, decision);
  if (!applied) {
    emit failed(sentenceOf(applied.error()));
    return applied.error();
  }
  decision = applied->decision;
  if (batch_.isIn(output)) {
    const Result<void> readable = batch_.add(decision);
    if (!readable) emit failed(sentenceOf(readable.error()));
    cards_.update();
    emit waitingChanged();
  }
  emit decided(output, *applied);
  return {};
}

// One candidate a job, so that each is shown when it is there: for the front in hand, then for the
// others that want a person, in their order.
void PairReview::fetchMore() {
  if (!batch_.isOpen() || more_job_) return;
  int front = batch_.wantsMore(hand_.front(), true) ? hand_.front() : -1;
  for (int i = 0; front < 0 && i < cards_.rowCount(); ++i)
    if (batch_.wantsMore(cards_.at(i).front, false)) front = cards_.at(i).front;
  if (front < 0) return;
  std::vector<int> known;
  for (const ReviewCandidate& c : batch_.candidatesOf(front)) known.push_back(c.back);
  more_job_ = runner_.start(
      makeJob(
          [live = batch_.live(), front, known](Progress& progress, std::stop_token stop) {
            return anotherCandidate(live, front, known, progress, stop);
          },
          JobPriority::Background),
      this);
  whenDone<std::optional<ReviewCandidate>>(more_job_, this, [this, front](const auto& found) {
    if (found && *found)
      batch_.addCandidate(front, **found);
    else
      batch_.addNoMore(front);  // there is none; what is there stays
    if (front == hand_.front() && found && *found) {
      hand_.updateCandidates();
      // Its next best, now that there is one.
      if (hand_.trial().back < 0 && !hand_.isSettling() && batch_.standing(*hand_.card()).back >= 0)
        select(front);
    }
    fetchMore();
  });
}

}  // namespace ostraka::ui
