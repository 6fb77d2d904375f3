#include "ui/widgets/elided_label.h"

#include <QPainter>
#include <QStyle>

namespace ostraka::ui {

QSize ElidedLabel::minimumSizeHint() const {
  const int whole = QLabel::minimumSizeHint().width();
  return {qMin(whole, fontMetrics().averageCharWidth() * 8), QLabel::minimumSizeHint().height()};
}

void ElidedLabel::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const QRect room = contentsRect();
  const QString shown = fontMetrics().elidedText(text(), Qt::ElideRight, room.width());
  setToolTip(shown == text() ? QString() : text());
  style()->drawItemText(&painter, room, static_cast<int>(alignment()) | Qt::AlignVCenter, palette(),
                        isEnabled(), shown, QPalette::WindowText);
}

}  // namespace ostraka::ui
