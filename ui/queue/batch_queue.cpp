#include "ui/queue/batch_queue.h"

#include <QHash>
#include <QTime>
#include <algorithm>

#include "catalogue/batches.h"
#include "decisions/mask_strokes.h"
#include "intake/batch_figures.h"
#include "intake/computed_again.h"
#include "intake/settle_batch.h"
#include "intake/side_photographs.h"
#include "ui/frame/batch_place.h"
#include "ui/frame/project_session.h"
#include "ui/jobs/when_done.h"
#include "ui/queue/batch_computation.h"
#include "ui/queue/batch_failure.h"
#include "ui/queue/queue_switches.h"
#include "ui/widgets/message_panel.h"
#include "ui/words/sentence.h"
#include "upkeep/project.h"

namespace ostraka::ui {
namespace {

using records::BatchState;

constexpr int kKeptLogLines = 2000;

QueueState stateOf(BatchState state) {
  switch (state) {
    case BatchState::Placed:
    case BatchState::Front:
    case BatchState::Flipped:
    case BatchState::Back:
      return QueueState::Shooting;
    case BatchState::Queued:
    case BatchState::Computed:
      return QueueState::Waiting;
    case BatchState::Review:
      return QueueState::Review;
    case BatchState::Done:
      return QueueState::Done;
    case BatchState::Failed:
      return QueueState::Failed;
  }
  return QueueState::Waiting;
}

// What stands in the catalogue and on the disk beside the state.
void readDetails(const upkeep::Project& project, QueueRow& row) {
  if (row.state == QueueState::Failed) {
    const BatchFailure failure = keptFailure(project.catalogue(), row.number);
    row.failure = wordsOf(failure);
    row.cancelled = failure.cancelled;
    row.aside = failure.aside;
    row.shared = !failure.aside && intake::isAboutShared(failure.error.what);
  }
  row.figures = intake::shownFigures(project.catalogue(), row.number.toStdString());
  row.picture = frontPicture(project.batchFolder(row.number.toStdString()));
}

}  // namespace

BatchQueue::BatchQueue(QObject* parent)
    : QAbstractListModel(parent),
      computation_(new BatchComputation(this)),
      switches_(new QueueSwitches(this)) {
  connect(computation_, &BatchComputation::progressed, this, &BatchQueue::followProgress);
  connect(computation_, &BatchComputation::noted, this,
          [this](NoteLevel level, const QString& text) {
            log(level == NoteLevel::Warning ? tr("Warning: %1").arg(text) : text);
          });
  connect(computation_, &BatchComputation::finished, this, &BatchQueue::finish);
  connect(computation_, &BatchComputation::left, this, &BatchQueue::startNext);
  connect(switches_, &QueueSwitches::pausedChanged, this, &BatchQueue::followPause);
}

void BatchQueue::setSession(ProjectSession* session) {
  computation_->leave();
  if (session_ != nullptr) session_->disconnect(this);
  beginResetModel();
  rows_.clear();
  endResetModel();
  log_.clear();
  session_ = session;
  switches_->setSession(session);
  if (session_ != nullptr) {
    connect(session_, &ProjectSession::batchChanged, this, &BatchQueue::refreshBatch);
    connect(session_, &ProjectSession::sherdsChanged, this, &BatchQueue::followPlaces);
  }
  refresh();
  emit workChanged();
}

QueueRow BatchQueue::rowFrom(const records::BatchRecord& batch, const QueueRow* before) const {
  const upkeep::Project& project = session_->project();
  QueueRow row;
  row.number = QString::fromStdString(batch.number);
  row.batch_row = batch.row.value;
  row.state = stateOf(batch.state);
  row.scale_doubts = wordsOf(batch.scale_doubts);
  row.without_bag = batch.bags.empty();
  row.about = aboutBatch(project.catalogue(), batch);
  if (row.number == computation_->number()) {
    row.state = switches_->isPaused() ? QueueState::Paused : QueueState::Busy;
    row.progress = computation_->progress();
    row.stopping = computation_->isCancelled();
    row.draft = computation_->isDraft();
    row.estimate_s = computation_->estimate_s();
  }
  if (before != nullptr && before->state == row.state) {
    row.failure = before->failure;
    row.cancelled = before->cancelled;
    row.aside = before->aside;
    row.shared = before->shared;
    row.picture = before->picture;
    // A person's decisions change them while the state stays.
    row.figures = intake::shownFigures(project.catalogue(), row.number.toStdString());
  } else {
    readDetails(project, row);
  }
  const std::filesystem::path results = project.resultsFolder(batch.number);
  row.has_masks = decisions::hasMasks(results);
  row.masks_edited = row.state == QueueState::Review && decisions::masksWantComputing(results);
  return row;
}

void BatchQueue::refresh() {
  std::vector<QueueRow> fresh;
  if (session_ != nullptr) {
    QHash<QString, const QueueRow*> before;
    for (const QueueRow& row : rows_) before.insert(row.number, &row);
    const auto batches = catalogue::Batches(session_->project().catalogue()).all();
    for (const records::BatchRecord& batch :
         batches ? *batches : std::vector<records::BatchRecord>())
      fresh.push_back(rowFrom(batch, before.value(QString::fromStdString(batch.number))));
  }
  const bool same =
      fresh.size() == rows_.size() &&
      std::equal(fresh.begin(), fresh.end(), rows_.begin(),
                 [](const QueueRow& a, const QueueRow& b) { return a.number == b.number; });
  if (same) {
    rows_ = std::move(fresh);
    if (!rows_.empty()) emit dataChanged(index(0), index(rowCount() - 1));
  } else {
    beginResetModel();
    rows_ = std::move(fresh);
    endResetModel();
  }
  startNext();
}

// What follows each decision in the review: of thousands of batches only one is read.
void BatchQueue::refreshBatch(const QString& number) {
  QueueRow* row = find(number);
  if (session_ == nullptr || row == nullptr) return refresh();
  const auto batch =
      catalogue::Batches(session_->project().catalogue()).byNumber(number.toStdString());
  if (!batch) return refresh();
  // One of its sides is photographed again: what is computed is of photographs that are put aside.
  if (number == computation_->number() && stateOf(batch->state) == QueueState::Shooting)
    computation_->stop();
  *row = rowFrom(*batch, row);
  touch(number);
  startNext();
}

// A batch is where all of its sherds are by now.
void BatchQueue::followPlaces() {
  const catalogue::Catalogue& catalogue = session_->project().catalogue();
  const auto batches = catalogue::Batches(catalogue).all();
  if (!batches) return;
  for (const records::BatchRecord& batch : *batches)
    if (QueueRow* row = find(QString::fromStdString(batch.number)))
      if (const QString about = aboutBatch(catalogue, batch); about != row->about) {
        row->about = about;
        touch(row->number);
      }
}

int BatchQueue::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

QVariant BatchQueue::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  const QueueRow& shown = row(index.row());
  if (role == Qt::DisplayRole) return shown.number;
  if (role != Qt::AccessibleTextRole) return {};
  QString words = tr("%1: %2").arg(shown.number, stateWords(shown));
  if (shown.figures) words += QStringLiteral(". ") + figuresWords(*shown.figures);
  if (shown.figures && !shown.figures->moved.empty())
    words += QStringLiteral(". ") + movedWords(*shown.figures);
  if (shown.without_bag) words += QStringLiteral(". ") + withoutBagWords();
  if (!shown.failure.isEmpty()) words += QStringLiteral(". ") + shown.failure;
  if (!shown.scale_doubts.isEmpty()) words += QStringLiteral(". ") + shown.scale_doubts;
  return words;
}

