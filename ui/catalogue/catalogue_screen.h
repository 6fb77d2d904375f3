#pragma once
#include <QPointer>

#include "catalogue/catalogue.h"
#include "records/sherd.h"
#include "ui/frame/screen.h"

class QAction;
class QLabel;
class QPushButton;
class QStackedWidget;
class QTabWidget;
class QTableView;
class QToolButton;

namespace ostraka::ui {

class BulkEdit;
class CompareWindow;
class DrawingPage;
class EmptyState;
class FilterLine;
class ImportDialog;
class ImportModel;
class MergeDialog;
class MergeModel;
class ModelPane;
class NoBatchYet;
class PlacesDialog;
class SherdDetails;
class SherdEdits;
class SherdTableModel;

/// All sherds: filter line with chips, table with pictures; at the right the model and the details
/// of the one that is chosen, or the edit of many, and beside them their drawing.
class CatalogueScreen final : public Screen {
  Q_OBJECT

 public:
  explicit CatalogueScreen(QWidget* parent = nullptr);

  void openProject(ProjectSession& session) override;
  void closeProject() override;
  QString losesByClosing() const override;
  void setInFront(bool in_front) override;
  QAbstractButton* primary() const override;
  void setCompact(bool compact) override;
  QString chosen() const override;

 public slots:
  /// A sherd's number, a batch's number, or a filter line.
  void showItem(const QString& what) override;

 private:
  void buildLayout();
  void addActions();
  void showSelection();
  void showNewRows();
  void reload();
  void choose(const std::vector<store::SherdRow>& sherds, store::SherdRow current);
  void showCount();
  void showModelOf(store::SherdRow sherd);
  void followModel();
  QWidget* buildFilterLine();
  QWidget* buildWho();
  QWidget* buildLeft();
  QWidget* buildRight();
  std::vector<store::SherdRow> selected() const;
  void saveField(const QString& field, const QString& value);
  void keepField(const QString& field, const QString& value,
                 records::Confirmation confirmation = records::Confirmation::None);
  void move(const QStringList& place);
  void changeAll(const std::vector<records::FieldChange>& changes);
  void giveNumbers();
  void openImport();
  void openMerge();
  void renamePlaces();
  void tookProject(const QString& sentence);
  void openDetails();
  void compare();
  void printLabels();
  void sherdsChanged(const std::vector<store::SherdRow>& sherds);
  void tellOfImports();
  void forgetImports();
  void complain(const QString& sentence);

  ProjectSession* session_ = nullptr;
  SherdEdits* edits_ = nullptr;
  SherdTableModel* model_ = nullptr;
  FilterLine* filter_ = nullptr;
  QLabel* problem_ = nullptr;
  QWidget* who_ = nullptr;
  QTableView* table_ = nullptr;
  QStackedWidget* left_ = nullptr;
  NoBatchYet* none_ = nullptr;
  EmptyState* no_match_ = nullptr;
  QPushButton *clear_ = nullptr, *export_ = nullptr;
  QToolButton* show_model_ = nullptr;  ///< in a compact window in place of the details
  bool compact_ = false;
  QTabWidget* right_ = nullptr;
  QStackedWidget* edit_ = nullptr;  ///< one sherd or many
  QWidget* one_ = nullptr;
  ModelPane* model_pane_ = nullptr;
  DrawingPage* drawing_ = nullptr;
  int drawing_tab_ = 1;
  ImportModel* import_ = nullptr;
  QPointer<ImportDialog> import_dialog_;
  MergeModel* merge_ = nullptr;
  QPointer<MergeDialog> merge_dialog_;
  QPointer<PlacesDialog> places_dialog_;
  QAction* compare_ = nullptr;
  QPointer<CompareWindow> compare_window_;
  SherdDetails* details_ = nullptr;
  BulkEdit* bulk_ = nullptr;
  QWidget* many_ = nullptr;  ///< bulk_, scrolled where it has to be
  bool stale_ = false;       ///< rows came or went while another screen was in front
  bool reloading_ = false;   ///< what was chosen is not chosen again yet
};

}  // namespace ostraka::ui
