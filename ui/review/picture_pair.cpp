#include "ui/review/picture_pair.h"

#include <QLocale>
#include <QPainter>
#include <algorithm>

#include "ui/frame/look.h"
#include "ui/frame/state_colours.h"

namespace ostraka::ui {

PicturePair::PicturePair(QWidget* parent) : QWidget(parent) {
  setAccessibleName(tr("Photographs of both sides"));
  setMinimumHeight(fontMetrics().height() * 8);
}

void PicturePair::setPictures(const QImage& front, const QImage& back, double px_mm) {
  front_ = front;
  back_ = back;
  px_mm_ = px_mm;
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

void PicturePair::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  const StateColours colours(palette());
  const int line = fontMetrics().height();
  const QRect all = rect().adjusted(0, line + line / 4, 0, 0);
  const QRect left(all.left(), all.top(), all.width() / 2 - 2, all.height());
  const QRect right = left.translated(all.width() / 2 + 2, 0);
  // One scale for both: the larger picture fills its half.
  double scale = 1e9;
  for (const QImage* image : {&front_, &back_})
    if (!image->isNull())
      scale = std::min(
          {scale, left.width() / double(image->width()), left.height() / double(image->height())});
  const auto draw = [&](const QRect& where, const QImage& image, const QString& words,
                        State state) {
    painter.setPen(QPen(colours.of(state), lineWidth(*this, 3),
                        state == State::Back ? Qt::DashLine : Qt::SolidLine));
    const int y = line + line / 8;
    painter.drawLine(where.left() + 2, y, where.right() - 2, y);
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(QRect(where.left(), 0, where.width(), line), Qt::AlignCenter, words);
    if (image.isNull()) {
      painter.drawText(where, Qt::AlignCenter | Qt::TextWordWrap,
                       tr("The photograph is not there."));
      return;
    }
    QRect target(QPoint(), image.size() * scale);
    target.moveCenter(where.center());
    painter.drawImage(target, image);
  };
  draw(left, front_, tr("front %1").arg(front_name_), State::Front);
  draw(right, mirrored_ ? back_ : back_.mirrored(true, false),
       mirrored_ ? tr("back %1, mirrored").arg(back_name_) : tr("back %1").arg(back_name_),
       State::Back);
  if (front_.isNull() || !(px_mm_ > 0)) return;
  const double bar_mm = 10, pixels = bar_mm / px_mm_ * scale;
  const QPointF from(line / 2, height() - line / 2);
  painter.setPen(QPen(palette().color(QPalette::Text), lineWidth(*this, 3)));
  painter.drawLine(from, from + QPointF(pixels, 0));
  painter.drawText(from + QPointF(0, -line / 4), tr("%1 mm").arg(QLocale().toString(10)));
}

}  // namespace ostraka::ui
