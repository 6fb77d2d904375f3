#pragma once
#include <QDateTime>
#include <QObject>
#include <QPointer>
#include <QString>
#include <functional>

#include "intake/compute_batch.h"
#include "ui/jobs/job.h"

namespace ostraka::ui {

class ProjectSession;

/// Computes one batch at a time in the background. What is computed when its project closes is
/// asked to stop, and nothing begins before that has ended.
class BatchComputation final : public QObject {
  Q_OBJECT

 public:
  explicit BatchComputation(QObject* parent);

  /// Unset: intake::computeBatch. For tests.
  void setWork(intake::ComputeWork work);
  void setThreads(int threads) { threads_ = threads; }
  /// Unset: the computer's. For tests.
  void setClock(std::function<QDateTime()> clock) { clock_ = std::move(clock); }

  bool isBusy() const { return job_ != nullptr; }
  const QString& number() const { return number_; }  ///< of the batch; empty: nothing is computed
  bool isDraft() const { return draft_; }
  JobProgress progress() const;
  /// What the batch will take in all, by its photographs; 0: not known. Seconds of one core.
  double estimate_s() const { return estimate_s_; }
  /// Asks only if much work would be lost: how long the batch has been computed, in seconds.
  double secondsOf(const QString& number) const;
  /// A person stopped what is computed, or what was computed last.
  bool isCancelled() const { return cancelled_; }
  /// The computation of a session that was closed has not ended yet; `left` follows.
  bool isLeaving() const { return leaving_ != nullptr; }

  /// Nothing may be computed or leaving.
  void begin(ProjectSession& session, const QString& number, bool draft);
  void setPaused(bool paused);
  void cancel();  ///< a person does not want it
  void stop();    ///< something else comes first; whole stages stay on the disk
  void leave();   ///< its project closes: asked to stop, and nothing of it is told but `left`

 signals:
  void progressed(const ostraka::ui::JobProgress& progress);
  void noted(ostraka::NoteLevel level, const QString& text);
  void finished(const QString& number, const ostraka::ui::JobOutcome& outcome);
  void left();

 private:
  void end(const JobOutcome& outcome);

  intake::ComputeWork work_;
  std::function<QDateTime()> clock_ = [] { return QDateTime::currentDateTime(); };
  int threads_ = 0;
  QPointer<JobHandle> job_;
  QPointer<JobHandle> leaving_;  ///< of a session that closed: nothing starts before it ended
  QString number_;
  QDateTime since_;
  double estimate_s_ = 0;
  bool draft_ = false, cancelled_ = false;
};

}  // namespace ostraka::ui
