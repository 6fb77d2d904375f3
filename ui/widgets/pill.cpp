#include "ui/widgets/pill.h"

#include <QPainter>

#include "ui/look/look.h"

namespace ostraka::ui {
namespace {

// The edge of a state where no colour is seen.
QPen edgeOf(State state, const QColor& ink, double wide) {
  switch (state) {
    case State::Ask:
      return QPen(ink, wide, Qt::DashLine);
    case State::Failed:
      return QPen(ink, 2 * wide);
    case State::Waiting:
    case State::Aside:
      return QPen(ink, wide, Qt::DotLine);
    default:
      return QPen(ink, wide);
  }
}

}  // namespace

QSize sizeOf(const Pill& pill, const QFontMetrics& metrics) {
  const int high = metrics.height() + Look::kGap;
  return {metrics.horizontalAdvance(pill.word) + metrics.height() + 3 * Look::kGap, high};
}

void drawPill(QPainter& painter, const QRect& where, const Pill& pill, const QPalette& palette) {
  const StateColours colours(palette);
  const Colours& theme = coloursOf(palette);
  const bool sunlight = theme.border_width > 1;
  const QColor ink = colours.of(pill.state);
  const double corner = pill.state == State::Failed ? Look::kCorner / 2.0 : where.height() / 2.0;
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(sunlight ? edgeOf(pill.state, ink, theme.border_width) : QPen(Qt::NoPen));
  painter.setBrush(sunlight ? theme.surface : colours.behind(pill.state));
  painter.drawRoundedRect(QRectF(where).adjusted(1, 1, -1, -1), corner, corner);
  const int size = painter.fontMetrics().height();
  icon(QString::fromLatin1(pill.icon), ink)
      .paint(&painter, QRect(where.left() + Look::kGap, where.center().y() - size / 2, size, size));
  painter.setPen(ink);
  painter.drawText(where.adjusted(size + 3 * Look::kGap / 2, 0, -Look::kGap, 0),
                   Qt::AlignLeft | Qt::AlignVCenter, pill.word);
  painter.restore();
}

void drawThumbnail(QPainter& painter, const QRect& where, const QPixmap& picture) {
  painter.save();
  painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
  painter.setPen(Qt::NoPen);
  painter.setBrush(mattePalette().color(QPalette::Window));
  painter.drawRoundedRect(where, Look::kMatte, Look::kMatte);
  if (!picture.isNull()) {
    const QRect inside =
        where.adjusted(Look::kMatte / 2, Look::kMatte / 2, -Look::kMatte / 2, -Look::kMatte / 2);
    QRect fit(QPoint(), picture.size().scaled(inside.size(), Qt::KeepAspectRatio));
    fit.moveCenter(inside.center());
    painter.drawPixmap(fit, picture);
  }
  painter.restore();
}

void drawRowGround(QPainter& painter, const QRect& row, const QPalette& palette, bool selected,
                   bool focus) {
  const Colours& colours = coloursOf(palette);
  painter.fillRect(row, selected ? StateColours(palette).behind(State::Selected)
                                 : palette.color(QPalette::Base));
  painter.fillRect(row.left(), row.bottom() - colours.border_width + 1, row.width(),
                   colours.border_width, colours.border);
  if (selected) painter.fillRect(row.left(), row.top(), Look::kMatte, row.height(), colours.accent);
  if (!focus) return;
  painter.setPen(QPen(colours.accent, Look::kFocus));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(row.adjusted(1, 1, -1, -1));
}

}  // namespace ostraka::ui
