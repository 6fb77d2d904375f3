#pragma once
#include <QDateTime>
#include <QPointer>
#include <QWidget>
#include <filesystem>

#include "records/sherd.h"
#include "ui/jobs/job.h"

class QLabel;
class QStackedWidget;
class QToolButton;

namespace ostraka::ui {

class JobRunner;
class SherdView;

/// The sherd that is chosen: its picture at once, its model to be turned as soon as a worker has
/// read it. The view in three dimensions is made when the first model is shown; without OpenGL the
/// picture stays. Where the pane takes the focus, the arrow keys turn the model.
class ModelPane final : public QWidget {
  Q_OBJECT

 public:
  explicit ModelPane(QWidget* parent = nullptr);

  void showSherd(JobRunner& jobs, const std::filesystem::path& project,
                 const records::SherdRecord& sherd);
  void clear();
  bool showsModel() const;
  /// Null before the first model was shown.
  SherdView* modelView() const { return view_; }
  /// A sentence; empty: the model is shown, or on its way.
  const QString& whyNoModel() const { return why_no_model_; }
  bool isLarge() const;  ///< a person wants nothing beside the model
  void hideActs();       ///< the page around has them, for more than this one
  QSize sizeHint() const override;

 public slots:
  void setLarge(bool large);

 signals:
  void settled();  ///< the model is shown, or whyNoModel() says why not
  void largeChanged();

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  void fetch();
  void showPicture();
  void settle(const QString& why_no_model);
  SherdView* view();

  JobRunner* jobs_ = nullptr;
  QString picture_file_, model_file_;  ///< whole paths; empty where there is none
  bool has_batch_ = false;             ///< that brings a model
  QDateTime written_;                  ///< the model
  QPixmap picture_;
  QPointer<JobHandle> reading_;
  QStackedWidget* pages_ = nullptr;
  QLabel* label_ = nullptr;
  SherdView* view_ = nullptr;
  QString why_no_model_;
  QWidget* acts_ = nullptr;
  bool has_acts_ = true;
  QToolButton* section_ = nullptr;
  QToolButton* large_ = nullptr;
};

}  // namespace ostraka::ui
