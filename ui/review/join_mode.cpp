#include "ui/review/join_mode.h"

#include <QAction>
#include <QItemSelectionModel>
#include <QSignalBlocker>
#include <algorithm>

#include "ui/review/card_list.h"
#include "ui/review/pair_review_model.h"

namespace ostraka::ui {

JoinMode::JoinMode(PairReviewModel& model, CardList& cards, QAction* fronts, QAction* backs,
                   QObject* parent)
    : QObject(parent), model_(model), cards_(cards), fronts_(fronts), backs_(backs) {
  connect(fronts_, &QAction::toggled, this, [this] { enter(fronts_, backs_); });
  connect(backs_, &QAction::toggled, this, [this] { enter(backs_, fronts_); });
}

bool JoinMode::isOn() const {
  return fronts_->isChecked() || backs_->isChecked();
}

QString JoinMode::words() const {
  const QString name = model_.index(std::max(model_.rowInHand(), 0)).data().toString();
  const bool backs = backs_->isChecked() || model_.card() == nullptr;  // it has no front
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
  const int row = std::clamp(cards_.currentIndex().row() + by, 0, model_.rowCount() - 1);
  QItemSelectionModel* selection = cards_.selectionModel();
  const QSignalBlocker still(selection);  // only a mark: the card in hand stays
  selection->setCurrentIndex(model_.index(row), QItemSelectionModel::ClearAndSelect);
  cards_.scrollTo(model_.index(row));
  cards_.viewport()->update();
}

void JoinMode::take(int row) {
  const bool backs = backs_->isChecked() || cards_.pressedOnBack();
  leave();
  model_.joinWith(backs ? batch::Side::Back : batch::Side::Front, row);
}

void JoinMode::takeMarked() {
  const bool backs = backs_->isChecked();
  const int row = cards_.currentIndex().row();
  leave();
  model_.joinWith(backs ? batch::Side::Back : batch::Side::Front, row);
}

}  // namespace ostraka::ui
