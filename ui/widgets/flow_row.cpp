#include "ui/widgets/flow_row.h"

#include <QWidget>
#include <algorithm>
#include <memory>

namespace ostraka::ui {

FlowRow::FlowRow(QWidget* parent) : QLayout(parent) {
  setContentsMargins(0, 0, 0, 0);
}

FlowRow::~FlowRow() {
  while (count() > 0) std::unique_ptr<QLayoutItem>(takeAt(0));
}

void FlowRow::insertWidget(int index, QWidget* widget) {
  addWidget(widget);
  items_.move(count() - 1, index);
  invalidate();
}

void FlowRow::addItem(QLayoutItem* item) {
  items_.append(item);
}

QLayoutItem* FlowRow::takeAt(int index) {
  return index < 0 || index >= count() ? nullptr : items_.takeAt(index);
}

QSize FlowRow::minimumSize() const {
  QSize least;
  for (const QLayoutItem* item : items_) least = least.expandedTo(item->minimumSize());
  return least;
}

QSize FlowRow::sizeHint() const {
  QSize all;
  for (const QLayoutItem* item : items_) {
    const QSize one = item->sizeHint();
    all = QSize(all.width() + one.width() + std::max(0, spacing()),
                std::max(all.height(), one.height()));
  }
  return all;
}

void FlowRow::setGeometry(const QRect& where) {
  QLayout::setGeometry(where);
  arrange(where, true);
}

int FlowRow::arrange(const QRect& where, bool place) const {
  const int gap = std::max(0, spacing());
  int y = where.top();
  for (qsizetype begin = 0; begin < items_.size();) {
    int width = 0, height = 0;
    qsizetype end = begin;
    for (; end < items_.size(); ++end) {  // as many as the line takes, one at least
      const int wanted = width + (width > 0 ? gap : 0) + sizeOf(end, where).width();
      if (width > 0 && wanted > where.width()) break;
      width = wanted;
      height = std::max(height, sizeOf(end, where).height());
    }
    int x = where.left() + (centred_ ? std::max(0, (where.width() - width) / 2) : 0);
    for (qsizetype i = begin; place && i < end; ++i) {
      items_[i]->setGeometry({QPoint(x, y), sizeOf(i, where)});
      x += sizeOf(i, where).width() + gap;
    }
    y += height + (end < items_.size() ? gap : 0);
    begin = end;
  }
  return y - where.top();
}

QSize FlowRow::sizeOf(qsizetype item, const QRect& where) const {
  return items_[item]->isEmpty()
             ? QSize(0, 0)
             : items_[item]->sizeHint().boundedTo(QSize(where.width(), QWIDGETSIZE_MAX));
}

}  // namespace ostraka::ui
