#include "ui/review/picture_pair.h"

#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>

#include "ui/frame/look.h"
#include "ui/frame/state_colours.h"

namespace ostraka::ui {

PicturePair::PicturePair(QWidget* parent) : QWidget(parent) {
  setAccessibleName(tr("Photographs of both sides"));
  setMinimumHeight(fontMetrics().height() * 8);
}

void PicturePair::setPictures(const QImage& front, const QImage& back,
                              const pipeline::PictureFrame& frame) {
  front_ = front;
  back_ = back;
  frame_ = frame;
  drawing_ = false;
  update();
}

void PicturePair::setNames(const QString& front, const QString& back) {
  front_name_ = front;
  back_name_ = back;
  setAccessibleDescription(tr("Front %1, back %2").arg(front, back));
  update();
}

void PicturePair::setMirrored(bool mirrored) {
  mirrored_ = mirrored;
  update();
}

void PicturePair::setCutting(bool cutting) {
  cutting_ = cutting;
  drawing_ = false;
  setCursor(cutting ? Qt::CrossCursor : Qt::ArrowCursor);
  update();
}

QRect PicturePair::half(bool front) const {
  const int line = fontMetrics().height(), top = line + line / 4;
  const QRect left(0, top, width() / 2 - 2, height() - top);
  return front ? left : left.translated(width() / 2 + 2, 0);
}

// One scale for both: the larger picture fills its half.
double PicturePair::scale() const {
  double most = 1e9;
  for (const QImage* image : {&front_, &back_})
    if (!image->isNull())
      most = std::min({most, half(true).width() / double(image->width()),
                       half(true).height() / double(image->height())});
  return most;
}

QRectF PicturePair::place(bool front) const {
  const QImage& image = front ? front_ : back_;
  QRectF target(QPointF(), QSizeF(image.size()) * scale());
  target.moveCenter(QRectF(half(front)).center());
  return target;
}

// Whether a picture is drawn the other way round than it came.
bool PicturePair::flips(bool front) const {
  const bool as_seen = front_name_.isEmpty();  // a back alone
  return !front && (as_seen ? mirrored_ : !mirrored_);
}

Eigen::Vector2d PicturePair::shown(const QPointF& at, bool front) const {
  const QPointF pixel = (at - place(front).topLeft()) / scale();
  const double column = flips(front) ? frame_.width - pixel.x() : pixel.x();
  return frame_.at(column - 0.5, pixel.y() - 0.5);
}

void PicturePair::mousePressEvent(QMouseEvent* event) {
  if (!cutting_ || event->button() != Qt::LeftButton) return QWidget::mousePressEvent(event);
  drawing_ = true;
  from_ = to_ = event->position();
}

void PicturePair::mouseMoveEvent(QMouseEvent* event) {
  if (!drawing_) return QWidget::mouseMoveEvent(event);
  to_ = event->position();
  update();
}

void PicturePair::mouseReleaseEvent(QMouseEvent* event) {
  if (!drawing_) return QWidget::mouseReleaseEvent(event);
  drawing_ = false;
  to_ = event->position();
  update();
  const bool front = from_.x() < width() / 2.0;
  if ((to_ - from_).manhattanLength() < fontMetrics().height() || frame_.width == 0) return;
  emit cut(front, shown(from_, front), shown(to_, front));
}

void PicturePair::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  const StateColours colours(palette());
  const int line = fontMetrics().height();
  const auto draw = [&](bool front, const QImage& image, const QString& words) {
    const QRect where = half(front);
    painter.setPen(QPen(colours.of(front ? State::Front : State::Back), lineWidth(*this, 3),
                        front ? Qt::SolidLine : Qt::DashLine));
    const int y = line + line / 8;
    painter.drawLine(where.left() + 2, y, where.right() - 2, y);
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(QRect(where.left(), 0, where.width(), line), Qt::AlignCenter, words);
    if (image.isNull())
      painter.drawText(where, Qt::AlignCenter | Qt::TextWordWrap,
                       tr("The photograph is not there."));
    else
      painter.drawImage(place(front), image);
  };
  if (!front_name_.isEmpty()) draw(true, front_, tr("front %1").arg(front_name_));
  if (!back_name_.isEmpty())
    draw(false, flips(false) ? back_.mirrored(true, false) : back_,
         mirrored_ ? tr("back %1, mirrored").arg(back_name_) : tr("back %1").arg(back_name_));
  painter.setPen(QPen(palette().color(QPalette::Text), lineWidth(*this, 3)));
  if (drawing_) painter.drawLine(from_, to_);
  if (cutting_)
    painter.drawText(rect().adjusted(0, 0, 0, -line / 4), Qt::AlignHCenter | Qt::AlignBottom,
                     tr("Draw a line over the piece where it is to be cut."));
  if (front_.isNull() && back_.isNull()) return;
  const double pixels = 10 / frame_.px_mm * scale();
  const QPointF from(line / 2, height() - line / 2);
  painter.drawLine(from, from + QPointF(pixels, 0));
  painter.drawText(from + QPointF(0, -line / 4), tr("%1 mm").arg(QLocale().toString(10)));
}

}  // namespace ostraka::ui
