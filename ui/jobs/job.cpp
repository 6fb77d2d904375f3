#include "ui/jobs/job.h"

#include <QCoreApplication>
#include <condition_variable>
#include <mutex>
#include <new>

#include "base/pace.h"
#include "ui/words/sentence.h"

namespace ostraka::ui {

/// What the job's thread and its handle both know. The handle is reached under the lock only, so
/// that it can be deleted at any time.
struct JobHandle::Shared {
  std::mutex lock;
  std::condition_variable_any wake;
  JobHandle* handle = nullptr;
  std::stop_source stop;
  bool paused = false;
  bool running = true;
};

/// Carries what the work says over to the window's thread.
class JobMessenger final : public Progress {
 public:
  explicit JobMessenger(std::shared_ptr<JobHandle::Shared> shared) : shared_(std::move(shared)) {}

  void begin(std::string_view stage, double share) override {
    standStillWhilePaused();
    stage_ = QString::fromUtf8(stage.data(), static_cast<qsizetype>(stage.size()));
    pace_.begin(share, Pace::Clock::now());
    tell();
  }

  void report(std::int64_t done, std::int64_t total) override {
    standStillWhilePaused();
    if (total <= 0) return;
    const Pace::Clock::time_point now = Pace::Clock::now();
    pace_.report(static_cast<double>(done) / static_cast<double>(total), now);
    if (now - told_ >= kBetween) tell();
  }

  void note(NoteLevel level, const Message& text) override {
    post([level, text](JobHandle* handle) { emit handle->noted(level, wordsOf(text)); });
  }

  void tellValue(std::any value) {
    post([value = std::move(value)](JobHandle* handle) { emit handle->told(value); });
  }

  void end(const JobOutcome& outcome) {
    post([outcome](JobHandle* handle) { handle->settle(outcome); });
  }

 private:
  // Ten times a second is as fast as figures can be read.
  static constexpr std::chrono::milliseconds kBetween{100};

  template <class Work>
  void post(Work work) {
    const std::lock_guard guard(shared_->lock);
    JobHandle* handle = shared_->handle;
    if (handle == nullptr) return;
    QMetaObject::invokeMethod(
        handle, [handle, work] { work(handle); }, Qt::QueuedConnection);
  }

  void tell() {
    const Pace::Clock::time_point now = Pace::Clock::now();
    told_ = now;
    const JobProgress progress{stage_, pace_.fraction(), pace_.secondsLeft(now).value_or(-1)};
    post([progress](JobHandle* handle) {
      handle->progress_ = progress;
      emit handle->progressed(progress);
    });
  }

  bool isPaused() const {
    const std::lock_guard guard(shared_->lock);
    return shared_->paused;
  }

  void standStillWhilePaused() {
    if (!isPaused()) return;
    post([](JobHandle* handle) { emit handle->stoodStill(); });
    std::unique_lock guard(shared_->lock);
    const Pace::Clock::time_point since = Pace::Clock::now();
    shared_->wake.wait(guard, shared_->stop.get_token(), [this] { return !shared_->paused; });
    pace_.skip(Pace::Clock::now() - since);
  }

  std::shared_ptr<JobHandle::Shared> shared_;
  QString stage_;
  Pace pace_;
  Pace::Clock::time_point told_{};
};

namespace {

// The one place around a job where exceptions, which are bugs or a lack of memory, are caught.
JobOutcome outcomeOf(const JobWork& work, Progress& progress, const std::stop_token& stop) {
  try {
    return work(progress, stop);
  } catch (const std::bad_alloc&) {
    return Error{
        ErrorCode::Failed,
        QCoreApplication::translate("Job", "Not enough memory. Close other programs and try again.")
            .toStdString(),
        {}};
  } catch (const std::exception& error) {
    return Error{ErrorCode::Failed,
                 QCoreApplication::translate(
                     "Job", "This is a defect of the program; please report it with the log (%1).")
                     .arg(QString::fromUtf8(error.what()))
                     .toStdString(),
                 {}};
  }
}

}  // namespace

JobHandle::JobHandle(QObject* parent) : QObject(parent), shared_(std::make_shared<Shared>()) {
  shared_->handle = this;
}

JobHandle::~JobHandle() {
  {
    const std::lock_guard guard(shared_->lock);
    shared_->handle = nullptr;
  }
  shared_->stop.request_stop();
}

const JobProgress& JobHandle::progress() const {
  return progress_;
}

void JobHandle::cancel() {
  shared_->stop.request_stop();
}

void JobHandle::drop() {
  disconnect();
  cancel();
  deleteLater();
}

void JobHandle::pause() {
  const std::lock_guard guard(shared_->lock);
  shared_->paused = shared_->running;
}

void JobHandle::resume() {
  {
    const std::lock_guard guard(shared_->lock);
    shared_->paused = false;
  }
  shared_->wake.notify_all();
}

void JobHandle::settle(const JobOutcome& outcome) {
  {
    const std::lock_guard guard(shared_->lock);
    shared_->running = false;
    shared_->paused = false;
  }
  emit finished(outcome);
}

JobHandle* JobRunner::start(Job job, QObject* parent) {
  auto* handle = new JobHandle(parent);
  run(
      job.priority,
      [shared = handle->shared_, job] {
        JobMessenger messenger(shared);
        const std::stop_token stop = shared->stop.get_token();
        messenger.end(!job.is_promised && stop.stop_requested()
                          ? JobOutcome(Error::cancelled())
                          : outcomeOf(job.work, messenger, stop));
      },
      handle->shared_->stop, handle);
  return handle;
}

void tell(Progress& progress, std::any value) {
  if (auto* messenger = dynamic_cast<JobMessenger*>(&progress))
    messenger->tellValue(std::move(value));
}

void InlineJobRunner::run(JobPriority, std::function<void()> body, std::stop_source,
                          JobHandle* handle) {
  QMetaObject::invokeMethod(handle, std::move(body), Qt::QueuedConnection);
}

}  // namespace ostraka::ui
