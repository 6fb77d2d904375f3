#pragma once
#include <QFormLayout>
#include <QLabel>
#include <QVBoxLayout>

#include "ui/look/look.h"

namespace ostraka::ui {

/// One column of labels as wide on every page, right-aligned and as high as their fields, so that
/// the words stand beside the middle of tall fields; and fields that are not as wide as the screen.
inline void alignForm(const QFormLayout& form) {
  for (int row = 0; row < form.rowCount(); ++row) {
    const QLayoutItem* field = form.itemAt(row, QFormLayout::FieldRole);
    const QLayoutItem* label = form.itemAt(row, QFormLayout::LabelRole);
    if (field == nullptr || label == nullptr || label->widget() == nullptr) continue;
    const int high = qMax(field->sizeHint().height(), field->minimumSize().height());
    label->widget()->setMinimumHeight(high);
    label->widget()->setMinimumWidth(Look::kLabelColumn);
    if (auto* words = qobject_cast<QLabel*>(label->widget())) {
      words->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
      words->setWordWrap(true);
    }
    if (field->widget() != nullptr) field->widget()->setMaximumWidth(Look::kField);
  }
}

/// The form of one part of a page, below its heading.
inline QFormLayout* titledForm(QWidget* part, const QString& words) {
  auto* heading = new QLabel(words, part);
  heading->setFont(scaledFont(*part, Look::kSection, true));
  auto* form = new QFormLayout;
  auto* column = bareLayout<QVBoxLayout>(part);
  column->addWidget(heading);
  column->addLayout(form);
  return form;
}

}  // namespace ostraka::ui
