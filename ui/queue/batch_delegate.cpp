#include "ui/queue/batch_delegate.h"

#include <QAbstractScrollArea>
#include <QApplication>
#include <QPainter>
#include <QStyleOptionProgressBar>
#include <algorithm>

#include "ui/look/look.h"
#include "ui/queue/batch_queue.h"
#include "ui/widgets/pill.h"
#include "ui/widgets/thumbnails.h"

namespace ostraka::ui {
namespace {

constexpr int kMostLines = 4;  // below the title; the tool tip has all of them

Pill pillOf(const QueueRow& row) {
  const QString word = queueStateWords(row.state);
  if (row.stopping) return {State::Waiting, "stop", stateWords(row)};
  switch (row.state) {
    case QueueState::Shooting:
      return {State::Waiting, "camera", word};
    case QueueState::Waiting:
      return {State::Waiting, "clock", word};
    case QueueState::Busy:
      return {State::Busy, "play", word};
    case QueueState::Paused:
      return {State::Waiting, "pause", word};
    case QueueState::Failed:
      return row.aside ? Pill{State::Aside, "aside", BatchQueue::tr("Set aside")}
                       : Pill{State::Failed, "error", word};
    case QueueState::Review:
      return {State::Ask, "question", word};
    case QueueState::Done:
      return {State::Sure, "check", word};
  }
  return {State::Waiting, "clock", word};
}

// What stands below the title; a batch that is processed has its bar there.
QString wordsBelow(const QueueRow& row) {
  QStringList below;
  if (const QString more = stateWords(row); more != queueStateWords(row.state)) below << more;
  if (row.figures) below << figuresWords(*row.figures);
  if (row.state == QueueState::Review && !row.scale_doubts.isEmpty()) below << row.scale_doubts;
  if (row.figures && !row.figures->moved.empty()) below << movedWords(*row.figures);
  if (row.state == QueueState::Failed) below << row.failure;
  if (row.without_bag) below << withoutBagWords();
  return below.join(QLatin1Char('\n'));
}

bool showsProgress(const QueueRow& row) {
  return row.state == QueueState::Busy || row.state == QueueState::Paused;
}

struct Places {
  QRect picture, pill, title, below;
};

Places placesIn(const QRect& row, const Pill& pill, const QFontMetrics& metrics) {
  Places at;
  const int edge = (Look::kRow - Look::kThumbnail) / 2;
  at.picture =
      QRect(row.left() + edge + Look::kMatte, row.top() + edge, Look::kThumbnail, Look::kThumbnail);
  const QSize size = sizeOf(pill, metrics);
  at.pill = QRect(QPoint(row.right() - size.width() - Look::kGap, row.top() + Look::kGap), size);
  const int left = at.picture.right() + Look::kGroup;
  at.title = QRect(left, row.top() + Look::kGap, std::max(0, at.pill.left() - Look::kGap - left),
                   metrics.height());
  at.below = QRect(left, at.title.bottom() + Look::kGap / 2, at.title.width(),
                   std::max(0, row.bottom() - at.title.bottom() - Look::kGap));
  return at;
}

}  // namespace

BatchDelegate::BatchDelegate(const BatchQueue& queue, QObject* parent)
    : QStyledItemDelegate(parent), queue_(queue) {}

// A failure says why, and a doubt what: as many lines as that takes.
QSize BatchDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
  const auto* list = qobject_cast<const QAbstractScrollArea*>(option.widget);
  const int width = list == nullptr ? Look::kField : list->viewport()->width();
  const QueueRow& row = queue_.row(index.row());
  const QFontMetrics& metrics = option.fontMetrics;
  const Places at = placesIn({0, 0, width, Look::kRow}, pillOf(row), metrics);
  const int lines =
      showsProgress(row)
          ? 2
          : std::clamp(metrics.boundingRect(QRect(0, 0, at.below.width(), QWIDGETSIZE_MAX),
                                            Qt::TextWordWrap, wordsBelow(row))
                               .height() /
                           std::max(1, metrics.lineSpacing()),
                       1, kMostLines);
  return {Look::kField,
          std::max(Look::kRow, at.below.top() + lines * metrics.lineSpacing() + Look::kGap)};
}

void BatchDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const {
  const QueueRow& row = queue_.row(index.row());
  const Pill pill = pillOf(row);
  const Places at = placesIn(option.rect, pill, option.fontMetrics);
  painter->save();
  drawRowGround(*painter, option.rect, option.palette, option.state & QStyle::State_Selected,
                option.state & QStyle::State_HasFocus);
  const double ratio = painter->device()->devicePixelRatioF();
  drawThumbnail(*painter, at.picture,
                thumbnails_ == nullptr
                    ? QPixmap()
                    : thumbnails_->get(row.picture, (QSizeF(at.picture.size()) * ratio).toSize()));
  painter->setFont(option.font);
  drawPill(*painter, at.pill, pill, option.palette);
  const QColor ink = option.palette.color(QPalette::Text);
  QFont bold = option.font;
  bold.setBold(true);
  painter->setFont(bold);
  painter->setPen(ink);
  painter->drawText(at.title, Qt::AlignLeft | Qt::AlignVCenter, row.number);
  const int number = QFontMetrics(bold).horizontalAdvance(row.number) + Look::kGroup;
  painter->setFont(option.font);
  painter->setPen(coloursOf(option.palette).secondary);
  const QRect about = at.title.adjusted(number, 0, 0, 0);
  painter->drawText(about, Qt::AlignLeft | Qt::AlignVCenter,
                    option.fontMetrics.elidedText(row.about, Qt::ElideRight, about.width()));
  painter->setPen(ink);
  if (showsProgress(row))
    drawProgress(*painter, option, row, at.below);
  else
    painter->drawText(at.below, Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, wordsBelow(row));
  painter->restore();
}

void BatchDelegate::drawProgress(QPainter& painter, const QStyleOptionViewItem& option,
                                 const QueueRow& row, const QRect& where) {
  QStyleOptionProgressBar bar;
  bar.rect = QRect(where.left(), where.top() + Look::kGap / 2, where.width(), Look::kGap);
  bar.minimum = 0;
  bar.maximum = 1000;
  bar.progress = static_cast<int>(1000 * row.progress.fraction);
  bar.textVisible = false;
  bar.palette = option.palette;
  bar.state = QStyle::State_Enabled | QStyle::State_Horizontal;
  QApplication::style()->drawControl(QStyle::CE_ProgressBar, &bar, &painter, option.widget);
  painter.drawText(where.adjusted(0, bar.rect.height() + Look::kGap / 2, 0, Look::kGap),
                   Qt::AlignLeft | Qt::AlignVCenter, progressWords(row));
}

}  // namespace ostraka::ui
