#include "ui/review/flow_row.h"

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
  int x = where.left(), y = where.top(), line = 0;
  for (QLayoutItem* item : items_) {
    if (item->isEmpty()) continue;
    const QSize size = item->sizeHint().boundedTo(QSize(where.width(), QWIDGETSIZE_MAX));
    if (x > where.left() && x + size.width() > where.left() + where.width()) {
      x = where.left();
      y += line + gap;
      line = 0;
    }
    if (place) item->setGeometry({QPoint(x, y), size});
    x += size.width() + gap;
    line = std::max(line, size.height());
  }
  return y + line - where.top();
}

}  // namespace ostraka::ui
