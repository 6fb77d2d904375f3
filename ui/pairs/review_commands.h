#pragma once
#include <QPointer>
#include <QUndoCommand>

#include "ui/pairs/pair_review.h"

namespace ostraka::ui {

/// A decision; undone by a withdrawal, which is a new row behind it. Nothing is ever removed. Both
/// stand in the file of its batch, whichever is shown by then. It is done again only where the same
/// holds as before it was done first.
class DecideCommand final : public QUndoCommand {
 public:
  DecideCommand(PairReview& review, decisions::PairDecision decision, const QString& text);
  void redo() override;
  void undo() override;

 private:
  std::string person() const;
  Result<void> checkUnchanged();

  QPointer<PairReview> review_;
  decisions::PairDecision decision_;
  std::filesystem::path output_;
  Trial before_;  ///< what was in hand
  std::weak_ptr<const review::LivePairs> live_;
  std::optional<decisions::Decisions> replaced_;  ///< by it; none: not written yet
  std::string written_;  ///< id of the decision in the file; empty: taken back, or not yet there
};

/// A back or a pose that is tried; nothing is written. Drags of one hand become one act. It is over
/// when its pairs are closed: those computed next may be others.
class TryCommand final : public QUndoCommand {
 public:
  TryCommand(CardInHand& hand, const Trial& before, const Trial& after, const QString& text,
             bool merge);
  void redo() override;
  void undo() override;
  int id() const override { return merge_ ? 0x7431 : -1; }
  bool mergeWith(const QUndoCommand* other) override;

 private:
  void showTrial(const Trial& trial);

  QPointer<CardInHand> hand_;
  Trial before_, after_;
  std::weak_ptr<const review::LivePairs> live_;
  bool merge_;
};

}  // namespace ostraka::ui
