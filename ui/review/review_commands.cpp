#include "ui/review/review_commands.h"

namespace ostraka::ui {
namespace {

std::filesystem::path outputOf(const PairReviewModel& model) {
  return model.isOpen() ? model.live()->output() : std::filesystem::path();
}

}  // namespace

DecideCommand::DecideCommand(PairReviewModel& model, pipeline::PairDecision decision,
                             const QString& text)
    : QUndoCommand(text),
      model_(&model),
      decision_(std::move(decision)),
      output_(outputOf(model)) {}

void DecideCommand::redo() {
  if (!model_ || outputOf(*model_) != output_) return;
  pipeline::PairDecision written = decision_;
  if (model_->write(written))
    number_ = written.number;
  else
    setObsolete(true);
}

void DecideCommand::undo() {
  if (!model_ || outputOf(*model_) != output_ || number_ == 0) return;
  pipeline::PairDecision withdrawal;
  withdrawal.kind = pipeline::DecisionKind::Withdraw;
  withdrawal.by = decision_.by;
  withdrawal.scans = decision_.scans;
  withdrawal.replaces = {number_};
  if (model_->write(withdrawal) && !decision_.scans.empty()) model_->show(decision_.scans.front());
}

TryCommand::TryCommand(PairReviewModel& model, const Trial& before, const Trial& after,
                       const QString& text, bool merge)
    : QUndoCommand(text),
      model_(&model),
      before_(before),
      after_(after),
      output_(outputOf(model)),
      merge_(merge) {}

void TryCommand::redo() {
  if (model_ && outputOf(*model_) == output_) model_->showTrial(after_);
}

void TryCommand::undo() {
  if (model_ && outputOf(*model_) == output_) model_->showTrial(before_);
}

bool TryCommand::mergeWith(const QUndoCommand* other) {
  const auto* later = static_cast<const TryCommand*>(other);
  if (later->after_.front != after_.front || later->after_.back != after_.back) return false;
  after_ = later->after_;
  return true;
}

}  // namespace ostraka::ui
