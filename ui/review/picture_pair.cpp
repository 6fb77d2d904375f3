#include "ui/review/picture_pair.h"

#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/look/look.h"
#include "ui/look/state_colours.h"

namespace ostraka::ui {
namespace {

constexpr int kStepsAcross = 40, kMostSteps = 20, kTurn_degrees = 5;

}  // namespace

PicturePair::PicturePair(QWidget* parent) : QWidget(parent) {
  setAccessibleName(tr("Photographs of both sides"));
  setMinimumHeight(fontMetrics().height() * 5);
  setPalette(mattePalette());
  setAutoFillBackground(true);
}

void PicturePair::setPictures(const QImage& front, const QImage& back,
                              const review::PictureFrame& frame) {
  front_ = front;
  back_ = back;
  frame_ = frame;
  drawing_ = loading_ = false;
  update();
}

void PicturePair::setLoading(bool loading) {
  loading_ = loading;
  update();
}

QString PicturePair::missingWords() const {
  return loading_ ? tr("Loading…") : tr("The photograph is not there.");
}

void PicturePair::setNames(const QString& front, const QString& back) {
  front_name_ = front;
  back_name_ = back;
  tellLine();
}

void PicturePair::setMirrored(bool mirrored) {
  mirrored_ = mirrored;
  update();
}

void PicturePair::setCutting(bool cutting) {
  cutting_ = cutting;
  drawing_ = false;
  line_steps_ = line_turns_ = 0;
  line_on_front_ = hasPicture(true) || !hasPicture(false);
  setCursor(cutting ? Qt::CrossCursor : Qt::ArrowCursor);
  tellLine();
}

void PicturePair::moveLine(int steps) {
  line_steps_ = std::clamp(line_steps_ + steps, -kMostSteps, kMostSteps);
  tellLine();
}

void PicturePair::turnLine(int steps) {
  line_turns_ = (line_turns_ + steps) % (360 / kTurn_degrees);
  tellLine();
}

void PicturePair::takeOtherSide() {
  if (!hasPicture(!line_on_front_)) return;
  line_on_front_ = !line_on_front_;
  tellLine();
}

void PicturePair::cutHere() {
  if (!cutting_ || !hasPicture(line_on_front_) || frame_.width == 0) return;
  const QLineF here = line();
  emit cut(line_on_front_, shown(here.p1(), line_on_front_), shown(here.p2(), line_on_front_));
}

// As long as the picture's diagonal, so that it reaches over the piece however it lies.
QLineF PicturePair::line() const {
  const QRectF where = place(line_on_front_);
  const double whole = std::hypot(where.width(), where.height());
  QLineF upright = QLineF::fromPolar(whole, 90 - kTurn_degrees * line_turns_);
  const QLineF across =
      QLineF::fromPolar(whole * line_steps_ / kStepsAcross, -kTurn_degrees * double(line_turns_));
  upright.translate(where.center() - upright.center() + across.p2());
  return upright;
}

void PicturePair::tellLine() {
  if (cutting_)
    setAccessibleDescription(
        tr("Line over the %1, %2 steps from its middle, turned by %3 degrees")
            .arg(line_on_front_ ? tr("front %1").arg(front_name_) : tr("back %1").arg(back_name_))
            .arg(line_steps_)
            .arg(kTurn_degrees * line_turns_));
  else
    setAccessibleDescription(tr("Front %1, back %2").arg(front_name_, back_name_));
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

QString PicturePair::cutWords() const {
  return tr(
      "Arrows move the line, with Shift they turn it, Up or Down takes the other side, Enter "
      "cuts. Or draw a line with the mouse.");
}

// Light on dark, so that it is seen on clay and on the plate.
void PicturePair::paintLine(QPainter& painter) const {
  const QLineF cut = drawing_ ? QLineF(from_, to_) : line();
  painter.save();
  painter.setClipRect(drawing_ ? rect() : half(line_on_front_));
  for (const auto& [ink, wide] :
       {std::pair(photographInks().halo, 5), std::pair(photographInks().lit, 2)}) {
    painter.setPen(QPen(ink, lineWidth(*this, wide)));
    painter.drawLine(cut);
  }
  painter.restore();
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
      painter.drawText(where, Qt::AlignCenter | Qt::TextWordWrap, missingWords());
    else
      painter.drawImage(place(front), image);
  };
  if (!front_name_.isEmpty()) draw(true, front_, tr("front %1").arg(front_name_));
  if (!back_name_.isEmpty())
    draw(false, flips(false) ? back_.mirrored(true, false) : back_,
         mirrored_ ? tr("back %1, mirrored").arg(back_name_) : tr("back %1").arg(back_name_));
  painter.setPen(QPen(palette().color(QPalette::Text), lineWidth(*this, 3)));
  if (cutting_) paintLine(painter);
  if (front_.isNull() && back_.isNull()) return;
  const double pixels = 10 / frame_.px_mm * scale();
  const QPointF from(line / 2, height() - line / 2);
  painter.drawLine(from, from + QPointF(pixels, 0));
  const double clear = line / 8 + painter.pen().widthF();
  painter.drawText(from + QPointF(0, -clear), tr("%1 mm").arg(QLocale().toString(10)));
}

}  // namespace ostraka::ui
