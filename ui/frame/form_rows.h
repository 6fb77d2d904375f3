#pragma once
#include <QFormLayout>
#include <QLabel>

namespace ostraka::ui {

/// Labels as high as their fields, so that the words stand beside the middle of tall fields.
inline void centreLabels(const QFormLayout& form) {
  for (int row = 0; row < form.rowCount(); ++row) {
    const QLayoutItem* field = form.itemAt(row, QFormLayout::FieldRole);
    const QLayoutItem* label = form.itemAt(row, QFormLayout::LabelRole);
    if (field == nullptr || label == nullptr || label->widget() == nullptr) continue;
    const int high = qMax(field->sizeHint().height(), field->minimumSize().height());
    label->widget()->setMinimumHeight(high);
  }
}

}  // namespace ostraka::ui
