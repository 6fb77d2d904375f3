#pragma once
#include <QStyledItemDelegate>

namespace ostraka::ui {

class BatchQueue;
struct QueueRow;
class Thumbnails;

/// A row of the queue: picture, number, state in words with its icon, bar with stage and time left,
/// figures; the reason of a failure.
class BatchDelegate final : public QStyledItemDelegate {
  Q_OBJECT

 public:
  BatchDelegate(const BatchQueue& queue, QObject* parent);
  void setThumbnails(Thumbnails* thumbnails) { thumbnails_ = thumbnails; }

  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override;

 private:
  static void drawProgress(QPainter& painter, const QStyleOptionViewItem& option,
                           const QueueRow& row, const QRect& where);

  const BatchQueue& queue_;
  Thumbnails* thumbnails_ = nullptr;
};

}  // namespace ostraka::ui
