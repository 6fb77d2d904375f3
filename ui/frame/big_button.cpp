#include "ui/frame/big_button.h"

#include <QPainter>
#include <QStyleOptionButton>

#include "ui/frame/look.h"

namespace ostraka::ui {

BigButton::BigButton(QWidget* parent) : QPushButton(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setFocusPolicy(Qt::StrongFocus);
}

void BigButton::setKeyHint(const QString& key) {
  key_ = key;
  setAccessibleDescription(key.isEmpty() ? QString() : tr("Key: %1").arg(key));
  update();
}

QSize BigButton::sizeHint() const {
  const QFontMetrics large(scaledFont(*this, 1.5)), small(font());
  const int height = qMax(targetSize(*this), large.height() * 2);
  return {large.horizontalAdvance(text()) + small.horizontalAdvance(key_) + height * 2, height};
}

// Long words of another language go into two lines before they make the window wider.
QSize BigButton::minimumSizeHint() const {
  const QFontMetrics large(scaledFont(*this, 1.5));
  int longest = 0;
  for (const QString& word : text().split(QLatin1Char(' ')))
    longest = qMax(longest, large.horizontalAdvance(word));
  const int whole = large.horizontalAdvance(text());
  return sizeHint() - QSize(whole - qMax(longest, whole * 6 / 10), 0);
}

void BigButton::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QPalette& colours = palette();
  const bool enabled = isEnabled();
  QColor ground = enabled ? colours.color(QPalette::Highlight) : colours.color(QPalette::Button);
  if (isDown()) ground = ground.darker(125);
  const QColor ink = enabled ? colours.color(QPalette::HighlightedText)
                             : colours.color(QPalette::Disabled, QPalette::ButtonText);
  const double line = lineWidth(*this, 2);
  const QRectF frame = QRectF(rect()).adjusted(line, line, -line, -line);
  const double round = frame.height() / 6;
  painter.setPen(enabled ? QPen(Qt::NoPen) : QPen(colours.color(QPalette::Mid), line / 2));
  painter.setBrush(ground);
  painter.drawRoundedRect(frame, round, round);
  if (hasFocus()) {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(ink, line));
    const double in = line * 2;
    painter.drawRoundedRect(frame.adjusted(in, in, -in, -in), round / 1.5, round / 1.5);
  }
  painter.setPen(ink);
  QRectF words = frame.adjusted(round, 0, -round, 0);
  if (!key_.isEmpty() && enabled) {
    painter.setFont(font());
    const QFontMetricsF metrics(font());
    const double width = metrics.horizontalAdvance(key_) + metrics.height();
    const QRectF cap(words.right() - width, words.center().y() - metrics.height() * 0.75, width,
                     metrics.height() * 1.5);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(ink, line / 2));
    painter.drawRoundedRect(cap, metrics.height() / 4, metrics.height() / 4);
    painter.drawText(cap, Qt::AlignCenter, key_);
    words.setRight(cap.left() - metrics.height() / 2);
  }
  // Two lines in large letters are cut above and below where smaller ones fit.
  const auto needs = [&](double factor) {
    return QFontMetricsF(scaledFont(*this, factor))
        .boundingRect(words, Qt::AlignCenter | Qt::TextWordWrap, text())
        .height();
  };
  double factor = 1.5;
  while (factor > 0.9 && needs(factor) > words.height()) factor -= 0.1;
  painter.setFont(scaledFont(*this, factor));
  painter.drawText(words, Qt::AlignCenter | Qt::TextWordWrap, text());
}

}  // namespace ostraka::ui
