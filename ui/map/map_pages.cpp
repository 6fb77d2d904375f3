#include "ui/map/map_pages.h"

#include <QCoreApplication>
#include <QPageLayout>
#include <QPagedPaintDevice>
#include <QPainter>
#include <QPalette>
#include <algorithm>
#include <cmath>

#include "ui/frame/state_colours.h"
#include "ui/map/qr_code.h"

namespace ostraka::ui {
namespace {

using pipeline::CardState;
using pipeline::MapMark;

constexpr double kLabelWide_mm = 85, kLabelHigh_mm = 32, kModule_mm = 0.5;
constexpr int kQuietModules = 4;

QString tr(const char* text) {
  return QCoreApplication::translate("ostraka::ui", text);
}

QString wordsOf(const MapMark& mark) {
  const QString number = QString::fromStdString(mark.number);
  if (mark.state == CardState::Aside) return tr("aside");
  if (mark.state == CardState::Reshoot) return tr("again");
  if (number.isEmpty()) return QStringLiteral("?");
  if (!mark.other_number.empty())
    return tr("%1 or %2").arg(number, QString::fromStdString(mark.other_number));
  return mark.state == CardState::Ask || mark.state == CardState::Alone ? number + " ?" : number;
}

// Dark letters with a light edge: readable on every clay, on paper too.
void paintNumber(QPainter& painter, const QPointF& at, const QString& text, double height,
                 bool highlighted) {
  QFont font = painter.font();
  font.setBold(true);
  font.setPixelSize(std::max(1, static_cast<int>(height)));
  painter.setFont(font);
  const QRectF box = QFontMetricsF(font).boundingRect(text);
  QRectF ground(0, 0, box.width() + 0.5 * height, 1.2 * height);
  ground.moveCenter(at);
  painter.setPen(QPen(Qt::black, height / 18));
  painter.setBrush(highlighted ? Qt::yellow : Qt::white);
  painter.drawRoundedRect(ground, 0.25 * height, 0.25 * height);
  painter.setPen(Qt::black);
  painter.drawText(ground, Qt::AlignCenter, text);
}

void paintLabel(QPainter& painter, const QRectF& where, const SherdLabel& label, double per_mm) {
  painter.setPen(QPen(Qt::gray, 0.1 * per_mm, Qt::DotLine));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(where);
  const QImage code = qrCode(label.code);
  double left = where.left() + 3 * per_mm;
  if (!code.isNull()) {
    const double side = code.width() * kModule_mm * per_mm,
                 quiet = kQuietModules * kModule_mm * per_mm;
    painter.drawImage(QRectF(where.left() + quiet, where.center().y() - side / 2, side, side),
                      code);
    left = where.left() + side + 2 * quiet;
  }
  const QRectF words(left, where.top() + 3 * per_mm, where.right() - left - 2 * per_mm,
                     where.height() - 6 * per_mm);
  QFont font = painter.font();
  font.setBold(true);
  font.setPixelSize(static_cast<int>(5.5 * per_mm));
  // A long number shrinks until it fits; never below what is readable at arm's length.
  while (QFontMetricsF(font).horizontalAdvance(label.number) > words.width() &&
         font.pixelSize() > 3 * per_mm)
    font.setPixelSize(font.pixelSize() - std::max(1, static_cast<int>(0.2 * per_mm)));
  painter.setFont(font);
  painter.setPen(Qt::black);
  painter.drawText(words, Qt::AlignLeft | Qt::AlignTop, label.number);
  font.setBold(false);
  font.setPixelSize(static_cast<int>(3.5 * per_mm));
  painter.setFont(font);
  painter.drawText(words.adjusted(0, 8 * per_mm, 0, 0),
                   Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, label.context);
  painter.drawText(words, Qt::AlignLeft | Qt::AlignBottom, label.date);
}

}  // namespace

QRectF mapPlace(const QRectF& where, const pipeline::MapSide& side) {
  if (side.width <= 0 || side.height <= 0) return where;
  const QSizeF size = QSizeF(side.width, side.height).scaled(where.size(), Qt::KeepAspectRatio);
  QRectF place(QPointF(), size);
  place.moveCenter(where.center());
  return place;
}

void paintMapSide(QPainter& painter, const QRectF& where, const pipeline::MapSide& side,
                  const QImage& photograph, const QString& highlighted) {
  const QRectF place = mapPlace(where, side);
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  if (photograph.isNull()) {
    painter.fillRect(place, Qt::lightGray);
    painter.setPen(Qt::black);
    painter.drawText(place, Qt::AlignHCenter | Qt::AlignTop,
                     tr("The photograph is not there any more."));
  } else {
    painter.drawImage(place, photograph);
  }
  const double scale = place.width() / std::max(1, side.width);
  const StateColours colours{QPalette(Qt::black)};  // photographs are dark in every theme
  for (const MapMark& mark : side.marks) {
    const bool lit = !mark.number.empty() && QString::fromStdString(mark.number) == highlighted;
    QPolygonF outline;
    for (const Eigen::Vector2d& p : mark.outline)
      outline << place.topLeft() + scale * QPointF(p.x(), p.y());
    const bool doubtful = mark.state == CardState::Ask || mark.state == CardState::Alone;
    painter.setPen(QPen(lit ? QColor(Qt::yellow) : colours.of(doubtful ? State::Ask : State::Sure),
                        place.width() / (lit ? 150 : 350),
                        doubtful ? Qt::DashLine : Qt::SolidLine));
    painter.setBrush(lit ? QColor(255, 255, 0, 60) : QColor(Qt::transparent));
    painter.drawPolygon(outline);
  }
  // Numbers last, so that no neighbour's outline runs through one; above a sherd that its number
  // would cover.
  const double height = std::max(place.width() / 26, 11.0);
  for (const MapMark& mark : side.marks) {
    QPointF at = place.topLeft() + scale * QPointF(mark.at.x(), mark.at.y());
    double top = at.y();
    for (const Eigen::Vector2d& p : mark.outline) top = std::min(top, place.top() + scale * p.y());
    if (at.y() - top < 1.1 * height) at.setY(std::max(place.top(), top - 0.7 * height));
    paintNumber(painter, at, wordsOf(mark), height,
                !mark.number.empty() && QString::fromStdString(mark.number) == highlighted);
  }
  painter.restore();
}

bool printMap(QPagedPaintDevice& device, const MapPicture& picture,
              const QVector<SherdLabel>& labels, const QString& title, QString* why) {
  device.setPageOrientation(QPageLayout::Landscape);
  QPainter painter;
  if (!painter.begin(&device)) {
    *why = tr("The printer or file cannot be written; choose another.");
    return false;
  }
  const double per_mm = device.logicalDpiX() / 25.4;
  const QRectF page(0, 0, device.width(), device.height());
  QFont font = painter.font();
  font.setPixelSize(static_cast<int>(5 * per_mm));
  painter.setFont(font);
  painter.drawText(page, Qt::AlignHCenter | Qt::AlignTop, title);
  const QRectF sides = page.adjusted(0, 16 * per_mm, 0, 0);
  const QRectF left(sides.left(), sides.top(), sides.width() / 2 - 2 * per_mm, sides.height());
  const QRectF right = left.translated(sides.width() / 2 + 2 * per_mm, 0);
  painter.drawText(left.translated(0, -8 * per_mm), Qt::AlignHCenter | Qt::AlignTop, tr("front"));
  painter.drawText(right.translated(0, -8 * per_mm), Qt::AlignHCenter | Qt::AlignTop, tr("back"));
  paintMapSide(painter, left, picture.map.front, picture.front, {});
  paintMapSide(painter, right, picture.map.back, picture.back, {});

  const int columns = std::max(1, static_cast<int>(page.width() / (kLabelWide_mm * per_mm)));
  const int rows = std::max(1, static_cast<int>(page.height() / (kLabelHigh_mm * per_mm)));
  for (int i = 0; i < labels.size(); ++i) {
    const int slot = i % (columns * rows);
    if (slot == 0 && !device.newPage()) {
      *why = tr("The printer took no further page.");
      return false;
    }
    const QRectF where((slot % columns) * kLabelWide_mm * per_mm,
                       (slot / columns) * kLabelHigh_mm * per_mm, kLabelWide_mm * per_mm,
                       kLabelHigh_mm * per_mm);
    paintLabel(painter, where, labels[i], per_mm);
  }
  if (!painter.end()) {
    *why = tr("The printer or file could not be finished; is the disk full?");
    return false;
  }
  return true;
}

}  // namespace ostraka::ui
