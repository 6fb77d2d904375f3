#pragma once
#include <QWidget>

class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace ostraka::ui {

class NumberingModel;
class ProjectSession;

/// Part of the settings: how the sherds of the open project are numbered from now on.
class NumberingEdit final : public QWidget {
  Q_OBJECT

 public:
  explicit NumberingEdit(QWidget* parent = nullptr);
  /// Hidden without a project.
  void setSession(ProjectSession* session);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void buildLayout();
  void showModel();
  void showGaps();
  void apply();

  NumberingModel* model_;
  QLineEdit* scheme_;
  QSpinBox *first_, *last_;
  QLabel *example_, *told_, *gaps_;
  QPushButton* apply_;
};

}  // namespace ostraka::ui