int BatchQueue::rowOf(const QString& number) const {
  const auto at = std::ranges::find(rows_, number, &QueueRow::number);
  return at == rows_.end() ? -1 : static_cast<int>(at - rows_.begin());
}

QueueRow* BatchQueue::find(const QString& number) {
  const int at = rowOf(number);
  return at < 0 ? nullptr : &rows_[static_cast<std::size_t>(at)];
}

void BatchQueue::touch(const QString& number) {
  const int at = rowOf(number);
  if (at >= 0) emit dataChanged(index(at), index(at));
}

// Oldest first, and drafts before all that was computed once: rows are newest first.
QueueRow* BatchQueue::nextToCompute() {
  const auto waits = [](const QueueRow& row) { return row.state == QueueState::Waiting; };
  const auto draft = std::find_if(rows_.rbegin(), rows_.rend(), [&](const QueueRow& row) {
    return switches_->makesDrafts() && waits(row) && !row.figures;
  });
  if (draft != rows_.rend()) return &*draft;
  const auto next = std::find_if(rows_.rbegin(), rows_.rend(), waits);
  return next == rows_.rend() ? nullptr : &*next;
}

void BatchQueue::makeWayForADraft() {
  if (!switches_->makesDrafts() || computation_->isDraft() || computation_->isCancelled()) return;
  const QueueRow* next = nextToCompute();
  if (next == nullptr || next->figures) return;
  log(tr("%1 waits for the draft of %2.").arg(computation_->number(), next->number));
  computation_->stop();  // it stays in the queue, and whole stages stay on the disk
}

