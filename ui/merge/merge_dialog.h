#pragma once
#include <QDialog>

#include "ui/frame/term_words.h"
#include "ui/merge/merge_model.h"

class QAction;
class QLabel;
class QLineEdit;
class QPlainTextEdit;
class QProgressBar;
class QPushButton;
class QTableWidget;

namespace ostraka::ui {

/// Another project comes into the open one: choose it, see what comes, settle what both say
/// differently side by side, then enter it. Nothing is changed before, nor when it is stopped.
class MergeDialog final : public QDialog {
  Q_OBJECT

 public:
  explicit MergeDialog(MergeModel& model, QWidget* parent = nullptr);

 private:
  void buildLayout();
  void buildTable();
  QWidget* buildSettling();
  void refresh();
  void fill();
  void showDecisions();
  void showChoices();
  QString decisionWords(const merge::Conflict& conflict) const;
  std::vector<int> selected() const;
  bool offered(merge::Take take) const;  ///< by one of those selected
  /// The conflict about a number of two sherds that is selected alone; null: none.
  const merge::Conflict* twoSherds() const;
  void settle(merge::Take take);
  void selectNext(int after);
  void chooseFolder();
  void leave();

  MergeModel& model_;
  TermWords terms_;
  QPushButton* choose_ = nullptr;
  QLabel *source_ = nullptr, *summary_ = nullptr, *notes_ = nullptr;
  QTableWidget* table_ = nullptr;
  QWidget* settling_ = nullptr;
  QAction *this_ = nullptr, *other_ = nullptr, *renumber_ = nullptr, *undo_ = nullptr;
  QPushButton *keep_ = nullptr, *number_ = nullptr, *rest_ = nullptr, *copy_ = nullptr;
  QLineEdit* new_number_ = nullptr;
  QPlainTextEdit* numbers_ = nullptr;
  QProgressBar* bar_ = nullptr;
  QPushButton *cancel_ = nullptr, *enter_ = nullptr;
  const void* filled_ = nullptr;  ///< conflicts that the table shows
};

}  // namespace ostraka::ui
