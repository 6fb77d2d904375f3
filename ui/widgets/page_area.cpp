#include "ui/widgets/page_area.h"

#include <QEvent>
#include <QLayout>
#include <QScrollBar>

namespace ostraka::ui {

PageArea::PageArea(QWidget* page, QWidget* parent) : QScrollArea(parent) {
  setFrameShape(QFrame::NoFrame);
  setFocusPolicy(Qt::NoFocus);
  setWidget(page);
  page->installEventFilter(this);
  fit();
}

QSize PageArea::minimumSizeHint() const {
  return {fontMetrics().height() * 8, fontMetrics().height() * 8};
}

bool PageArea::eventFilter(QObject* watched, QEvent* event) {
  if (watched == widget() && event->type() == QEvent::LayoutRequest) fit();
  return QScrollArea::eventFilter(watched, event);
}

void PageArea::resizeEvent(QResizeEvent* event) {
  QScrollArea::resizeEvent(event);
  fit();
}

void PageArea::fit() {
  QWidget* page = widget();
  if (page == nullptr) return;
  const QSize least = page->minimumSizeHint().expandedTo(page->minimumSize());
  const auto high = [&](int width) {
    const QLayout* layout = page->layout();
    return layout != nullptr && layout->hasHeightForWidth()
               ? qMax(layout->minimumHeightForWidth(width), page->minimumHeight())
               : least.height();
  };
  // A bar takes its room from the other direction.
  QSize room = maximumViewportSize();
  if (least.width() > room.width()) room.rheight() -= horizontalScrollBar()->sizeHint().height();
  if (high(qMax(room.width(), least.width())) > room.height())
    room.rwidth() -= verticalScrollBar()->sizeHint().width();
  const int width = qMax(room.width(), least.width());
  page->resize(width, qMax(room.height(), high(width)));
}

}  // namespace ostraka::ui
