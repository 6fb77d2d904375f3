#pragma once
#include <QPointer>

#include "ui/frame/screen.h"

class QAction;
class QListView;
class QPlainTextEdit;
class QPushButton;
class QStackedWidget;
class QVBoxLayout;

namespace ostraka::ui {

class BatchDelegate;
class BatchImporter;
class BatchQueue;
enum class QueueState;
class BigButton;
class MarkerSide;
class MaskPage;
class PageArea;
class MessagePanel;
class NoBatchYet;
class Thumbnails;
class ToolRow;

/// The queue on the screen: a row a batch, pause, cancel, again, report, log.
class QueueScreen final : public Screen {
  Q_OBJECT

 public:
  explicit QueueScreen(BatchQueue* queue, QWidget* parent = nullptr);

  void openProject(ProjectSession& session) override;
  void closeProject() override;
  int waiting() const override;
  QString waitingText() const override;
  void showItem(const QString& batch) override;
  void setInFront(bool in_front) override;
  QAbstractButton* primary() const override;
  QString whereWords() const override;
  void setCompact(bool compact) override;

  QAction* pauseAction() const { return pause_; }
  QAction* logAction() const { return log_action_; }
  QWidget* masksPage() const;
  /// Shows how far an import is whose batch comes into the queue.
  void showImportsOf(BatchImporter* importer);

 private:
  void buildLayout();
  QString selected() const;
  void follow();
  void followPause();
  void followReadOnly();
  void openReport();
  void openSelected();
  void followNext(QueueState state);
  void followStop();
  QWidget* buildList();
  void askOrCancel();
  void followCancel(QueueState state, bool aside, bool stopping);
  void showMasks();
  void leaveMasks();

  BatchQueue* queue_;
  int waiting_said_ = -1;
  bool stop_shown_ = false;  ///< why the queue stands still
  QPointer<ProjectSession> session_;
  Thumbnails* thumbnails_ = nullptr;
  QListView* list_;
  BatchDelegate* delegate_;
  QPlainTextEdit* log_;
  MessagePanel* message_;
  bool log_wanted_ = false;  ///< when the page is in front
  bool in_front_ = false;
  QString asked_about_;  ///< the batch that the message names, whichever is chosen by then
  QStackedWidget* pages_;
  MaskPage* masks_page_;
  PageArea* masks_area_;
  QAction *pause_, *cancel_, *again_, *report_, *review_, *masks_, *log_action_, *drafts_,
      *calibrate_, *open_, *marker_action_, *keep_both_;
  MarkerSide* marker_side_;
  BigButton* next_;
  NoBatchYet* empty_;
  QVBoxLayout* column_;
  ToolRow* tools_;
};

}  // namespace ostraka::ui
