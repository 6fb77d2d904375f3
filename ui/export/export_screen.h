#pragma once
#include "ui/export/export_model.h"
#include "ui/frame/screen.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QRadioButton;

namespace ostraka::ui {

class SurfaceChoice;

/// What, in which forms, where to; size and time before it starts, progress, and a closing line.
class ExportScreen final : public Screen {
  Q_OBJECT

 public:
  explicit ExportScreen(QWidget* parent = nullptr);

  void openProject(ProjectSession& session) override;
  void closeProject() override;
  QAbstractButton* primary() const override;
  QString losesByClosing() const override;
  void takeChosen(const QString& what) override;
  ExportModel& model() { return model_; }

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 public slots:
  /// "rows:1,2,3" or "filter:LINE", from the catalogue.
  void showItem(const QString& what) override;

 private:
  void buildLayout();
  QWidget* buildWhat();
  QWidget* buildForms();
  QWidget* buildWhere();
  QWidget* buildScale(QWidget* box);
  QWidget* buildSurface(QWidget* box);
  QWidget* buildDetail(QWidget* box);
  using What = ExportSelection::What;
  void choose(What what, const QString& filter = {});
  void refresh();
  void browse();

  ExportModel model_;
  QRadioButton* all_ = nullptr;
  QRadioButton* filtered_ = nullptr;
  QRadioButton* chosen_ = nullptr;
  QRadioButton* archive_ = nullptr;
  QLineEdit* filter_ = nullptr;
  std::vector<std::pair<QCheckBox*, exchange::Form>> forms_;
  QComboBox* scale_ = nullptr;
  SurfaceChoice* surface_ = nullptr;
  QComboBox* detail_ = nullptr;
  QLineEdit* target_ = nullptr;
  QLabel* size_ = nullptr;
  QLabel* problem_ = nullptr;
  QLabel* closing_ = nullptr;
  QProgressBar* bar_ = nullptr;
  QPushButton* start_ = nullptr;
  QPushButton* cancel_ = nullptr;
  QAction* stop_ = nullptr;
  QPushButton* open_ = nullptr;
};

}  // namespace ostraka::ui
