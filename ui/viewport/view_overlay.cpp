#include "ui/viewport/view_overlay.h"

#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <vector>

#include "ui/look/look.h"
#include "ui/look/state_colours.h"

namespace ostraka::ui {
namespace {

constexpr double kCubeLines = 4.5;  // of text
constexpr double kCubeSpace = 3;    // smaller pictures have none
constexpr int kScaleSteps = 160;
constexpr double kPanelOpacity = 0.7;  // words stay readable where the sherd lies behind them

// The longest of 1, 2, 5, 10 … that is not above this.
double roundLength(double most) {
  const double ten = std::pow(10.0, std::floor(std::log10(most)));
  return ten * (most >= 5 * ten ? 5 : most >= 2 * ten ? 2 : 1);
}

}  // namespace

ViewOverlay::ViewOverlay(QWidget* parent) : QWidget(parent) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAttribute(Qt::WA_NoSystemBackground);
  setFocusPolicy(Qt::NoFocus);
}

void ViewOverlay::setLegend(Legend legend, double reach_mm) {
  legend_ = legend;
  scale_ = DistanceScale(reach_mm);
  update();
}

void ViewOverlay::setView(double mm_per_pixel, const ViewAxes& axes) {
  if (mm_per_pixel == mm_per_pixel_ && axes == axes_) return;
  mm_per_pixel_ = mm_per_pixel;
  axes_ = axes;
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

void ViewOverlay::setFocusRing(bool shown) {
  focus_ring_ = shown;
  update();
}

void ViewOverlay::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  if (focus_ring_) {
    const double half = Look::kFocus / 2.0;
    painter.setPen(QPen(StateColours::inkOnMatte(), Look::kFocus));
    painter.drawRect(QRectF(rect()).adjusted(half, half, -half, -half));
  }
  const double edge = fontMetrics().height() / 2.0;
  const QRectF inner = QRectF(rect()).adjusted(edge, edge, -edge, -edge);
  painter.setPen(StateColours::inkOnMatte());
  paintBar(painter);
  paintLegend(painter);
  const double cube = kCubeLines * fontMetrics().height();
  if (std::min(width(), height()) > kCubeSpace * cube && mm_per_pixel_ > 0)
    paintOrientationCube(painter, QRectF(inner.right() - cube, inner.top(), cube, cube), axes_,
                         tr("Front"), tr("Back"));
  if (measure_.isEmpty()) return;
  painter.setFont(scaledFont(*this, 1.3));
  painter.setPen(StateColours::inkOnMatte());
  painter.drawText(inner, Qt::AlignRight | Qt::AlignBottom, measure_);
}

void ViewOverlay::paintBar(QPainter& painter) const {
  if (!(mm_per_pixel_ > 0)) return;
  const double edge = fontMetrics().height() / 2.0;
  const QPointF from(edge, height() - edge);
  painter.setPen(QPen(StateColours::inkOnMatte(), lineWidth(*this, 3), Qt::SolidLine, Qt::FlatCap));
  if (!unit_known_) {
    painter.drawText(from, tr("No scale: lengths are not known"));
    return;
  }
  const double length = roundLength(width() / 3.0 * mm_per_pixel_);
  const double pixels = length / mm_per_pixel_;
  painter.drawLine(from, from + QPointF(pixels, 0));
  for (const double x : {0.0, pixels})
    painter.drawLine(from + QPointF(x, -edge / 2), from + QPointF(x, edge / 4));
  painter.drawText(from + QPointF(edge / 2, -edge * 0.8),
                   tr("%1 mm").arg(QLocale().toString(length, 'g', 3)));
}

void ViewOverlay::paintLegend(QPainter& painter) const {
  struct Row {
    QString words;
    QBrush brush;
  };
  std::vector<Row> rows;
  const StateColours colours = StateColours::onMatte();
  const QColor unseen = DistanceScale::notSeen();
  if (legend_ == Legend::Sides)
    rows = {{tr("Front"), colours.of(State::Front)}, {tr("Back"), colours.of(State::Back)}};
  if (legend_ == Legend::Distances) rows = {{tr("no contact"), unseen}};
  if (legend_ == Legend::FilledModel)
    rows = {{tr("filled in, not seen by a camera"), QBrush(unseen, Qt::BDiagPattern)}};
  if (rows.empty()) return;
  const QFontMetricsF metrics(font());
  const double line = metrics.height(), edge = line / 2;
  const bool scale = legend_ == Legend::Distances;
  const QString title = tr("Distance between the sides along the fracture");
  // Below the bar there is room for both ends and the zero between them, in any language.
  const auto [front, back] = scaleEnds();
  const double ends = std::max(metrics.horizontalAdvance(front), metrics.horizontalAdvance(back));
  double wide = scale ? std::max(metrics.horizontalAdvance(title), 2 * (ends + line)) : 0;
  for (const Row& row : rows) wide = std::max(wide, metrics.horizontalAdvance(row.words) + line);
  const double high = (static_cast<double>(rows.size()) + (scale ? 3 : 0)) * line;
  QPointF at(edge, edge);
  // A model fills the picture: its line stands beside the bar, which takes a third at most.
  if (legend_ == Legend::FilledModel && wide + 2 * line < 2 * width() / 3.0)
    at = {width() - wide - edge, height() - edge - line};
  painter.setPen(Qt::NoPen);
  QColor ground = StateColours::matte();
  ground.setAlphaF(kPanelOpacity);
  painter.setBrush(ground);
  painter.drawRoundedRect(
      QRectF(at, QSizeF(wide, high)).adjusted(-edge / 2, -edge / 2, edge / 2, edge / 2), edge / 2,
      edge / 2);
  if (scale) {
    painter.setPen(StateColours::inkOnMatte());
    painter.drawText(QRectF(at, QSizeF(wide, line)), Qt::AlignLeft, title);
    paintScale(painter, at + QPointF(0, line), wide);
    at.ry() += 3 * line;
  }
  for (const Row& row : rows) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(row.brush);
    painter.drawRect(QRectF(at.x(), at.y() + 0.2 * line, 0.6 * line, 0.6 * line));
    painter.setPen(StateColours::inkOnMatte());
    painter.drawText(QRectF(at.x() + line, at.y(), wide, line), Qt::AlignLeft | Qt::AlignVCenter,
                     row.words);
    at.ry() += line;
  }
}

// The bar with its ends and its zero in words.
void ViewOverlay::paintScale(QPainter& painter, const QPointF& at, double bar) const {
  const double line = QFontMetricsF(font()).height();
  for (int i = 0; i < kScaleSteps; ++i) {
    const double t = 2 * (i + 0.5) / kScaleSteps - 1;
    painter.fillRect(QRectF(at.x() + bar * i / kScaleSteps, at.y() + 0.2 * line,
                            bar / kScaleSteps + 1, 0.6 * line),
                     scale_.of(t * scale_.reach_mm()));
  }
  const QRectF words(at.x(), at.y() + line, bar, line);
  painter.setPen(StateColours::inkOnMatte());
  const auto [front, back] = scaleEnds();
  painter.drawText(words, Qt::AlignLeft, front);
  painter.drawText(words, Qt::AlignHCenter, QStringLiteral("0"));
  painter.drawText(words, Qt::AlignRight, back);
}

std::pair<QString, QString> ViewOverlay::scaleEnds() const {
  const QString reach = QLocale().toString(scale_.reach_mm(), 'f', 1);
  const QString length = unit_known_ ? tr("%1 mm").arg(reach) : reach;
  return {tr("front outside by %1").arg(length), tr("back outside by %1").arg(length)};
}

}  // namespace ostraka::ui
