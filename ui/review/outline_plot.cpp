#include "ui/review/outline_plot.h"

#include <QLocale>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>

#include "ui/look/look.h"
#include "ui/look/state_colours.h"

namespace ostraka::ui {
namespace {

constexpr double kLeastShare = 0.5;  // of the usual letters

// Words that a narrow place would cut off get smaller letters.
void drawFitted(QPainter& painter, const QRectF& where, const QString& words) {
  const QFont usual = painter.font();
  const double needed = QFontMetricsF(usual).horizontalAdvance(words);
  if (needed > where.width() && usual.pointSizeF() > 0) {
    QFont smaller = usual;
    smaller.setPointSizeF(usual.pointSizeF() *
                          std::max(kLeastShare, 0.97 * where.width() / needed));
    painter.setFont(smaller);
  }
  painter.drawText(where, Qt::AlignCenter, words);
  painter.setFont(usual);
}

}  // namespace

OutlinePlot::OutlinePlot(QWidget* parent) : QWidget(parent) {
  setAccessibleName(tr("Outlines overlaid, and their turning angles"));
  setAccessibleDescription(tr("The lines of a pair lie on each other."));
  setMinimumHeight(fontMetrics().height() * 5);
}

void OutlinePlot::setView(const review::PairView& view) {
  view_ = view;
  view_.front = view_.back = {};  // the pictures are not drawn here
  update();
}

void OutlinePlot::clear() {
  view_ = {};
  update();
}

int OutlinePlot::readableWidth() const {
  return 2 * 10 * fontMetrics().averageCharWidth();
}

QPen OutlinePlot::penOf(bool front) const {
  const StateColours colours(palette());
  QPen pen(colours.of(front ? State::Front : State::Back), lineWidth(*this, 1.8));
  if (!front) pen.setDashPattern({4, 2.5});
  return pen;
}

void OutlinePlot::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const int line = fontMetrics().height();
  const QRectF all = QRectF(rect()).adjusted(4, line + 4, -4, -line - 4);
  const QRectF left(all.left(), all.top(), all.width() / 2 - 6, all.height());
  const QRectF right(all.center().x() + 6, all.top(), all.width() / 2 - 6, all.height());
  painter.setPen(palette().color(QPalette::Text));
  drawFitted(painter, QRectF(left.left(), 0, left.width(), line), tr("Outlines overlaid"));
  drawFitted(painter, QRectF(right.left(), 0, right.width(), line), tr("Turning angles"));
  paintOutlines(painter, left);
  paintTurns(painter, right);
}

void OutlinePlot::paintOutlines(QPainter& painter, const QRectF& where) const {
  if (view_.front_outline.empty()) return;
  Eigen::Vector2d low = view_.front_outline[0], high = low;
  for (const auto* outline : {&view_.front_outline, &view_.back_outline})
    for (const Eigen::Vector2d& p : *outline) low = low.cwiseMin(p), high = high.cwiseMax(p);
  const Eigen::Vector2d size = (high - low).cwiseMax(1.0);
  const double scale = std::min(where.width() / size.x(), where.height() / size.y());
  const QPointF corner(where.center().x() - scale * size.x() / 2,
                       where.center().y() + scale * size.y() / 2);
  for (const bool front : {true, false}) {
    QPolygonF polygon;
    for (const Eigen::Vector2d& p : front ? view_.front_outline : view_.back_outline)
      polygon << corner + QPointF(scale * (p.x() - low.x()), -scale * (p.y() - low.y()));
    painter.setPen(penOf(front));
    painter.drawPolygon(polygon);
  }
  const double bar = 10 * scale;
  painter.setPen(QPen(palette().color(QPalette::Text), lineWidth(*this, 3)));
  const QPointF from(where.left(), height() - fontMetrics().height() * 0.4);
  painter.drawLine(from, from + QPointF(bar, 0));
  painter.drawText(from + QPointF(bar + 6, fontMetrics().height() * 0.25),
                   tr("%1 mm").arg(QLocale().toString(10)));
}

void OutlinePlot::paintTurns(QPainter& painter, const QRectF& where) const {
  painter.setPen(QPen(palette().color(QPalette::Dark), 1));
  painter.drawLine(where.bottomLeft(), where.bottomRight());
  painter.drawLine(where.bottomLeft(), where.topLeft());
  if (view_.front_turns.empty()) return;
  double low = 0, high = 6.3;
  for (const auto* turns : {&view_.front_turns, &view_.back_turns})
    for (const double t : *turns) low = std::min(low, t), high = std::max(high, t);
  for (const bool front : {true, false}) {
    const std::vector<double>& turns = front ? view_.front_turns : view_.back_turns;
    QPainterPath path;
    for (std::size_t i = 0; i < turns.size(); ++i) {
      const QPointF p(where.left() + where.width() * static_cast<double>(i) / (turns.size() - 1.0),
                      where.bottom() - where.height() * (turns[i] - low) / (high - low));
      i == 0 ? path.moveTo(p) : path.lineTo(p);
    }
    painter.setPen(penOf(front));
    painter.drawPath(path);
  }
  painter.setPen(palette().color(QPalette::Text));
  drawFitted(painter,
             QRectF(where.left(), height() - fontMetrics().height() - 2, where.width(),
                    fontMetrics().height()),
             tr("The lines of a pair lie on each other."));
}

}  // namespace ostraka::ui
