#include "ui/widgets/side_by_side.h"

#include <QBoxLayout>
#include <algorithm>

namespace ostraka::ui {

SideBySide::SideBySide(QWidget* parent)
    : QWidget(parent), box_(new QBoxLayout(QBoxLayout::LeftToRight, this)) {
  box_->setContentsMargins(0, 0, 0, 0);
}

void SideBySide::add(QWidget* part, int stretch) {
  box_->addWidget(part, stretch);
}

bool SideBySide::isRow() const {
  return box_->direction() == QBoxLayout::LeftToRight;
}

QSize SideBySide::minimumSizeHint() const {
  int widest = 0;
  for (int i = 0; i < box_->count(); ++i)
    widest = std::max(widest, box_->itemAt(i)->minimumSize().width());
  return {widest, box_->minimumSize().height()};
}

void SideBySide::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  int needed = box_->spacing() * (box_->count() - 1);
  for (int i = 0; i < box_->count(); ++i) needed += box_->itemAt(i)->minimumSize().width();
  const auto wanted = needed <= width() ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom;
  if (box_->direction() != wanted) box_->setDirection(wanted);
}

}  // namespace ostraka::ui
