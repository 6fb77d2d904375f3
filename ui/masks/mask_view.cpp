#include "ui/masks/mask_view.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "ui/look/look.h"

namespace ostraka::ui {
namespace {

constexpr double kMostZoom = 32, kStep = 1.25;

bool movesTheBrush(int key) {
  return key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Up || key == Qt::Key_Down ||
         key == Qt::Key_Space;
}

}  // namespace

MaskView::MaskView(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setAccessibleName(tr("Photograph with its mask"));
  setAccessibleDescription(
      tr("The arrows move the brush, Space paints, plus and minus enlarge and reduce."));
  setPalette(mattePalette());
}

QSize MaskView::sizeHint() const {
  return {fontMetrics().height() * 28, fontMetrics().height() * 16};
}

void MaskView::setPicture(const QImage& photograph, const QString& otherwise) {
  const bool other_size = photograph.size() != size_;
  photograph_ = photograph;
  otherwise_ = otherwise;
  path_.clear();
  if (photograph.isNull()) overlay_ = {};
  if (other_size && !photograph.isNull()) {
    size_ = photograph.size();
    showWhole();
    brush_ = middle_;
  }
  update();
}

void MaskView::setOverlay(const QImage& overlay) {
  overlay_ = overlay;
  update();
}

void MaskView::setBrush(double radius_px, bool paints_sherd) {
  radius_px_ = radius_px;
  paints_sherd_ = paints_sherd;
  update();
}

void MaskView::showWhole() {
  zoom_ = 1;
  middle_ = QPointF(photograph_.width(), photograph_.height()) / 2;
  update();
}

double MaskView::scale() const {
  if (photograph_.isNull()) return 1;
  return zoom_ * std::min(static_cast<double>(width()) / photograph_.width(),
                          static_cast<double>(height()) / photograph_.height());
}

// A pixel's middle has integer coordinates, as everywhere in the program.
QPointF MaskView::placeOf(const QPointF& pixel) const {
  return QPointF(width(), height()) / 2 + (pixel + QPointF(0.5, 0.5) - middle_) * scale();
}

QPointF MaskView::pixelAt(const QPointF& place) const {
  return middle_ - QPointF(0.5, 0.5) + (place - QPointF(width(), height()) / 2) / scale();
}

void MaskView::keepWithin() {
  middle_.setX(std::clamp(middle_.x(), 0.0, static_cast<double>(photograph_.width())));
  middle_.setY(std::clamp(middle_.y(), 0.0, static_cast<double>(photograph_.height())));
  update();
}

void MaskView::enlargeAbout(const QPointF& place, double factor) {
  if (photograph_.isNull()) return;
  const QPointF held = pixelAt(place);
  zoom_ = std::clamp(zoom_ * factor, 1.0, kMostZoom);
  middle_ += held - pixelAt(place);
  if (zoom_ == 1) return showWhole();
  keepWithin();
}

void MaskView::enlarge(double factor) {
  enlargeAbout(brush_ ? placeOf(*brush_) : QPointF(width(), height()) / 2, factor);
}

bool MaskView::event(QEvent* event) {
  // The keys of the brush are no shortcuts of the screen around.
  if (event->type() == QEvent::ShortcutOverride &&
      movesTheBrush(static_cast<QKeyEvent*>(event)->key())) {
    event->accept();
    return true;
  }
  return QWidget::event(event);
}

void MaskView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().color(QPalette::Base));
  if (photograph_.isNull()) {
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.setFont(scaledFont(*this, Look::kSection, true));
    painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap, otherwise_);
    return;
  }
  const QRectF where(placeOf({-0.5, -0.5}), QSizeF(photograph_.size()) * scale());
  painter.setRenderHint(QPainter::SmoothPixmapTransform, scale() < 2);
  painter.drawImage(where, photograph_);
  if (!overlay_.isNull()) painter.drawImage(where, overlay_);
  painter.setRenderHint(QPainter::Antialiasing);
  QPolygonF path;
  for (const QPointF& pixel : path_) path << placeOf(pixel);
  const QColor ink = paints_sherd_ ? photographInks().sherd_brush : photographInks().plate_brush;
  if (path.size() == 1) path << path.first() + QPointF(0.01, 0);
  painter.setPen(QPen(ink, 2 * radius_px_ * scale(), Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPolyline(path);
  if (!brush_) return;
  const double radius = radius_px_ * scale();
  for (const auto& [colour, wide] :
       {std::pair(photographInks().halo, 3.0), std::pair(photographInks().line, 1.0)}) {
    painter.setPen(QPen(colour, lineWidth(*this, wide),
                        paints_sherd_ || wide > 1 ? Qt::SolidLine : Qt::DashLine));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(placeOf(*brush_), radius, radius);
  }
}

void MaskView::mousePressEvent(QMouseEvent* event) {
  if (photograph_.isNull()) return;
  if (event->button() == Qt::LeftButton) {
    brush_ = pixelAt(event->position());
    path_ = {};
    path_ << *brush_;
    update();
  } else {
    dragged_from_ = event->position();
  }
}

void MaskView::mouseMoveEvent(QMouseEvent* event) {
  if (photograph_.isNull()) return;
  if (event->buttons() & (Qt::RightButton | Qt::MiddleButton)) {
    middle_ -= (event->position() - dragged_from_) / scale();
    dragged_from_ = event->position();
    keepWithin();
  }
  brush_ = pixelAt(event->position());
  if ((event->buttons() & Qt::LeftButton) && !path_.isEmpty()) path_ << *brush_;
  update();
}

void MaskView::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || path_.isEmpty()) return;
  const QPolygonF path = path_;
  path_.clear();
  emit stroked(path);
  update();
}

void MaskView::wheelEvent(QWheelEvent* event) {
  enlargeAbout(event->position(), std::pow(kStep, event->angleDelta().y() / 120.0));
  event->accept();
}

void MaskView::leaveEvent(QEvent*) {
  if (!hasFocus()) brush_.reset();
  update();
}

void MaskView::moveBrush(const QPointF& by_px) {
  brush_ = brush_.value_or(middle_) + by_px;
  brush_->setX(std::clamp(brush_->x(), 0.0, photograph_.width() - 1.0));
  brush_->setY(std::clamp(brush_->y(), 0.0, photograph_.height() - 1.0));
  if (!rect().contains(placeOf(*brush_).toPoint())) middle_ = *brush_;
  keepWithin();
}

void MaskView::keyPressEvent(QKeyEvent* event) {
  if (photograph_.isNull() || !movesTheBrush(event->key())) return QWidget::keyPressEvent(event);
  const double step = event->modifiers() & Qt::ShiftModifier ? 1 : std::max(1.0, radius_px_ / 2);
  if (event->key() == Qt::Key_Left) moveBrush({-step, 0});
  if (event->key() == Qt::Key_Right) moveBrush({step, 0});
  if (event->key() == Qt::Key_Up) moveBrush({0, -step});
  if (event->key() == Qt::Key_Down) moveBrush({0, step});
  if (event->key() == Qt::Key_Space && !event->isAutoRepeat())
    emit stroked(QPolygonF() << brush_.value_or(middle_));
}

}  // namespace ostraka::ui
