#include "ui/capture/plate_view.h"

#include <Eigen/Geometry>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <cmath>

#include "ui/look/look.h"

namespace ostraka::ui {
namespace {

constexpr double kScaleBar_mm = 50;

// Words on a photograph: a dark halo keeps them readable on clay, plate and paper.
void drawOnPhotograph(QPainter& painter, const QPainterPath& shape, const QColor& ink,
                      double line) {
  painter.strokePath(
      shape, QPen(photographInks().halo, line * 2.2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.fillPath(shape, ink);
}

}  // namespace

PlateView::PlateView(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  setAccessibleName(tr("Picture of the plate"));
  setPalette(mattePalette());
}

QSize PlateView::sizeHint() const {
  return {fontMetrics().height() * 28, fontMetrics().height() * 7};
}

void PlateView::setPicture(const std::optional<PlatePicture>& picture, const QString& otherwise) {
  picture_ = picture;
  otherwise_ = otherwise;
  setAccessibleDescription(picture_ ? tr("%n sherd(s) seen", nullptr,
                                         static_cast<int>(picture_->inspection.sherds.size()))
                                    : otherwise);
  update();
}

void PlateView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
  painter.fillRect(rect(), palette().color(QPalette::Base));
  if (!picture_ || picture_->image.isNull()) {
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.setFont(scaledFont(*this, Look::kSection, true));
    painter.drawText(rect().adjusted(20, 20, -20, -20), Qt::AlignCenter | Qt::TextWordWrap,
                     otherwise_);
    return;
  }
  const QRectF where = target();
  painter.drawImage(where, picture_->image);
  if (picture_->inspection.width <= 0) return;
  const double scale = where.width() / picture_->inspection.width;
  painter.save();
  painter.translate(where.topLeft());
  drawFreePlaces(painter, scale);
  drawMarks(painter, scale);
  drawSherds(painter, scale);
  painter.restore();
  drawScaleBar(painter, where, scale);
}

QRectF PlateView::target() const {
  const QSizeF fit = QSizeF(picture_->image.size()).scaled(QSizeF(size()), Qt::KeepAspectRatio);
  return {QPointF((width() - fit.width()) / 2, (height() - fit.height()) / 2), fit};
}

void PlateView::setNumbers(const QStringList& numbers, int chosen) {
  if (numbers == numbers_ && chosen == chosen_) return;
  numbers_ = numbers;
  chosen_ = chosen;
  update();
}

void PlateView::mousePressEvent(QMouseEvent* event) {
  QWidget::mousePressEvent(event);
  if (!picture_ || picture_->inspection.width <= 0) return;
  const QRectF where = target();
  const QPointF pixel =
      (event->position() - where.topLeft()) * (picture_->inspection.width / where.width());
  for (std::size_t i = 0; i < picture_->inspection.sherds.size(); ++i) {
    QPolygonF outline;
    for (const Eigen::Vector2f& p : picture_->inspection.sherds[i].outline_px)
      outline << QPointF(static_cast<double>(p.x()), static_cast<double>(p.y()));
    if (outline.containsPoint(pixel, Qt::OddEvenFill))
      return emit sherdClicked(static_cast<int>(i));
  }
}

// Where more may lie: shaded, and edged by dots, so that nobody takes them for sherds.
void PlateView::drawFreePlaces(QPainter& painter, double scale) const {
  const capture::PlateInspection& inspection = picture_->inspection;
  if (!inspection.pixel_from_plate) return;
  constexpr int kCorners = 36;
  painter.setBrush(photographInks().free_place);
  painter.setPen(QPen(photographInks().line, lineWidth(*this, 1), Qt::DotLine));
  for (const Eigen::Vector2d& place : picture_->room.places) {
    QPolygonF disc;
    for (int k = 0; k < kCorners; ++k) {
      const double turn = 2 * M_PI * k / kCorners;
      const Eigen::Vector2d at =
          place + picture_->room.extent_mm / 2 * Eigen::Vector2d(std::cos(turn), std::sin(turn));
      const Eigen::Vector2d pixel =
          (*inspection.pixel_from_plate * Eigen::Vector3d(at.x(), at.y(), 1)).hnormalized();
      disc << QPointF(pixel.x(), pixel.y()) * scale;
    }
    painter.drawPolygon(disc);
  }
}

// A thin frame around each mark of the plate that is found; one that something hides is crossed out
// by dashes, so that a hand or a shadow is seen before anybody shoots.
void PlateView::drawMarks(QPainter& painter, double scale) const {
  painter.setBrush(Qt::NoBrush);
  for (const capture::PlateMark& mark : picture_->inspection.marks) {
    QPolygonF corners;
    for (const Eigen::Vector2f& p : mark.corners_px)
      corners << QPointF(static_cast<double>(p.x()), static_cast<double>(p.y())) * scale;
    const double line = lineWidth(*this, mark.seen ? 1 : 2);
    painter.setPen(QPen(photographInks().halo, line * 2));
    painter.drawPolygon(corners);
    painter.setPen(QPen(mark.seen ? photographInks().good : photographInks().bad, line,
                        mark.seen ? Qt::SolidLine : Qt::DashLine));
    painter.drawPolygon(corners);
    if (mark.seen) continue;
    painter.drawLine(corners[0], corners[2]);
    painter.drawLine(corners[1], corners[3]);
  }
}

void PlateView::drawSherds(QPainter& painter, double scale) const {
  const double line = lineWidth(*this, 2);
  const QColor good = photographInks().good, bad = photographInks().bad;
  const auto& sherds = picture_->inspection.sherds;
  std::vector<QPointF> centres;
  for (const capture::SeenSherd& sherd : sherds) {
    QPolygonF outline;
    for (const Eigen::Vector2f& p : sherd.outline_px)
      outline << QPointF(static_cast<double>(p.x()), static_cast<double>(p.y())) * scale;
    centres.push_back(outline.boundingRect().center());
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(photographInks().halo, line * 2));
    painter.drawPolygon(outline);
    painter.setPen(
        QPen(sherd.cut_off ? bad : good, line, sherd.cut_off ? Qt::DashLine : Qt::SolidLine));
    painter.drawPolygon(outline);
  }
  for (const auto& [a, b] : picture_->inspection.too_close) {
    const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b);
    if (i >= centres.size() || j >= centres.size()) continue;
    painter.setPen(QPen(bad, line * 3, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(centres[i], centres[j]);
  }
  const QFont font = scaledFont(*this, 1.8);
  for (std::size_t i = 0; i < centres.size(); ++i) {
    const auto sherd = static_cast<int>(i);
    const QString typed = numbers_.value(sherd);
    // The end of a number tells it from its neighbours; what they share stands elsewhere.
    QString number = QString::number(i + 1);
    if (!typed.isEmpty()) number += QStringLiteral(": ") + typed.section(QLatin1Char('-'), -1);
    QPainterPath path;
    const QFontMetricsF metrics(font);
    path.addText(centres[i].x() - metrics.horizontalAdvance(number) / 2,
                 centres[i].y() + metrics.capHeight() / 2, font, number);
    drawOnPhotograph(painter, path, sherd == chosen_ ? photographInks().lit : photographInks().line,
                     line);
  }
}

void PlateView::drawScaleBar(QPainter& painter, const QRectF& picture, double scale) const {
  if (!picture_->inspection.pixel_from_plate) return;
  const Eigen::Matrix3d& h = *picture_->inspection.pixel_from_plate;
  const Eigen::Vector2d left = (h * Eigen::Vector3d(-kScaleBar_mm / 2, 0, 1)).hnormalized();
  const Eigen::Vector2d right = (h * Eigen::Vector3d(kScaleBar_mm / 2, 0, 1)).hnormalized();
  const double length = (right - left).norm() * scale;
  const double line = lineWidth(*this, 3), margin = fontMetrics().height() / 2.0;
  const QPointF end(picture.right() - margin, picture.bottom() - margin * 1.5);
  painter.setPen(QPen(photographInks().halo, line * 2));
  painter.drawLine(end - QPointF(length, 0), end);
  painter.setPen(QPen(photographInks().line, line));
  painter.drawLine(end - QPointF(length, 0), end);
  QPainterPath words;
  words.addText(end - QPointF(length, margin * 0.6), font(), tr("5 cm"));
  drawOnPhotograph(painter, words, photographInks().line, line);
}

}  // namespace ostraka::ui
