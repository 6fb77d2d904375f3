#pragma once
#include <QDateTime>
#include <QPointer>
#include <QWidget>

#include "ui/jobs/job.h"

class QLabel;
class QStackedWidget;
class QToolButton;

namespace ostraka::ui {

class JobRunner;
class SherdView;

/// The sherd that is chosen: its picture at once, its model to be turned as soon as a worker has
/// read it. The view in three dimensions is made when the first model is shown; without OpenGL the
/// picture stays.
class ModelPane final : public QWidget {
  Q_OBJECT

 public:
  explicit ModelPane(QWidget* parent = nullptr);

  /// Whole paths; empty where there is none.
  void showSherd(JobRunner& jobs, const QString& picture, const QString& model);
  void clear();
  bool showsModel() const;
  QSize sizeHint() const override;

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  void fetch();
  void showPicture();
  SherdView* view();

  JobRunner* jobs_ = nullptr;
  QString picture_file_, model_file_;
  QDateTime written_;  ///< the model
  QPixmap picture_;
  QPointer<JobHandle> reading_;
  QStackedWidget* pages_ = nullptr;
  QLabel* label_ = nullptr;
  SherdView* view_ = nullptr;
  QWidget* acts_ = nullptr;
  QToolButton* section_ = nullptr;
};

}  // namespace ostraka::ui
