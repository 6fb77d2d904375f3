#include "ui/queue/batch_computation.h"

#include <any>
#include <utility>

#include "intake/batch_figures.h"
#include "ui/frame/project_session.h"
#include "ui/queue/batch_queue.h"
#include "upkeep/project.h"

namespace ostraka::ui {
namespace {

// Kept by the job itself: a window that closes in its last seconds does not hear of its end.
Result<intake::BatchFigures> figuresKept(const Result<intake::BatchFigures>& figures,
                                         const intake::ComputeOptions& options) {
  if (!figures) return figures;
  if (Result<catalogue::Catalogue> rows = upkeep::Project::connect(options.project))
    (void)intake::keepFigures(*rows, options.number, *figures);
  return figures;
}

}  // namespace

BatchComputation::BatchComputation(QObject* parent)
    : QObject(parent), work_(intake::computeBatch) {}

void BatchComputation::setWork(intake::ComputeWork work) {
  work_ = std::move(work);
}

JobProgress BatchComputation::progress() const {
  return job_ == nullptr ? JobProgress() : job_->progress();
}

double BatchComputation::secondsOf(const QString& number) const {
  return number == number_ ? static_cast<double>(since_.secsTo(clock_())) : 0;
}

void BatchComputation::begin(ProjectSession& session, const QString& number, bool draft) {
  intake::ComputeOptions options;
  options.project = session.folder();
  options.number = number.toStdString();
  options.threads = threads_;
  options.draft = draft_ = draft;
  number_ = number;
  since_ = clock_();
  cancelled_ = false;
  estimate_s_ = 0;
  const auto compute = [work = work_, options](Progress& progress, std::stop_token stop) {
    intake::ComputeOptions told = options;
    told.estimated = [&progress](double core_s) { tell(progress, core_s); };
    return figuresKept(work(told, progress, stop), options);
  };
  job_ = session.jobs().start(makeJob(compute, JobPriority::Background), this);
  connect(job_, &JobHandle::told, this, [this](const std::any& core_s) {
    estimate_s_ = std::any_cast<double>(core_s);
    emit progressed(progress());
  });
  connect(job_, &JobHandle::progressed, this, &BatchComputation::progressed);
  connect(job_, &JobHandle::noted, this, &BatchComputation::noted);
  connect(job_, &JobHandle::finished, this, &BatchComputation::end);
}

void BatchComputation::setPaused(bool paused) {
  if (job_ == nullptr) return;
  if (paused)
    job_->pause();
  else
    job_->resume();
}

void BatchComputation::cancel() {
  if (job_ == nullptr) return;
  cancelled_ = true;
  job_->cancel();
}

void BatchComputation::stop() {
  if (job_ != nullptr) job_->cancel();
}

void BatchComputation::leave() {
  if (job_ == nullptr) return;
  // Two computations must not write into the same folder when the project opens again at once.
  job_->disconnect(this);
  job_->cancel();
  leaving_ = job_;
  connect(leaving_, &JobHandle::finished, this, [this] {
    leaving_->deleteLater();
    leaving_ = nullptr;
    emit left();
  });
  job_ = nullptr;
  number_.clear();
}

void BatchComputation::end(const JobOutcome& outcome) {
  job_->deleteLater();
  job_ = nullptr;
  const QString number = std::exchange(number_, {});
  emit finished(number, outcome);
}

}  // namespace ostraka::ui
