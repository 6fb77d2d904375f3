#include "ui/map/map_pages.h"

#include <QPageLayout>
#include <QPagedPaintDevice>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "ui/frame/free_tr.h"
#include "ui/look/look.h"
#include "ui/look/state_colours.h"
#include "ui/map/qr_code.h"

namespace ostraka::ui {
namespace {

using review::CardState;
using review::MapMark;

constexpr double kLabelWide_mm = 85, kLabelHigh_mm = 32;
// As large as the label is high: a rig's camera sees it from half a metre, 0.25 to 0.4 mm a pixel.
// With its margin a code takes this much, and a short one has no larger modules than are needed.
constexpr double kCode_mm = 25, kLargestModule_mm = 0.75;
constexpr int kQuietModules = 4;
constexpr double kOnNumber = 4;  // how much worse a number is covered than a sherd

QFont numberFont(const QPainter& painter, double height) {
  QFont font = painter.font();
  font.setBold(true);
  font.setPixelSize(std::max(1, static_cast<int>(height)));
  return font;
}

// Dark letters with a light edge: readable on every clay, on paper too.
void paintNumber(QPainter& painter, const QRectF& ground, const QString& text, double height,
                 bool highlighted) {
  painter.setFont(numberFont(painter, height));
  painter.setPen(QPen(paperInks().ink, height / 18));
  painter.setBrush(highlighted ? paperInks().lit : paperInks().paper);
  painter.drawRoundedRect(ground, 0.25 * height, 0.25 * height);
  painter.setPen(paperInks().ink);
  painter.drawText(ground, Qt::AlignCenter, text);
}

double areaOf(const QRectF& r) {
  return r.width() * r.height();
}

}  // namespace

QString wordsOf(const MapMark& mark, const MapNumbers& numbers) {
  const QString plate = QString::fromStdString(mark.number);
  const QString number = numbers.shown(plate);
  const bool is_final = numbers.endings.contains(plate);
  if (numbers.again.contains(plate)) return tr("now %1").arg(numbers.again[plate]);
  if (mark.state == CardState::Aside) return is_final ? tr("%1, aside").arg(number) : tr("aside");
  if (mark.state == CardState::Reshoot)
    return is_final ? tr("%1, shoot again").arg(number) : tr("shoot again");
  if (numbers.voided.contains(plate)) return tr("%1, void").arg(number);
  if (number.isEmpty()) return QStringLiteral("?");
  if (!mark.other_number.empty())
    return tr("%1 or %2").arg(number, numbers.shown(QString::fromStdString(mark.other_number)));
  return mark.state == CardState::Ask || mark.state == CardState::Alone ? number + " ?" : number;
}

void paintLabel(QPainter& painter, const QRectF& where, const SherdLabel& label, double per_mm) {
  painter.setPen(QPen(paperInks().faint, 0.1 * per_mm, Qt::DotLine));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(where);
  const QImage code = qrCode(label.code);
  double left = where.left() + 3 * per_mm;
  if (!code.isNull()) {
    const double module =
        std::min(kLargestModule_mm, kCode_mm / (code.width() + 2 * kQuietModules)) * per_mm;
    const double side = code.width() * module, quiet = kQuietModules * module;
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
  painter.setPen(paperInks().ink);
  QRectF written;
  painter.drawText(words, Qt::AlignLeft | Qt::AlignTop | Qt::TextWrapAnywhere, label.number,
                   &written);
  font.setBold(false);
  font.setPixelSize(static_cast<int>(3.5 * per_mm));
  painter.setFont(font);
  painter.drawText(words.adjusted(0, std::max(8 * per_mm, written.height() + per_mm), 0, 0),
                   Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, label.context);
  const QString foot = label.date.isEmpty() || label.contents.isEmpty()
                           ? label.date + label.contents
                           : tr("%1, %2").arg(label.date, label.contents);
  while (QFontMetricsF(font).horizontalAdvance(foot) > words.width() &&
         font.pixelSize() > 2.5 * per_mm)
    font.setPixelSize(font.pixelSize() - std::max(1, static_cast<int>(0.2 * per_mm)));
  painter.setFont(font);
  painter.drawText(words, Qt::AlignLeft | Qt::AlignBottom, foot);
}

QString MapNumbers::shown(const QString& plate_number) const {
  bool counted = false;
  const int number = plate_number.toInt(&counted);
  const QString plain = counted ? QString::number(number) : plate_number;  // files need the zeros
  if (endings.isEmpty() || plate_number.isEmpty()) return plain;
  return endings.value(plate_number, QStringLiteral("(%1)").arg(plain));
}

QString MapNumbers::whole(const QString& plate_number) const {
  return (shortened.contains(plate_number) ? common : QString()) + shown(plate_number);
}

QRectF mapPlace(const QRectF& where, const review::MapSide& side) {
  if (side.width <= 0 || side.height <= 0) return where;
  const QSizeF size = QSizeF(side.width, side.height).scaled(where.size(), Qt::KeepAspectRatio);
  QRectF place(QPointF(), size);
  place.moveCenter(where.center());
  return place;
}

std::vector<QRectF> placeNumbers(const std::vector<NumberToPlace>& numbers, const QRectF& within) {
  std::vector<QRectF> taken(numbers.size());
  // The longest first: they find room least easily.
  std::vector<std::size_t> order(numbers.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return numbers[a].size.width() > numbers[b].size.width();
  });
  std::vector<QRectF> placed, boxes;
  for (const NumberToPlace& number : numbers) boxes.push_back(number.outline.boundingRect());
  for (const std::size_t i : order) {
    const auto& [size, at, outline] = numbers[i];
    const QRectF& sherd = boxes[i];
    // On the sherd where it covers less than half of it, else around it, above first.
    std::vector<QPointF> centres;
    const bool small = areaOf(QRectF({}, size)) > areaOf(sherd) / 2;
    if (!small) centres.push_back(at);
    for (int ring = 0; ring < 8; ++ring) {
      const double dx = sherd.width() / 2 + size.width() / 2 + ring * size.height() / 2,
                   dy = sherd.height() / 2 + size.height() / 2 + ring * size.height() / 2;
      for (const double turn : {-90., 90., 0., 180., -45., -135., 45., 135.}) {
        const double angle = turn * std::numbers::pi / 180;
        centres.push_back(sherd.center() + QPointF(dx * std::cos(angle), dy * std::sin(angle)));
      }
      if (ring == 0 && !small) {  // elsewhere on the sherd
        for (const double part : {-0.3, 0.3}) {
          centres.insert(centres.begin() + 1, at + QPointF(part * sherd.width(), 0));
          centres.insert(centres.begin() + 1, at + QPointF(0, part * sherd.height()));
        }
      }
    }
    QRectF best;
    double least = std::numeric_limits<double>::max();
    for (const QPointF& centre : centres) {
      QRectF ground({}, size);
      ground.moveCenter(centre);
      ground.moveLeft(std::clamp(ground.left(), within.left(),
                                 std::max(within.left(), within.right() - size.width())));
      ground.moveTop(std::clamp(ground.top(), within.top(),
                                std::max(within.top(), within.bottom() - size.height())));
      // Another's number is the worst; a small sherd, its own or another's, is not to be hidden.
      double covered = 0;
      for (const QRectF& other : placed) covered += kOnNumber * areaOf(ground.intersected(other));
      for (std::size_t j = 0; j < numbers.size(); ++j)
        if (j != i || small) covered += areaOf(ground.intersected(boxes[j]));
      if (covered >= least) continue;
      least = covered;
      best = ground;
      if (covered == 0) break;
    }
    placed.push_back(best);
    taken[i] = best;
  }
  return taken;
}

void paintMapSide(QPainter& painter, const QRectF& where, const review::MapSide& side,
                  const QImage& photograph, const MapNumbers& final_numbers,
                  const QString& highlighted) {
  const QRectF place = mapPlace(where, side);
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  if (photograph.isNull()) {
    painter.fillRect(place, paperInks().faint);
    painter.setPen(paperInks().ink);
    painter.drawText(place, Qt::AlignHCenter | Qt::AlignTop,
                     tr("The photograph is not there any more."));
  } else {
    painter.drawImage(place, photograph);
  }
  const double scale = place.width() / std::max(1, side.width);
  const StateColours colours = StateColours::onMatte();  // photographs are dark in every theme
  for (const MapMark& mark : side.marks) {
    const bool lit = !mark.number.empty() && QString::fromStdString(mark.number) == highlighted;
    QPolygonF outline;
    for (const Eigen::Vector2d& p : mark.outline)
      outline << place.topLeft() + scale * QPointF(p.x(), p.y());
    const bool doubtful = mark.state == CardState::Ask || mark.state == CardState::Alone;
    painter.setPen(
        QPen(lit ? photographInks().lit : colours.of(doubtful ? State::Ask : State::Sure),
             place.width() / (lit ? 150 : 350), doubtful ? Qt::DashLine : Qt::SolidLine));
    painter.setBrush(lit ? photographInks().lit_ground : QColor(Qt::transparent));
    painter.drawPolygon(outline);
  }
  // Numbers last, so that no neighbour's outline runs through one.
  const double height = std::max(place.width() / 26, 11.0);
  std::vector<NumberToPlace> numbers;
  for (const MapMark& mark : side.marks) {
    const QRectF box =
        QFontMetricsF(numberFont(painter, height)).boundingRect(wordsOf(mark, final_numbers));
    NumberToPlace number{{box.width() + 0.5 * height, 1.2 * height},
                         place.topLeft() + scale * QPointF(mark.at.x(), mark.at.y()),
                         {}};
    for (const Eigen::Vector2d& p : mark.outline)
      number.outline << place.topLeft() + scale * QPointF(p.x(), p.y());
    numbers.push_back(std::move(number));
  }
  const std::vector<QRectF> grounds = placeNumbers(numbers, place);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const bool lit = !side.marks[i].number.empty() &&
                     QString::fromStdString(side.marks[i].number) == highlighted;
    if (!numbers[i].outline.boundingRect().intersects(grounds[i])) {  // whose is it?
      painter.setPen(QPen(lit ? photographInks().lit : photographInks().line, height / 10));
      painter.drawLine(grounds[i].center(), numbers[i].at);
    }
    paintNumber(painter, grounds[i], wordsOf(side.marks[i], final_numbers), height, lit);
  }
  painter.restore();
}

