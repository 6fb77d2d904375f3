#pragma once
#include <QObject>
#include <QPointer>
#include <QString>

#include "catalogue/queue_pause.h"

namespace ostraka::ui {

class ProjectSession;

/// What a person switches in the queue: whether it stands still, and whether drafts come first. The
/// project remembers both.
class QueueSwitches final : public QObject {
  Q_OBJECT

 public:
  explicit QueueSwitches(QObject* parent) : QObject(parent) {}

  /// As the project was left; null: it is closed, and nothing can be switched.
  void setSession(ProjectSession* session);

  bool isPaused() const { return pause_ != catalogue::QueuePause::None; }
  /// The project came out of an archive, and nobody let its queue go on yet.
  bool isRestored() const { return pause_ == catalogue::QueuePause::Restored; }
  /// Each batch is computed as a draft first, and finally when it is computed again. A draft is
  /// for the eye of who still has the sherds in hand: what is being made final waits for it, and
  /// goes on from its last whole stage.
  bool makesDrafts() const { return drafts_; }
  /// Why the queue stopped by itself (the disk is full, a write was refused); empty otherwise.
  const QString& trouble() const { return trouble_; }
  /// Paused until a person lets it go on, or the project is opened again. Tells nobody.
  void stopFor(const QString& trouble);

 public slots:
  void setPaused(bool paused);
  void togglePaused() { setPaused(!isPaused()); }
  void setMakesDrafts(bool drafts);

 signals:
  void pausedChanged(bool paused);

 private:
  QPointer<ProjectSession> session_;
  catalogue::QueuePause pause_ = catalogue::QueuePause::None;
  bool drafts_ = false;
  QString trouble_;
};

}  // namespace ostraka::ui
