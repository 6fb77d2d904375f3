#include "ui/widgets/big_button.h"

#include <QPainter>

#include "ui/look/look.h"

namespace ostraka::ui {
namespace {

constexpr double kLetters = Look::kSection, kLeastLetters = 0.85,
                 kStep = 0.05;  // of the body's

}  // namespace

BigButton::BigButton(const QString& name, const QString& text, QWidget* parent)
    : QPushButton(text, parent) {
  setObjectName(name);
  setPrimary(true);
  setSizePolicy(QSizePolicy::Preferred,
                QSizePolicy::Fixed);  // narrower, in two lines, where needed
  setFocusPolicy(Qt::StrongFocus);
}

void BigButton::setKeyHint(const QString& key) {
  key_ = key;
  setAccessibleDescription(key.isEmpty() ? QString() : tr("Key: %1").arg(key));
  update();
}

void BigButton::setPrimary(bool primary) {
  primary_ = primary;
  setProperty("primary", primary);
  update();
}

QSize BigButton::sizeHint() const {
  const QFontMetrics large(scaledFont(*this, kLetters)), small(font());
  const int height = targetSize(*this);
  return {large.horizontalAdvance(text()) + small.horizontalAdvance(key_) + height * 2, height};
}

// Long words of another language go into two lines before they make the window wider.
QSize BigButton::minimumSizeHint() const {
  const QFontMetrics large(scaledFont(*this, kLetters));
  int longest = 0;
  for (const QString& word : text().split(QLatin1Char(' ')))
    longest = qMax(longest, large.horizontalAdvance(word));
  const int whole = large.horizontalAdvance(text());
  return sizeHint() - QSize(whole - qMax(longest, whole * 6 / 10), 0);
}

QRectF BigButton::keyCap() const {
  if (key_.isEmpty() || !isEnabled()) return {};
  const QFontMetricsF metrics(font());
  const double cap = metrics.horizontalAdvance(key_) + metrics.height();
  return {width() - Look::kGap - cap, height() / 2.0 - metrics.height() * 0.75, cap,
          metrics.height() * 1.5};
}

QRectF BigButton::wordsRect() const {
  QRectF words = QRectF(rect()).adjusted(Look::kGap, 0, -Look::kGap, 0);
  if (const QRectF cap = keyCap(); !cap.isEmpty())
    words.setRight(cap.left() - QFontMetricsF(font()).height() / 2);
  return words;
}

// Smaller letters before a second line; two lines in large letters would be cut above and below.
BigButton::Letters BigButton::letters() const {
  const QRectF words = wordsRect();
  for (double factor = kLetters; factor > kLeastLetters; factor -= kStep)
    if (QFontMetricsF(scaledFont(*this, factor, true)).horizontalAdvance(text()) <= words.width())
      return {factor, true};
  const auto needs = [&](double factor) {
    return QFontMetricsF(scaledFont(*this, factor))
        .boundingRect(words, Qt::AlignCenter | Qt::TextWordWrap, text())
        .height();
  };
  double factor = kLetters;
  while (factor > kLeastLetters && needs(factor) > words.height()) factor -= kStep;
  return {factor, false};
}

void BigButton::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const Colours& colours = coloursOf(palette());
  const bool enabled = isEnabled(), filled = enabled && primary_;
  QColor ground = filled ? colours.accent : colours.raised;
  if (isDown() || (enabled && underMouse())) ground = ground.darker(isDown() ? 125 : 108);
  const QColor ink = filled ? colours.on_accent : enabled ? colours.text : colours.disabled;
  const double line = Look::kFocus, edge = colours.border_width;
  const QRectF frame = QRectF(rect()).adjusted(edge / 2, edge / 2, -edge / 2, -edge / 2);
  painter.setPen(filled ? QPen(Qt::NoPen)
                        : QPen(enabled ? colours.control : colours.disabled, edge,
                               enabled ? Qt::SolidLine : Qt::DashLine));
  painter.setBrush(ground);
  painter.drawRoundedRect(frame, Look::kCorner, Look::kCorner);
  if (hasFocus()) {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(filled ? ink : colours.accent, line));
    painter.drawRoundedRect(frame.adjusted(line * 1.5, line * 1.5, -line * 1.5, -line * 1.5),
                            Look::kCorner - line, Look::kCorner - line);
  }
  painter.setPen(ink);
  if (const QRectF cap = keyCap(); !cap.isEmpty()) {
    painter.setFont(font());
    const double round = QFontMetricsF(font()).height() / 4;
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(ink, edge));
    painter.drawRoundedRect(cap, round, round);
    painter.drawText(cap, Qt::AlignCenter, key_);
  }
  const Letters chosen = letters();
  painter.setFont(scaledFont(*this, chosen.factor, true));
  painter.drawText(wordsRect(), Qt::AlignCenter | (chosen.one_line ? 0 : int(Qt::TextWordWrap)),
                   text());
}

}  // namespace ostraka::ui