void BatchQueue::startNext() {
  if (session_ == nullptr || switches_->isPaused() || computation_->isLeaving()) return;
  if (!session_->whyReadOnly().isEmpty()) return;
  if (computation_->isBusy()) return makeWayForADraft();
  QueueRow* next = nextToCompute();
  if (next == nullptr) return;
  next->state = QueueState::Busy;
  next->progress = {};
  next->stopping = false;
  next->estimate_s = 0;
  log_.clear();
  // What has figures was computed before; now it is meant to become final.
  next->draft = switches_->makesDrafts() && !next->figures;
  computation_->begin(*session_, next->number, next->draft);
  touch(computation_->number());
  emit workChanged();
}

void BatchQueue::followProgress(const JobProgress& progress) {
  const QString& number = computation_->number();
  if (QueueRow* row = find(number)) {
    row->progress = progress;
    row->estimate_s = computation_->estimate_s();
  }
  touch(number);
  emit workChanged();
}

void BatchQueue::finish(const QString& number, const JobOutcome& outcome) {
  const Result<intake::BatchFigures> figures = outcomeAs<intake::BatchFigures>(outcome);
  if (figures) {
    log(tr("%1 is ready: %n sherd(s).", nullptr, figures->sherds).arg(number));
  } else if (figures.error().code == ErrorCode::CannotWrite) {
    // A full disk is a pause: the batch stays in the queue and goes on from its last whole stage.
    stopFor(figures.error());
    emit batchFailed(number, sentenceOf(figures.error()));
  } else if (isPhotographed(number)) {
    log(sentenceOf(Error::cancelled()));
  } else if (figures.error().code != ErrorCode::Cancelled || computation_->isCancelled()) {
    const BatchFailure failure{.error = figures.error(),
                               .cancelled = figures.error().code == ErrorCode::Cancelled};
    fail(number, failure);
    log(wordsOf(failure));
    if (!failure.cancelled) emit batchFailed(number, wordsOf(failure));
  }
  emit workChanged();
  if (figures) {
    // Sherds of earlier plates may lie here again.
    for (QueueRow& row : rows_)
      if (row.figures && row.figures->reshoot > 0)
        row.figures =
            intake::shownFigures(session_->project().catalogue(), row.number.toStdString());
    emit batchComputed(number);
  }
  session_->tellBatchChanged(number);  // refreshes, and the next one starts
  if (figures) session_->tellSherdsChanged();
}

bool BatchQueue::isPhotographed(const QString& number) const {
  const auto batch =
      catalogue::Batches(session_->project().catalogue()).byNumber(number.toStdString());
  return batch && stateOf(batch->state) == QueueState::Shooting;
}

void BatchQueue::fail(const QString& number, const BatchFailure& failure) {
  catalogue::Catalogue& rows = session_->project().catalogue();
  Result<void> kept = keepFailure(rows, number, failure);
  if (const QueueRow* row = find(number); kept && row != nullptr)
    kept = catalogue::Batches(rows).setState({row->batch_row}, BatchState::Failed,
                                             session_->provenance(wordsOf(failure)));
  // What still counts as queued would be computed again and again.
  if (!kept) stopFor(kept.error());
}

void BatchQueue::stopFor(const Error& error) {
  switches_->stopFor(sentenceOf(error));
  log(switches_->trouble());
  emit workChanged();
}

void BatchQueue::followPause(bool paused) {
  computation_->setPaused(paused);
  if (computation_->isBusy()) {
    if (QueueRow* row = find(computation_->number()))
      row->state = paused ? QueueState::Paused : QueueState::Busy;
    touch(computation_->number());
  }
  emit workChanged();
  startNext();
}

void BatchQueue::cancel(const QString& number) {
  QueueRow* row = find(number);
  if (computation_->isBusy() && number == computation_->number()) {
    computation_->cancel();
    if (row != nullptr) row->stopping = true;
    touch(number);
    return emit workChanged();
  }
  if (row == nullptr || row->state != QueueState::Waiting) return;
  const BatchFailure removed{.cancelled = true, .removed = true};
  // What was computed once, and only waits to be computed again, is what it was before.
  const upkeep::Project& project = session_->project();
  const Result<bool> as_before = intake::takeOutOfQueue(
      session_->project().catalogue(), number.toStdString(),
      project.resultsFolder(number.toStdString()), session_->provenance(wordsOf(removed)));
  if (!as_before) return stopFor(as_before.error());
  if (*as_before) return settle(number);
  fail(number, removed);
  session_->tellBatchChanged(number);
}

