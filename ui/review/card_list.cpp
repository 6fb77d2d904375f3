#include "ui/review/card_list.h"

#include <QApplication>
#include <QLabel>
#include <QMouseEvent>
#include <QPixmap>

#include "ui/pairs/card_list_model.h"
#include "ui/review/card_delegate.h"

namespace ostraka::ui {

CardList::CardList(CardListModel& cards, QWidget* parent) : QListView(parent), cards_(cards) {
  setModel(&cards);
  setItemDelegate(new CardDelegate(cards, this));
  setVerticalScrollMode(ScrollPerPixel);
  setMouseTracking(true);
  viewport()->setMouseTracking(true);
  setSelectionMode(SingleSelection);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  ghost_ = new QLabel(viewport());
  ghost_->setAttribute(Qt::WA_TransparentForMouseEvents);
  ghost_->hide();
}

void CardList::mousePressEvent(QMouseEvent* event) {
  const QPersistentModelIndex pressed(indexAt(event->pos()));
  const QRect picture = CardDelegate::backPicture(visualRect(pressed), fontMetrics());
  on_back_ = pressed.isValid() && picture.contains(event->pos());
  dragged_back_ = -1;
  QListView::mousePressEvent(event);
  const QModelIndex card = pressed;  // the cards may have moved
  if (event->button() != Qt::LeftButton || !on_back_ || !card.isValid()) return;
  pressed_ = event->pos();
  dragged_back_ = cards_.at(card.row()).back;
  const QImage image = cards_.picture(batch::Side::Back, dragged_back_);
  if (!image.isNull())
    ghost_->setPixmap(QPixmap::fromImage(
        image.scaled(picture.size(), Qt::KeepAspectRatio, Qt::SmoothTransformation)));
}

void CardList::mouseMoveEvent(QMouseEvent* event) {
  const bool dragging = dragged_back_ >= 0 && event->buttons().testFlag(Qt::LeftButton);
  if (!dragging) return QListView::mouseMoveEvent(event);
  if ((event->pos() - pressed_).manhattanLength() < QApplication::startDragDistance() &&
      !ghost_->isVisible())
    return;
  setProperty("dragging", true);
  ghost_->adjustSize();
  ghost_->move(event->pos() + QPoint(8, 8));
  ghost_->show();
  ghost_->raise();
  setCursor(Qt::ClosedHandCursor);
  viewport()->update();
}

void CardList::mouseReleaseEvent(QMouseEvent* event) {
  const bool dropped = property("dragging").toBool();
  const int back = dragged_back_;
  endDrag();
  QListView::mouseReleaseEvent(event);
  if (!dropped || back < 0) return;
  const QModelIndex card = indexAt(event->pos());
  if (!card.isValid()) return;
  const ReviewRow& row = cards_.at(card.row());
  if (!row.isLoneBack() && row.back != back) emit backDropped(row.front, back);
}

void CardList::endDrag() {
  setProperty("dragging", false);
  dragged_back_ = -1;
  ghost_->hide();
  unsetCursor();
  viewport()->update();
}

}  // namespace ostraka::ui
