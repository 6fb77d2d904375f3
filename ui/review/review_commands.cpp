#include "ui/review/review_commands.h"

namespace ostraka::ui {

DecideCommand::DecideCommand(PairReviewModel& model, decisions::PairDecision decision,
                             const QString& text)
    : QUndoCommand(text),
      model_(&model),
      decision_(std::move(decision)),
      output_(model.live()->output()),
      before_(model.trial()),
      live_(model.live()) {}

// Who sits here now, not whoever decided first.
std::string DecideCommand::person() const {
  return model_->person().isEmpty() ? decision_.by : model_->person().toStdString();
}

void DecideCommand::redo() {
  if (!model_ || !written_.empty()) return;
  decision_.by = person();
  decisions::PairDecision written = decision_;
  if (model_->write(output_, written))
    written_ = written.id;
  else
    setObsolete(true);
}

void DecideCommand::undo() {
  if (!model_ || written_.empty()) return;
  decisions::PairDecision withdrawal;
  withdrawal.kind = decisions::DecisionKind::Withdraw;
  withdrawal.by = person();
  withdrawal.scans = decision_.scans;
  withdrawal.replaces = {written_};
  const Result<void> written = model_->write(output_, withdrawal);
  if (written) {
    written_.clear();
    const bool same = live_.lock() == model_->live();
    if (model_->shows(output_) && !decision_.scans.empty())
      model_->show(decision_.scans.front(), same ? before_ : Trial{});
  } else if (written.error().code == ErrorCode::CannotWrite) {
    // It holds still, and is what can be taken back once there is room again.
    QMetaObject::invokeMethod(
        model_, [model = model_.data()] { model->undo_.redo(); }, Qt::QueuedConnection);
  } else {
    setObsolete(true);
  }
}

TryCommand::TryCommand(PairReviewModel& model, const Trial& before, const Trial& after,
                       const QString& text, bool merge)
    : QUndoCommand(text),
      model_(&model),
      before_(before),
      after_(after),
      live_(model.live()),
      merge_(merge) {}

void TryCommand::redo() {
  showTrial(after_);
}

void TryCommand::undo() {
  showTrial(before_);
}

void TryCommand::showTrial(const Trial& trial) {
  const LivePairsPtr live = live_.lock();
  if (model_ && live && live == model_->live()) return model_->showTrial(trial);
  setObsolete(true);
  if (model_)
    emit model_->failed(
        PairReviewModel::tr("What was only tried is gone: its pairs were closed since."));
}

bool TryCommand::mergeWith(const QUndoCommand* other) {
  const auto* later = static_cast<const TryCommand*>(other);
  if (later->live_.lock() != live_.lock()) return false;
  if (later->after_.front != after_.front || later->after_.back != after_.back) return false;
  after_ = later->after_;
  return true;
}

}  // namespace ostraka::ui
