#pragma once
#include <QStyledItemDelegate>

namespace ostraka::ui {

/// The column of the numbers: where one finds no room its beginning gives way, which many share;
/// its end tells it from the others.
class NumberDelegate final : public QStyledItemDelegate {
  Q_OBJECT

 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override;
};

}  // namespace ostraka::ui
