#include "ui/queue/batch_delegate.h"

#include <QApplication>
#include <QPainter>
#include <QStyleOptionProgressBar>

#include "ui/frame/lines.h"
#include "ui/frame/look.h"
#include "ui/frame/state_colours.h"
#include "ui/frame/thumbnails.h"
#include "ui/queue/batch_queue.h"

namespace ostraka::ui {
namespace {

struct Mark {
  State colour;
  const char* icon;
};

Mark markOf(QueueState state) {
  switch (state) {
    case QueueState::Shooting:
      return {State::Waiting, "camera"};
    case QueueState::Waiting:
      return {State::Waiting, "clock"};
    case QueueState::Busy:
      return {State::Busy, "play"};
    case QueueState::Paused:
      return {State::Waiting, "pause"};
    case QueueState::Failed:
      return {State::Failed, "error"};
    case QueueState::Review:
      return {State::Ask, "question"};
    case QueueState::Done:
      return {State::Sure, "check"};
  }
  return {State::Waiting, "clock"};
}

QRect band(const QRect& row, int line, int height) {
  return {row.left(), row.top() + line * height, row.width(), height};
}

}  // namespace

BatchDelegate::BatchDelegate(const BatchQueue& queue, QObject* parent)
    : QStyledItemDelegate(parent), queue_(queue) {}

QSize BatchDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const {
  return {option.fontMetrics.averageCharWidth() * 50, option.fontMetrics.height() * 9 / 2};
}

void BatchDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const {
  const QueueRow& row = queue_.row(index.row());
  const int line = option.fontMetrics.height();
  const bool selected = (option.state & QStyle::State_Selected) != 0;
  const StateColours colours(option.palette);
  const QColor ink = option.palette.color(selected ? QPalette::HighlightedText : QPalette::Text);
  painter->save();
  painter->setRenderHint(QPainter::SmoothPixmapTransform);
  painter->fillRect(option.rect, selected          ? option.palette.highlight()
                                 : index.row() % 2 ? option.palette.alternateBase()
                                                   : option.palette.base());
  if ((option.state & QStyle::State_HasFocus) != 0) {
    painter->setPen(QPen(ink, lineWidth(*option.widget)));
    painter->drawRect(option.rect.adjusted(1, 1, -2, -2));
  }
  const QRect inside = option.rect.adjusted(line / 2, line / 2, -line / 2, -line / 2);

  const QRect frame(inside.left(), inside.top(), line * 4, line * 3);
  const double ratio = painter->device()->devicePixelRatioF();
  const QPixmap picture =
      thumbnails_ == nullptr
          ? QPixmap()
          : thumbnails_->get(row.picture, (QSizeF(frame.size()) * ratio).toSize());
  if (!picture.isNull()) {
    const QSize fit = picture.size().scaled(frame.size(), Qt::KeepAspectRatio);
    painter->drawPixmap(QRect(frame.center() - QPoint(fit.width() / 2, fit.height() / 2), fit),
                        picture);
  }

  const QRect text(frame.right() + line, inside.top(), inside.right() - frame.right() - line,
                   inside.height());
  QFont bold = option.font;
  bold.setBold(true);
  painter->setFont(bold);
  painter->setPen(ink);
  painter->drawText(band(text, 0, line), Qt::AlignLeft | Qt::AlignVCenter, row.number);
  const int number = QFontMetrics(bold).horizontalAdvance(row.number) + line;
  painter->setFont(option.font);
  const Mark mark = markOf(row.state);
  const QRect state = band(text, 0, line).adjusted(number, 0, 0, 0);
  icon(QString::fromLatin1(mark.icon))
      .paint(painter, QRect(state.left(), state.top(), line, line), Qt::AlignCenter,
             selected ? QIcon::Selected : QIcon::Normal);
  painter->setPen(selected ? ink : colours.of(mark.colour));
  const QRect words_at = state.adjusted(line * 3 / 2, 0, 0, 0);
  const QString words_of_state = stateWords(row);
  painter->drawText(words_at, Qt::AlignLeft | Qt::AlignVCenter, words_of_state);

  const QRect lower(text.left(), text.top() + line * 5 / 4, text.width(), line * 9 / 4);
  if (row.figures) {
    // Beside the state, or below it where large letters leave no room.
    const QString figures = figuresWords(*row.figures);
    const int needed = option.fontMetrics.horizontalAdvance(words_of_state) + line +
                       option.fontMetrics.horizontalAdvance(figures);
    painter->setPen(ink);
    if (needed <= words_at.width())
      painter->drawText(words_at, Qt::AlignRight | Qt::AlignVCenter, figures);
    else if (row.state == QueueState::Review || row.state == QueueState::Done)
      painter->drawText(lower, Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, figures);
  }
  if (row.state == QueueState::Busy || row.state == QueueState::Paused) {
    QStyleOptionProgressBar bar;
    bar.rect = QRect(lower.left(), lower.top(), lower.width(), line * 3 / 4);
    bar.minimum = 0;
    bar.maximum = 1000;
    bar.progress = static_cast<int>(1000 * row.progress.fraction);
    bar.textVisible = false;
    bar.palette = option.palette;
    bar.state = QStyle::State_Enabled | QStyle::State_Horizontal;
    QApplication::style()->drawControl(QStyle::CE_ProgressBar, &bar, painter, option.widget);
    QString words = tr("%1, %2 %")
                        .arg(stageWords(row.progress.stage))
                        .arg(static_cast<int>(100 * row.progress.fraction));
    if (const QString left = timeLeftWords(row.progress.seconds_left); !left.isEmpty())
      words += QStringLiteral(", ") + left;
    painter->setPen(ink);
    painter->drawText(lower.adjusted(0, line * 3 / 4, 0, 0), Qt::AlignLeft | Qt::AlignVCenter,
                      words);
  } else if (row.state == QueueState::Failed) {
    painter->setPen(ink);
    painter->drawText(lower, Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, row.failure);
  }
  painter->restore();
}

}  // namespace ostraka::ui
