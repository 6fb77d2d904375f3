#include "ui/review/card_delegate.h"

#include <QPainter>
#include <algorithm>

#include "ui/look/state_colours.h"
#include "ui/pairs/card_list_model.h"
#include "ui/pairs/review_words.h"

namespace ostraka::ui {
namespace {

constexpr int kEdges = 8;  // pixels of the frame and between picture and words
constexpr int kReasonLines = 3;
constexpr double kLeastLetters = 0.7;  // of the names of two sides in a narrow card

int pictureSize(const QFontMetrics& metrics) {
  return metrics.height() * 3;
}

void drawPicture(QPainter& painter, const QRect& where, const QImage& picture) {
  if (picture.isNull()) return;
  QRect target(QPoint(), picture.size().scaled(where.size(), Qt::KeepAspectRatio));
  target.moveCenter(where.center());
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.drawImage(target, picture);
}

// What does not fit ends in dots; the whole sentence stands above the pictures and in the tip.
void drawReason(QPainter& painter, const QRect& where, const QFontMetrics& metrics, QString words) {
  const int flags = Qt::AlignLeft | Qt::AlignVCenter | Qt::TextWordWrap;
  QString shown = words;
  while (metrics.boundingRect(where, flags, shown).height() > where.height() && words.size() > 1) {
    words.truncate(std::max<qsizetype>(1, words.lastIndexOf(QLatin1Char(' '), -2)));
    shown = words + QStringLiteral(" …");
  }
  painter.drawText(where, flags, shown);
}

}  // namespace

CardDelegate::CardDelegate(const CardListModel& cards, QObject* parent)
    : QStyledItemDelegate(parent), cards_(cards) {}

QRect CardDelegate::backPicture(const QRect& card, const QFontMetrics& metrics) {
  const int size = pictureSize(metrics), gap = metrics.height() / 3;
  return QRect(card.left() + 2 * gap + size, card.top() + gap, size, size);
}

QSize CardDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
  const QFontMetrics metrics(option.font);
  return {metrics.height() * 13,
          pictureSize(metrics) + 2 * (metrics.height() / 3) +
              (kReasonLines + (cards_.number(cards_.at(index.row()).front).isEmpty() ? 0 : 1)) *
                  metrics.height() +
              kEdges};
}

void CardDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                         const QModelIndex& index) const {
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  const QFontMetrics metrics(option.font);
  const StateColours colours(option.palette);
  const ReviewRow& row = cards_.at(index.row());
  const bool waits = row.change != PieceChange::None;
  const State colour = waits ? State::Waiting : stateColour(row.state);
  const bool chosen = option.state.testFlag(QStyle::State_Selected);
  const bool target = option.state.testFlag(QStyle::State_MouseOver) && option.widget != nullptr &&
                      option.widget->property("dragging").toBool();
  const QRect card = option.rect.adjusted(2, 2, -2, -2);
  painter->setPen(Qt::NoPen);
  painter->setBrush(colours.behind(target ? State::Back : chosen ? State::Selected : colour));
  painter->drawRoundedRect(card, 4, 4);
  if (chosen || target) {
    painter->setBrush(Qt::NoBrush);
    painter->setPen(QPen(colours.of(target ? State::Back : State::Selected), 3));
    painter->drawRoundedRect(card.adjusted(1, 1, -1, -1), 4, 4);
  }
  // The state's stripe at the edge, besides its word.
  painter->fillRect(QRect(card.left(), card.top(), 5, card.height()), colours.of(colour));

  const QRect back = backPicture(card, metrics);
  const QRect front = back.translated(-back.width() - metrics.height() / 3, 0);
  drawPicture(*painter, front.adjusted(4, 0, 4, 0), cards_.picture(batch::Side::Front, row.front));
  drawPicture(*painter, back.adjusted(4, 0, 4, 0), cards_.picture(batch::Side::Back, row.back));

  const int left = back.right() + metrics.height() / 2;
  const QRect words(left, card.top() + metrics.height() / 3, card.right() - left,
                    3 * metrics.height());
  painter->setPen(option.palette.color(QPalette::Text));
  QFont bold = option.font;
  bold.setBold(true);
  painter->setFont(bold);
  const QString mark = colour == State::Sure  ? QStringLiteral("✓ ")
                       : colour == State::Ask ? QStringLiteral("? ")
                       : waits                ? QStringLiteral("… ")
                                              : QString();
  const QString state_words = mark + rowWord(row);
  const QString name = index.data(Qt::DisplayRole).toString();
  QRect reason(card.left() + 10, back.bottom() + 2, card.width() - 14,
               kReasonLines * metrics.height());
  if (QFontMetrics(bold).horizontalAdvance(name) <= words.width()) {
    painter->drawText(words, Qt::AlignLeft | Qt::AlignTop, name);
    painter->setPen(colours.of(colour));
    painter->drawText(words, Qt::AlignLeft | Qt::AlignBottom | Qt::TextWordWrap, state_words);
  } else {
    // Large letters find no room beside the pictures: name and state take a line below them.
    const QRect line(reason.left(), reason.top(), reason.width(), metrics.height());
    reason.setTop(line.bottom() + 1);
    const QString state_mark = mark.isEmpty() ? state_words : mark;
    const int room = line.width() - QFontMetrics(bold).horizontalAdvance(state_mark);
    QFont fitting = bold;  // both numbers are seen
    while (QFontMetrics(fitting).horizontalAdvance(name) > room &&
           fitting.pointSizeF() > kLeastLetters * bold.pointSizeF())
      fitting.setPointSizeF(fitting.pointSizeF() - 0.25);
    painter->setFont(fitting);
    painter->drawText(line, Qt::AlignLeft | Qt::AlignVCenter, name);
    painter->setFont(bold);
    painter->setPen(colours.of(colour));
    painter->drawText(line, Qt::AlignRight | Qt::AlignVCenter, state_mark);
  }
  painter->setFont(option.font);
  painter->setPen(option.palette.color(QPalette::Text));
  if (const QString number = cards_.number(row.front); !number.isEmpty()) {
    // Its end tells it from the others.
    const QRect line(reason.left(), reason.top(), reason.width(), metrics.height());
    reason.setTop(line.bottom() + 1);
    reason.setBottom(reason.bottom() + metrics.height());
    painter->drawText(line, Qt::AlignLeft | Qt::AlignVCenter,
                      metrics.elidedText(number, Qt::ElideLeft, line.width()));
  }
  drawReason(*painter, reason, metrics, index.data(Qt::ToolTipRole).toString());
  painter->restore();
}

}  // namespace ostraka::ui
