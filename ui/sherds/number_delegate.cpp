#include "ui/sherds/number_delegate.h"

namespace ostraka::ui {

void NumberDelegate::initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const {
  QStyledItemDelegate::initStyleOption(option, index);
  const bool is_number = !option->text.isEmpty() && option->text.back().isDigit();
  option->textElideMode = is_number ? Qt::ElideLeft : Qt::ElideRight;
}

}  // namespace ostraka::ui
