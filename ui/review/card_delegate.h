#pragma once
#include <QRect>
#include <QStyledItemDelegate>

namespace ostraka::ui {

class CardListModel;

/// A card: front and back in small, their names, the state in colour, mark and word, the reason.
class CardDelegate final : public QStyledItemDelegate {
  Q_OBJECT

 public:
  CardDelegate(const CardListModel& cards, QObject* parent);  ///< what its view shows
  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override;
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

  /// Where the back's picture lies on a card: what a person drags onto another card.
  static QRect backPicture(const QRect& card, const QFontMetrics& metrics);

 private:
  const CardListModel& cards_;
};

}  // namespace ostraka::ui
