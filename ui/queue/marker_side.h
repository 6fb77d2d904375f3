#pragma once
#include <QObject>
#include <QPointer>
#include <QWidget>

#include "base/result.h"
#include "ui/jobs/job.h"

namespace ostraka::ui {

class ProjectSession;

/// The side of a marker of a batch by hand, typed anew: its plate.json gets that size, the
/// catalogue the new file, and the batch is to be computed again from what depends on it.
class MarkerSide final : public QObject {
  Q_OBJECT

 public:
  explicit MarkerSide(QWidget* screen) : QObject(screen), screen_(screen) {}
  void setSession(ProjectSession* session);
  /// A rig's batch has the scale of its rig.
  bool isTyped(const QString& batch) const;
  void ask(const QString& batch);

 signals:
  void changed(const QString& batch);
  void failed(const ostraka::Error& error);

 private:
  void apply(const QString& batch, double side_mm);

  QWidget* screen_;
  QPointer<ProjectSession> session_;
  QPointer<JobHandle> job_;
};

}  // namespace ostraka::ui
