#include "ui/pairs/review_commands.h"

#include "ui/words/sentence.h"

namespace ostraka::ui {

DecideCommand::DecideCommand(PairReview& review, decisions::PairDecision decision,
                             const QString& text)
    : QUndoCommand(text),
      review_(&review),
      decision_(std::move(decision)),
      output_(review.batch().live()->output()),
      before_(review.hand().trial()),
      live_(review.batch().live()) {}

// Who sits here now, not whoever decided first.
std::string DecideCommand::person() const {
  return review_->person().isEmpty() ? decision_.by : review_->person().toStdString();
}

Result<void> DecideCommand::checkUnchanged() {
  const auto now = decisions::replacedBy(decision_, output_);
  if (!now) return now.error();
  if (!replaced_) replaced_ = *now;
  if (!decisions::equivalent(*now, *replaced_)) return Error::changedMeanwhile("pair");
  return {};
}

void DecideCommand::redo() {
  if (!review_ || !written_.empty()) return;
  if (const Result<void> unchanged = checkUnchanged(); !unchanged) {
    emit review_->failed(sentenceOf(unchanged.error()));
    return setObsolete(true);
  }
  decision_.by = person();
  decisions::PairDecision written = decision_;
  if (review_->write(output_, written))
    written_ = written.id;
  else
    setObsolete(true);
}

void DecideCommand::undo() {
  if (!review_ || written_.empty()) return;
  decisions::PairDecision withdrawal;
  withdrawal.kind = decisions::DecisionKind::Withdraw;
  withdrawal.by = person();
  withdrawal.scans = decision_.scans;
  withdrawal.replaces = {written_};
  const Result<void> written = review_->write(output_, withdrawal);
  if (written) {
    written_.clear();
    const bool same = live_.lock() == review_->batch().live();
    if (review_->batch().isIn(output_) && !decision_.scans.empty())
      review_->show(decision_.scans.front(), same ? before_ : Trial{});
  } else if (written.error().code == ErrorCode::CannotWrite) {
    // It holds still, and is what can be taken back once there is room again.
    QMetaObject::invokeMethod(
        review_, [review = review_.data()] { review->undo_.redo(); }, Qt::QueuedConnection);
  } else {
    setObsolete(true);
  }
}

TryCommand::TryCommand(CardInHand& hand, const Trial& before, const Trial& after,
                       const QString& text, bool merge)
    : QUndoCommand(text),
      hand_(&hand),
      before_(before),
      after_(after),
      live_(hand.batch_.live()),
      merge_(merge) {}

void TryCommand::redo() {
  showTrial(after_);
}

void TryCommand::undo() {
  showTrial(before_);
}

void TryCommand::showTrial(const Trial& trial) {
  const LivePairsPtr live = live_.lock();
  if (hand_ && live && live == hand_->batch_.live()) return hand_->showTrial(trial);
  setObsolete(true);
  if (hand_)
    emit hand_->failed(CardInHand::tr("What was only tried is gone: its pairs were closed since."));
}

bool TryCommand::mergeWith(const QUndoCommand* other) {
  const auto* later = static_cast<const TryCommand*>(other);
  if (later->live_.lock() != live_.lock()) return false;
  if (later->after_.front != after_.front || later->after_.back != after_.back) return false;
  after_ = later->after_;
  return true;
}

}  // namespace ostraka::ui
