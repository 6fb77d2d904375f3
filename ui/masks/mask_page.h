#pragma once
#include <QWidget>

class QAbstractButton;
class QAction;
class QComboBox;
class QLabel;
class QSlider;

namespace ostraka::ui {

class BigButton;
class MaskModel;
class MaskView;
class ProjectSession;
class ToolRow;

/// Shows the masks of a batch and lets a person edit them with a brush.
class MaskPage final : public QWidget {
  Q_OBJECT

 public:
  explicit MaskPage(QWidget* parent = nullptr);
  void openBatch(ProjectSession& session, const QString& batch);
  void closeBatch();
  QAbstractButton* primary() const;
  void setCompact(bool compact);

 signals:
  void closed();
  void computeWanted(const QString& batch);

 private:
  void buildLayout();
  void showModel();
  void showTold();
  void useBrush();
  void step(int by);

  MaskModel* model_;
  MaskView* view_;
  QLabel *title_, *told_;
  QComboBox* which_;
  QSlider* width_;
  ToolRow* tools_;
  BigButton* reprocess_;
  QAction *back_, *sherd_, *plate_, *next_, *previous_, *compute_;
};

}  // namespace ostraka::ui
