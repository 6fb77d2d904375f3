#include "ui/map/map_view.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include "ui/look/look.h"

namespace ostraka::ui {

MapView::MapView(QWidget* parent) : QWidget(parent) {
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Plate, front and back"));
  setPalette(mattePalette());
  setAutoFillBackground(true);
}

void MapView::setPicture(const MapPicture& picture) {
  picture_ = picture;
  highlighted_.clear();
  update();
}

void MapView::setNumbers(const MapNumbers& numbers) {
  picture_.numbers = numbers;
  update();
}

void MapView::setLoading(bool loading) {
  loading_ = loading;
  setAccessibleDescription(loading ? tr("Loading…") : QString());
  update();
}

void MapView::highlight(const QString& number) {
  if (number == highlighted_) return;
  highlighted_ = number;
  setAccessibleDescription(number.isEmpty() ? QString() : tr("Sherd %1").arg(number));
  update();
  emit highlightedChanged(number);
}

QRectF MapView::half(bool front) const {
  const double line = 1.4 * fontMetrics().height();
  const QRectF left(0, line, width() / 2.0 - 2, height() - line);
  return front ? left : left.translated(width() / 2.0 + 2, 0);
}

void MapView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setPen(palette().color(QPalette::Text));
  if (loading_ && picture_.map.front.width == 0)
    return painter.drawText(rect(), Qt::AlignCenter, tr("Loading…"));
  for (const bool front : {true, false}) {
    const QRectF where = half(front);
    // The word stands right above its picture.
    const review::MapSide& side = front ? picture_.map.front : picture_.map.back;
    const double line = half(front).top();
    const QRectF word(where.left(), mapPlace(where, side).top() - line, where.width(), line);
    painter.drawText(word, Qt::AlignCenter, front ? tr("front") : tr("back"));
    if (picture_.map.front.width > 0)
      paintMapSide(painter, where, side, front ? picture_.front : picture_.back, picture_.numbers,
                   highlighted_);
  }
}

QString MapView::numberAt(const QPointF& place) const {
  for (const bool front : {true, false}) {
    const review::MapSide& side = front ? picture_.map.front : picture_.map.back;
    const QRectF drawn = mapPlace(half(front), side);
    if (!drawn.contains(place) || side.width <= 0) continue;
    const QPointF pixel = (place - drawn.topLeft()) * (side.width / drawn.width());
    for (const review::MapMark& mark : side.marks) {
      QPolygonF outline;
      for (const Eigen::Vector2d& p : mark.outline) outline << QPointF(p.x(), p.y());
      if (outline.containsPoint(pixel, Qt::OddEvenFill)) return QString::fromStdString(mark.number);
    }
  }
  return {};
}

QStringList MapView::numbers() const {
  QStringList list;
  for (const review::MapMark& mark : picture_.map.front.marks)
    if (!mark.number.empty() && mark.part == 0) list << QString::fromStdString(mark.number);
  return list;
}

void MapView::mouseMoveEvent(QMouseEvent* event) {
  highlight(numberAt(event->position()));
}

void MapView::mouseDoubleClickEvent(QMouseEvent* event) {
  const QString number = numberAt(event->position());
  if (!number.isEmpty()) emit activated(number);
}

void MapView::keyPressEvent(QKeyEvent* event) {
  const QStringList all = numbers();
  const int at = static_cast<int>(all.indexOf(highlighted_));
  switch (event->key()) {
    case Qt::Key_Right:
    case Qt::Key_Down:
      if (!all.isEmpty()) highlight(all[(at + 1) % all.size()]);
      return;
    case Qt::Key_Left:
    case Qt::Key_Up:
      if (!all.isEmpty()) highlight(all[at <= 0 ? all.size() - 1 : at - 1]);
      return;
    case Qt::Key_Return:
    case Qt::Key_Enter:
      if (!highlighted_.isEmpty()) emit activated(highlighted_);
      return;
    default:
      QWidget::keyPressEvent(event);
  }
}

}  // namespace ostraka::ui
