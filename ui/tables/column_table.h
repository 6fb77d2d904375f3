#pragma once
#include <QTableWidget>

#include "ui/tables/import_model.h"

namespace ostraka::ui {

/// What each column of a table is taken for, with its unit and its first values; a person chooses
/// otherwise.
class ColumnTable final : public QTableWidget {
  Q_OBJECT

 public:
  explicit ColumnTable(ImportModel& model, QWidget* parent = nullptr);
  void fill();
  /// Columns that become custom fields, are left out, or whose unit is guessed.
  static int toCheck(const tables::TableMapping& mapping);

 private:
  QWidget* fieldBox(int row, const tables::ColumnChoice& choice, bool of_contexts);
  QWidget* unitBox(int row, const tables::ColumnChoice& choice);

  ImportModel& model_;
};

}  // namespace ostraka::ui
