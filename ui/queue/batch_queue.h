#pragma once
#include <QAbstractListModel>
#include <QPointer>
#include <QStringList>
#include <optional>
#include <vector>

#include "intake/batch_figures.h"
#include "ui/jobs/job.h"

namespace ostraka::records {
struct BatchRecord;
}

namespace ostraka::ui {

class BatchComputation;
class ProjectSession;
class QueueSwitches;
struct BatchFailure;

enum class QueueState {
  Shooting,  ///< its photographs are not whole yet
  Waiting,
  Busy,
  Paused,
  Failed,  ///< did not succeed, or was cancelled
  Review,  ///< a person must decide
  Done
};

/// One batch as the queue shows it.
struct QueueRow {
  QString number;
  qint64 batch_row = 0;
  QueueState state = QueueState::Waiting;
  JobProgress progress;
  bool stopping = false;  ///< Busy or Paused: cancelled, and its work has not noticed yet
  bool draft = false;     ///< Busy or Paused: processed as a draft
  double estimate_s = 0;  ///< Busy or Paused: of one core, in all; 0: not known
  QString failure;        ///< the sentence of the error, of Failed
  bool cancelled = false;
  bool aside = false;        ///< Failed, and nobody wants it
  bool shared = false;       ///< Failed: another batch has its photographs, too
  bool without_bag = false;  ///< its sherds have no context but by hand
  bool has_masks = false;
  bool masks_edited = false;  ///< Review: since its results were computed
  QString scale_doubts;       ///< why no measure is sure, a sentence a line
  std::optional<intake::BatchFigures> figures;
  QString picture, about;  ///< a photograph of the front; bag, day and count where known
};

/// The batches of the project, newest first, and their computation one after the other. What is
/// to be done stands in the catalogue, so that it outlives the window: a batch whose state is
/// Queued or Computed is computed as soon as the queue is open and not paused.
class BatchQueue final : public QAbstractListModel {
  Q_OBJECT

 public:
  explicit BatchQueue(QObject* parent = nullptr);

  /// Null closes: a computation is asked to stop and goes on when the project is opened again.
  void setSession(ProjectSession* session);
  /// What computes its batches.
  BatchComputation* computation() const { return computation_; }
  /// What a person switches in it.
  QueueSwitches* switches() const { return switches_; }

  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  const QueueRow& row(int row) const { return rows_.at(static_cast<std::size_t>(row)); }
  int rowOf(const QString& number) const;  ///< -1: none

  /// What the computer does now, for the line at the foot.
  QString workWords() const;
  double workFraction() const;  ///< below 0: nothing is computed
  int waitingToCompute() const;
  int failed() const;
  int unfinished() const;  ///< neither done nor set aside
  /// The log of the batch that is computed or was computed last, newest line last.
  const QStringList& log() const { return log_; }

 public slots:
  void cancel(const QString& number);
  /// Nobody wants this batch, failed or not photographed to its end: it asks for nobody any more,
  /// and what there is of it stays. retry() brings it back, also to be photographed on.
  void setAside(const QString& number);
  void retry(const QString& number);
  /// Retries what shares photographs with another batch: its sherds are wanted twice.
  void keepBoth(const QString& number);
  /// The rig was calibrated again by this batch: its cameras stand where the rig has them.
  void forgetMoved(const QString& number);

 signals:
  void workChanged();  ///< what is computed, how far, or whether it is paused
  void logged(const QString& line);
  void batchComputed(const QString& number);
  void batchFailed(const QString& number, const QString& sentence);

 private:
  /// The catalogue's batches changed.
  void refresh();
  void refreshBatch(const QString& number);
  void followPlaces();
  QueueRow rowFrom(const records::BatchRecord& batch, const QueueRow* before) const;
  void startNext();
  void makeWayForADraft();
  QueueRow* nextToCompute();
  void followProgress(const JobProgress& progress);
  void followPause(bool paused);
  void finish(const QString& number, const JobOutcome& outcome);
  void fail(const QString& number, const BatchFailure& failure);
  void settle(const QString& number);
  void stopFor(const Error& error);
  bool isPhotographed(const QString& number) const;  ///< or again
  void touch(const QString& number);
  QueueRow* find(const QString& number);
  void log(const QString& line);

  QPointer<ProjectSession> session_;
  BatchComputation* computation_;
  QueueSwitches* switches_;
  std::vector<QueueRow> rows_;
  QStringList log_;
};

/// What a person reads for a state and for a stage of the chain.
QString queueStateWords(QueueState state);
QString stateWords(const QueueRow& row);  ///< with what a review left to be done
QString figuresWords(const intake::BatchFigures& figures);
QString movedWords(const intake::BatchFigures& figures);  ///< empty: no camera was bumped
QString withoutBagWords();
QString stageWords(const QString& stage);
/// How far a batch is that is processed, with what is left or else what it will take in all:
/// "Draft: Closing the models, 80 %, about 2 min left".
QString progressWords(const QueueRow& row);

}  // namespace ostraka::ui
