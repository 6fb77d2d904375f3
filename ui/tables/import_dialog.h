#pragma once
#include <QDialog>

#include "ui/tables/import_model.h"

class QCheckBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QTabWidget;
class QTableWidget;
class QTableWidgetItem;

namespace ostraka::ui {

class ColumnTable;

/// Reads a table or an export into the project: choose it, see what each row would do and why
/// others are refused, what its columns are taken for, confirm what is asked, then enter it.
/// Nothing is taken before, nor when it is stopped.
class ImportDialog final : public QDialog {
  Q_OBJECT

 public:
  explicit ImportDialog(ImportModel& model, QWidget* parent = nullptr);

 signals:
  void mergeWanted();  ///< of a whole project

 private:
  void buildLayout();
  void refresh();
  void fill();
  void showColumns();
  void confirmed(QTableWidgetItem* item);
  void leave();
  void chooseTable();
  void chooseExport();
  void saveRefusals();

  ImportModel& model_;
  QPushButton *choose_table_ = nullptr, *choose_export_ = nullptr, *merge_ = nullptr;
  QLabel* source_ = nullptr;
  QCheckBox* places_ = nullptr;
  QLabel* summary_ = nullptr;
  QLabel* problem_ = nullptr;
  QTabWidget* tabs_ = nullptr;
  ColumnTable* columns_ = nullptr;
  QTableWidget* table_ = nullptr;
  QProgressBar* bar_ = nullptr;
  QPushButton* refusals_ = nullptr;
  QPushButton* confirm_ = nullptr;
  QPushButton* cancel_ = nullptr;
  QPushButton* enter_ = nullptr;
  const void* filled_ = nullptr;  ///< rows that the table shows
  QString shown_;                 ///< source whose columns were shown first
};

}  // namespace ostraka::ui
