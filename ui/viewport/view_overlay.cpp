#include "ui/viewport/view_overlay.h"

#include <QLocale>
#include <QPainter>
#include <array>
#include <cmath>

#include "ui/frame/look.h"
#include "ui/frame/state_colours.h"

namespace ostraka::ui {

ViewOverlay::ViewOverlay(QWidget* parent) : QWidget(parent) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAttribute(Qt::WA_NoSystemBackground);
  setFocusPolicy(Qt::NoFocus);
}

void ViewOverlay::setLegend(Legend legend, double reach_mm) {
  legend_ = legend;
  reach_mm_ = reach_mm;
  update();
}

void ViewOverlay::setScale(double mm_per_pixel) {
  if (mm_per_pixel == mm_per_pixel_) return;
  mm_per_pixel_ = mm_per_pixel;
  update();
}

void ViewOverlay::setNote(const QString& note) {
  note_ = note;
  update();
}

void ViewOverlay::setUnitKnown(bool known) {
  unit_known_ = known;
  update();
}

void ViewOverlay::setMeasure(const QString& text) {
  measure_ = text;
  update();
}

void ViewOverlay::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  if (!note_.isEmpty()) {
    painter.setPen(palette().color(QPalette::Text));
    const int edge = fontMetrics().height();
    painter.drawText(rect().adjusted(edge, edge, -edge, -edge), Qt::AlignCenter | Qt::TextWordWrap,
                     note_);
    return;
  }
  paintBar(painter);
  paintLegend(painter);
  if (measure_.isEmpty()) return;
  painter.setFont(scaledFont(*this, 1.3));
  painter.setPen(palette().color(QPalette::Text));
  const int edge = fontMetrics().height() / 2;  // the legend has the corner above, the bar the left
  painter.drawText(rect().adjusted(edge, edge, -edge, -edge), Qt::AlignRight | Qt::AlignBottom,
                   measure_);
}

void ViewOverlay::paintBar(QPainter& painter) const {
  if (!(mm_per_pixel_ > 0) || !unit_known_) return;
  // The longest round length that takes at most a third of the width.
  const double most = width() / 3.0 * mm_per_pixel_;
  double length = 0;
  for (const double l : {0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0})
    if (l <= most) length = l;
  if (length == 0) return;
  const int edge = fontMetrics().height() / 2;
  const double pixels = length / mm_per_pixel_;
  const QPointF from(edge, height() - edge);
  painter.setPen(QPen(palette().color(QPalette::Text), lineWidth(*this, 3)));
  painter.drawLine(from, from + QPointF(pixels, 0));
  painter.drawText(from + QPointF(0, -edge * 0.7),
                   tr("%1 mm").arg(QLocale().toString(length, 'g', 3)));
}

void ViewOverlay::paintLegend(QPainter& painter) const {
  if (legend_ == Legend::None) return;
  const StateColours colours(palette());
  const QFontMetrics metrics = fontMetrics();
  const int line = metrics.height(), edge = line / 2;
  if (legend_ == Legend::Sides) {
    const std::array<std::pair<State, QString>, 2> sides = {
        {{State::Front, tr("front: blue rim")}, {State::Back, tr("back: red rim")}}};
    int y = edge + metrics.ascent();
    for (const auto& [state, words] : sides) {
      painter.setPen(Qt::NoPen);
      painter.setBrush(colours.of(state));
      painter.drawEllipse(QPointF(edge + line * 0.3, y - line * 0.3), line * 0.3, line * 0.3);
      painter.setPen(palette().color(QPalette::Text));
      painter.drawText(edge + line, y, words);
      y += line;
    }
    return;
  }
  const int bar = std::min(width() / 3, 14 * line / 2);
  for (int i = 0; i < bar; ++i)
    painter.fillRect(edge + i, edge, 1, line / 2, colours.alongRim(static_cast<double>(i) / bar));
  painter.setPen(palette().color(QPalette::Text));
  const QString reach = QLocale().toString(reach_mm_, 'f', 1);
  const QString far =
      unit_known_ ? tr("%1 mm and more").arg(reach) : QStringLiteral("≥ %1").arg(reach);
  painter.drawText(edge, edge + line / 2 + metrics.ascent(),
                   unit_known_ ? tr("0 mm") : QStringLiteral("0"));
  painter.drawText(edge + bar - metrics.horizontalAdvance(QStringLiteral("0")),
                   edge + line / 2 + metrics.ascent(), far);
  painter.drawText(edge, edge + line / 2 + line + metrics.ascent(),
                   tr("gap between the sides along the rim"));
  painter.drawText(edge, edge + line / 2 + 2 * line + metrics.ascent(),
                   tr("grey: not met by the other side"));
}

}  // namespace ostraka::ui
