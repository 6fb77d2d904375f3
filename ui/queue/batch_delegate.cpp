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

// One row while it is painted: what it shows, where, and in which inks.
class BatchDelegate::Row {
 public:
  Row(QPainter& painter, const QStyleOptionViewItem& option, const QueueRow& row)
      : painter_(painter),
        option_(option),
        row_(row),
        line_(option.fontMetrics.height()),
        selected_((option.state & QStyle::State_Selected) != 0),
        ink_(option.palette.color(selected_ ? QPalette::HighlightedText : QPalette::Text)) {
    const QRect inside = option.rect.adjusted(line_ / 2, line_ / 2, -line_ / 2, -line_ / 2);
    frame_ = QRect(inside.left(), inside.top(), line_ * 4, line_ * 3);
    text_ = QRect(frame_.right() + line_, inside.top(), inside.right() - frame_.right() - line_,
                  inside.height());
    lower_ = QRect(text_.left(), text_.top() + line_ * 5 / 4, text_.width(), line_ * 9 / 4);
  }

  void ground(bool odd) const {
    painter_.fillRect(option_.rect, selected_ ? option_.palette.highlight()
                                    : odd     ? option_.palette.alternateBase()
                                              : option_.palette.base());
    if ((option_.state & QStyle::State_HasFocus) == 0) return;
    painter_.setPen(QPen(ink_, lineWidth(*option_.widget)));
    painter_.drawRect(option_.rect.adjusted(1, 1, -2, -2));
  }

  void picture(Thumbnails* thumbnails) const {
    if (thumbnails == nullptr) return;
    const double ratio = painter_.device()->devicePixelRatioF();
    const QPixmap picture = thumbnails->get(row_.picture, (QSizeF(frame_.size()) * ratio).toSize());
    if (picture.isNull()) return;
    const QSize fit = picture.size().scaled(frame_.size(), Qt::KeepAspectRatio);
    painter_.drawPixmap(QRect(frame_.center() - QPoint(fit.width() / 2, fit.height() / 2), fit),
                        picture);
  }

  // Number, state and figures; what finds no room beside the state stands below it.
  void words() const {
    QFont bold = option_.font;
    bold.setBold(true);
    painter_.setFont(bold);
    painter_.setPen(ink_);
    painter_.drawText(band(text_, 0, line_), Qt::AlignLeft | Qt::AlignVCenter, row_.number);
    const int number = QFontMetrics(bold).horizontalAdvance(row_.number) + line_;
    painter_.setFont(option_.font);
    const Mark mark = markOf(row_.state);
    const QRect state = band(text_, 0, line_).adjusted(number, 0, 0, 0);
    icon(QString::fromLatin1(mark.icon))
        .paint(&painter_, QRect(state.left(), state.top(), line_, line_), Qt::AlignCenter,
               selected_ ? QIcon::Selected : QIcon::Normal);
    painter_.setPen(selected_ ? ink_ : StateColours(option_.palette).of(mark.colour));
    const QRect words_at = state.adjusted(line_ * 3 / 2, 0, 0, 0);
    painter_.drawText(words_at, Qt::AlignLeft | Qt::AlignVCenter, stateWords(row_));
    painter_.setPen(ink_);
    QStringList below;
    if (row_.figures) {
      const QString figures = figuresWords(*row_.figures);
      const int needed = option_.fontMetrics.horizontalAdvance(stateWords(row_)) + line_ +
                         option_.fontMetrics.horizontalAdvance(figures);
      if (needed <= words_at.width())
        painter_.drawText(words_at, Qt::AlignRight | Qt::AlignVCenter, figures);
      else if (row_.state == QueueState::Review || row_.state == QueueState::Done)
        below << figures;
    }
    if (row_.state == QueueState::Review && !row_.scale_doubts.isEmpty())
      below << row_.scale_doubts;
    if (row_.figures && !row_.figures->moved.empty()) below << movedWords(*row_.figures);
    if (row_.state == QueueState::Failed) below << row_.failure;
    painter_.drawText(lower_, Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap,
                      below.join(QLatin1Char('\n')));
  }

  void progress() const {
    if (row_.state != QueueState::Busy && row_.state != QueueState::Paused) return;
    QStyleOptionProgressBar bar;
    bar.rect = QRect(lower_.left(), lower_.top(), lower_.width(), line_ * 3 / 4);
    bar.minimum = 0;
    bar.maximum = 1000;
    bar.progress = static_cast<int>(1000 * row_.progress.fraction);
    bar.textVisible = false;
    bar.palette = option_.palette;
    bar.state = QStyle::State_Enabled | QStyle::State_Horizontal;
    QApplication::style()->drawControl(QStyle::CE_ProgressBar, &bar, &painter_, option_.widget);
    QString words = BatchDelegate::tr("%1, %2 %")
                        .arg(stageWords(row_.progress.stage))
                        .arg(static_cast<int>(100 * row_.progress.fraction));
    if (const QString left = timeLeftWords(row_.progress.seconds_left); !left.isEmpty())
      words += QStringLiteral(", ") + left;
    painter_.setPen(ink_);
    painter_.drawText(lower_.adjusted(0, line_ * 3 / 4, 0, 0), Qt::AlignLeft | Qt::AlignVCenter,
                      words);
  }

 private:
  QPainter& painter_;
  const QStyleOptionViewItem& option_;
  const QueueRow& row_;
  int line_;
  bool selected_;
  QColor ink_;
  QRect frame_, text_, lower_;
};

void BatchDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const {
  painter->save();
  painter->setRenderHint(QPainter::SmoothPixmapTransform);
  const Row row(*painter, option, queue_.row(index.row()));
  row.ground(index.row() % 2 != 0);
  row.picture(thumbnails_);
  row.words();
  row.progress();
  painter->restore();
}

}  // namespace ostraka::ui
