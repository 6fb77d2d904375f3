#pragma once
#include <QObject>
#include <QPointer>
#include <QString>
#include <filesystem>

#include "ui/pairs/card_in_hand.h"

namespace ostraka::ui {

/// The review of one batch without a window: the batch, its cards as rows, the card in hand, and
/// the decisions about it. Every act goes through the undo stack.
class PairReview final : public QObject {
  Q_OBJECT

 public:
  /// Both outlive the review.
  PairReview(JobRunner& runner, QUndoStack& undo, QObject* parent = nullptr);

  void open(OpenedBatch batch);
  void close();
  void setPerson(const QString& initials);
  const QString& person() const { return person_; }
  /// why: a sentence; empty where decisions can be written.
  void setReadOnly(const QString& why) { read_only_ = why; }
  const QString& whyReadOnly() const { return read_only_; }
  void setApply(ApplyDecision apply) { apply_ = std::move(apply); }  ///< unset: the file alone

  const ReviewedBatch& batch() const { return batch_; }
  CardListModel& cards() { return cards_; }
  CardInHand& hand() { return hand_; }
  QString whyNotAccept() const;  ///< empty when the pair in hand can be accepted
  int waiting() const { return batch_.review().waiting(); }
  /// No pair wants a person, and what is shown stands as it is: there is nothing to accept.
  bool isDone() const;

 public slots:
  void select(int front);
  void selectRow(int row);
  void next();
  void previous();
  void accept();
  void setAside();
  void reshoot();
  /// A back dragged onto a front: tries it there. How they fit is seen before it is decided.
  void giveBack(int front, int back);
  /// The pieces of the row in hand and of this one are one sherd's: its fronts or its backs (those
  /// where one of the two is a lone back). The pairs have to be computed again.
  void joinWith(batch::Side side, int row);
  /// The side in hand is two pieces, cut along a line as the picture shows it (front's frame, mm).
  void split(batch::Side side, const Eigen::Vector2d& a_mm, const Eigen::Vector2d& b_mm);

 signals:
  /// Is on disk. Taken back or done again, it may be another batch's than the one that is shown.
  void decided(const std::filesystem::path& output, const ostraka::intake::AppliedDecision& taken);
  void failed(const QString& sentence);
  void personChanged();
  void personWanted();  ///< a decision was refused, for nobody has said who decides
  void waitingChanged();

 private:
  friend class DecideCommand;
  Result<void> write(const std::filesystem::path& output, decisions::PairDecision& decision);
  void show(const decisions::ScanRef& scan, const Trial& tried);  ///< as tried, if it is of its row
  void decide(decisions::PairDecision decision, const QString& text);
  decisions::PairDecision about(decisions::DecisionKind kind) const;  ///< the card in hand
  /// Of all decisions alike: only what is shown is decided, and only with a name.
  QString whyNotDecide() const;
  bool mayDecide() { return isAllowed(whyNotDecide()); }
  bool isAllowed(const QString& why_not);  ///< or says why not
  void fetchPictures();
  void fetchMore();

  JobRunner& runner_;
  QUndoStack& undo_;
  QString person_, read_only_;
  ApplyDecision apply_;
  ReviewedBatch batch_;
  CardListModel cards_;
  CardInHand hand_;
  QPointer<JobHandle> pictures_job_, more_job_;
};

}  // namespace ostraka::ui
