#pragma once
#include <QObject>

#include "batch/batch.h"

class QAction;

namespace ostraka::ui {

class CardList;
class PairReview;

/// Joining two pieces of one sherd: J (fronts) or Shift+J (backs), then the other card by a click
/// or by the arrows and Enter. A click on a card's back picture means the backs. Esc leaves.
class JoinMode final : public QObject {
  Q_OBJECT

 public:
  JoinMode(PairReview& review, CardList& cards, QAction* fronts, QAction* backs, QObject* parent);

  bool isOn() const;
  QString words() const;  ///< what to do next

 public slots:
  void leave();
  void move(int by);   ///< the mark among the cards
  void take(int row);  ///< joins with this row
  void takeMarked();

 signals:
  void changed();

 private:
  void enter(QAction* chosen, QAction* other);

  PairReview& review_;
  CardList& cards_;
  QAction *fronts_, *backs_;
};

}  // namespace ostraka::ui