// What was decided while it waited counts.
void BatchQueue::settle(const QString& number) {
  JobHandle* job = session_->jobs().start(
      makeJob([project = session_->folder(), number = number.toStdString(),
               person = session_->initials().toStdString()](Progress&, std::stop_token) {
        return intake::settleByResults(project, number, person);
      }),
      session_);
  whenDone<bool>(job, session_,
                 [session = session_, number](const auto&) { session->tellBatchChanged(number); });
  session_->tellBatchChanged(number);
}

void BatchQueue::setAside(const QString& number) {
  QueueRow* row = find(number);
  if (session_ == nullptr || row == nullptr || row->aside) return;
  if (row->state != QueueState::Failed && row->state != QueueState::Shooting) return;
  BatchFailure how{.cancelled = true, .aside = true};
  const auto batch = catalogue::Batches(session_->project().catalogue()).get({row->batch_row});
  if (!batch) return;
  if (row->state == QueueState::Shooting) how.was = batch->state;
  fail(number, how);
  row->state = QueueState::Waiting;  // so that its details are read anew
  session_->tellBatchChanged(number);
}

void BatchQueue::retry(const QString& number) {
  const QueueRow* row = find(number);
  if (session_ == nullptr || row == nullptr || row->state == QueueState::Shooting) return;
  catalogue::Catalogue& rows = session_->project().catalogue();
  const records::Provenance provenance = session_->provenance(tr("again"));
  const std::optional<BatchState> was = keptFailure(rows, number).was;
  Result<void> asked = was ? catalogue::Batches(rows).setState({row->batch_row}, *was, provenance)
                           : intake::queueAgain(rows, number.toStdString(), provenance);
  if (asked) asked = forgetFailure(rows, number);
  if (!asked) stopFor(asked.error());
  session_->tellBatchChanged(number);
}

void BatchQueue::keepBoth(const QString& number) {
  if (session_ == nullptr || find(number) == nullptr) return;
  const Result<void> kept = intake::keepBoth(session_->project().catalogue(), number.toStdString(),
                                             session_->provenance());
  if (!kept) return stopFor(kept.error());
  retry(number);
}

void BatchQueue::forgetMoved(const QString& number) {
  QueueRow* row = find(number);
  if (session_ == nullptr || row == nullptr || !row->figures) return;
  auto figures = intake::keptFigures(session_->project().catalogue(), number.toStdString());
  row->figures->moved.clear();
  figures->moved.clear();
  (void)intake::keepFigures(session_->project().catalogue(), number.toStdString(), *figures);
  touch(number);
}

int BatchQueue::waitingToCompute() const {
  return static_cast<int>(std::ranges::count_if(rows_, [](const QueueRow& row) {
    return row.state == QueueState::Waiting || row.state == QueueState::Busy ||
           row.state == QueueState::Paused;
  }));
}

int BatchQueue::unfinished() const {
  return static_cast<int>(std::ranges::count_if(
      rows_, [](const QueueRow& row) { return row.state != QueueState::Done && !row.aside; }));
}

int BatchQueue::failed() const {
  return static_cast<int>(std::ranges::count_if(rows_, [](const QueueRow& row) {
    return row.state == QueueState::Failed && !row.cancelled;
  }));
}

QString BatchQueue::workWords() const {
  if (!computation_->isBusy()) {
    const int waiting = waitingToCompute();
    if (switches_->isPaused() && waiting > 0)
      return tr("Paused; %n batch(es) queued.", nullptr, waiting);
    return {};
  }
  const QString& number = computation_->number();
  if (computation_->isCancelled()) return tr("%1: stopping…").arg(number);
  if (switches_->isPaused()) return tr("%1: paused").arg(number);
  const int at = rowOf(number);
  return tr("%1: %2").arg(number, progressWords(at < 0 ? QueueRow() : row(at)));
}

double BatchQueue::workFraction() const {
  const int at = computation_->isBusy() ? rowOf(computation_->number()) : -1;
  return at < 0 ? -1 : row(at).progress.fraction;
}

void BatchQueue::log(const QString& line) {
  const QString stamped = QTime::currentTime().toString(QStringLiteral("HH:mm:ss  ")) + line;
  log_.append(stamped);
  if (log_.size() > kKeptLogLines) log_.removeFirst();
  emit logged(stamped);
}

}  // namespace ostraka::ui