namespace {

// The first on a page of its own or on the present one.
bool paintLabels(QPainter& painter, QPagedPaintDevice& device, const QVector<SherdLabel>& labels,
                 bool on_new_page, QString* why) {
  const double per_mm = device.logicalDpiX() / 25.4;
  const int columns = std::max(1, static_cast<int>(device.width() / (kLabelWide_mm * per_mm)));
  const int rows = std::max(1, static_cast<int>(device.height() / (kLabelHigh_mm * per_mm)));
  for (int i = 0; i < labels.size(); ++i) {
    const int slot = i % (columns * rows);
    if (slot == 0 && (on_new_page || i > 0) && !device.newPage()) {
      *why = tr("The printer took no further page.");
      return false;
    }
    const QRectF where((slot % columns) * kLabelWide_mm * per_mm,
                       (slot / columns) * kLabelHigh_mm * per_mm, kLabelWide_mm * per_mm,
                       kLabelHigh_mm * per_mm);
    paintLabel(painter, where, labels[i], per_mm);
  }
  return true;
}

bool finish(QPainter& painter, QString* why) {
  if (painter.end()) return true;
  *why = tr("The printer or file could not be finished; is the disk full?");
  return false;
}

}  // namespace

bool printLabels(QPagedPaintDevice& device, const QVector<SherdLabel>& labels, QString* why) {
  QPainter painter;
  if (!painter.begin(&device)) {
    *why = tr("The printer or file cannot be written; choose another.");
    return false;
  }
  return paintLabels(painter, device, labels, false, why) && finish(painter, why);
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
  paintMapSide(painter, left, picture.map.front, picture.front, picture.numbers, {});
  paintMapSide(painter, right, picture.map.back, picture.back, picture.numbers, {});

  return paintLabels(painter, device, labels, true, why) && finish(painter, why);
}

}  // namespace ostraka::ui
