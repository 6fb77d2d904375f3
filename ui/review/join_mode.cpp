#include "ui/review/join_mode.h"

#include <QAction>
#include <QItemSelectionModel>
#include <QSignalBlocker>
#include <algorithm>

#include "ui/pairs/pair_review.h"
#include "ui/review/card_list.h"

namespace ostraka::ui {

JoinMode::JoinMode(PairReview& review, CardList& cards, QAction* fronts, QAction* backs,
                   QObject* parent)
    : QObject(parent), review_(review), cards_(cards), fronts_(fronts), backs_(backs) {
  connect(fronts_, &QAction::toggled, this, [this] { enter(fronts_, backs_); });
  connect(backs_, &QAction::toggled, this, [this] { enter(backs_, fronts_); });
}

bool JoinMode::isOn() const {
  return fronts_->isChecked() || backs_->isChecked();
}

QString JoinMode::words() const {
  const QString name = review_.cards().index(std::max(review_.hand().row(), 0)).data().toString();
  const bool backs = backs_->isChecked() || review_.hand().card() == nullptr;  // it has no front
  return backs ? tr("Which back belongs to the one of %1? Choose its card (arrows and Enter).")
                     .arg(name)
               : tr("Which front belongs to the one of %1? Choose its card (arrows and Enter); a "
                    "click on a back's picture joins the backs.")
                     .arg(name);
}

void JoinMode::enter(QAction* chosen, QAction* other) {
  if (chosen->isChecked()) other->setChecked(false);
  emit changed();
}

void JoinMode::leave() {
  fronts_->setChecked(false);
  backs_->setChecked(false);
}

void JoinMode::move(int by) {
  const int row = std::clamp(cards_.currentIndex().row() + by, 0, review_.cards().rowCount() - 1);
  QItemSelectionModel* selection = cards_.selectionModel();
  const QSignalBlocker still(selection);  // only a mark: the card in hand stays
  selection->setCurrentIndex(review_.cards().index(row), QItemSelectionModel::ClearAndSelect);
  cards_.scrollTo(review_.cards().index(row));
  cards_.viewport()->update();
}

void JoinMode::take(int row) {
  const bool backs = backs_->isChecked() || cards_.pressedOnBack();
  leave();
  review_.joinWith(backs ? batch::Side::Back : batch::Side::Front, row);
}

void JoinMode::takeMarked() {
  const bool backs = backs_->isChecked();
  const int row = cards_.currentIndex().row();
  leave();
  review_.joinWith(backs ? batch::Side::Back : batch::Side::Front, row);
}

}  // namespace ostraka::ui
