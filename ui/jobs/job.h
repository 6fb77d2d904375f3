#pragma once
#include <QObject>
#include <QString>
#include <any>
#include <functional>
#include <memory>
#include <stop_token>
#include <type_traits>

#include "base/progress.h"
#include "base/result.h"

/// The only way from the window to long work, and the only place of the window that starts threads.
namespace ostraka::ui {

/// What a job hands back: a value of the type its work returned, or an Error.
using JobOutcome = Result<std::any>;
using JobWork = std::function<JobOutcome(Progress&, std::stop_token)>;

enum class JobPriority {
  Quick,       ///< a picture, a query: what a person waits for
  Background,  ///< computing: gives way to everything else on the machine
};

struct Job {
  JobWork work;  ///< runs in another thread: takes values only, touches no QObject
  JobPriority priority = JobPriority::Quick;
  /// Its work is begun though its handle went before: a person was told that it will be done.
  bool is_promised = false;
};

/// How far a job is. A job without stages has an empty stage.
struct JobProgress {
  QString stage;
  double fraction = 0;       ///< of the whole job, 0..1
  double seconds_left = -1;  ///< below 0: not known yet
};

/// One job that was started. All signals come in the thread of the window. A handle that is
/// deleted asks its job to stop, and nothing of it arrives any more.
class JobHandle : public QObject {
  Q_OBJECT

 public:
  ~JobHandle() override;
  const JobProgress& progress() const;

 public slots:
  /// Asks to stop; finished comes with Error{Cancelled} as soon as the work notices.
  void cancel();
  /// Asks to stop and deletes itself; nothing of it arrives any more, not even what is under way.
  void drop();
  /// The work stands still at its next report of progress, without losing anything.
  void pause();
  void resume();

 signals:
  void progressed(const ostraka::ui::JobProgress& progress);  ///< at most 10 times a second
  void noted(ostraka::NoteLevel level, const QString& text);
  void stoodStill();  ///< the work reached the pause that was asked for, and waits there
  void told(const std::any& value);                       ///< what the work said through tell()
  void finished(const ostraka::ui::JobOutcome& outcome);  ///< exactly once, last of all

 private:
  friend class JobRunner;
  struct Shared;
  friend class JobMessenger;
  explicit JobHandle(QObject* parent);
  void settle(const JobOutcome& outcome);

  JobProgress progress_;
  std::shared_ptr<Shared> shared_;
};

/// Starts jobs. Handed in, so that tests run the same code without threads.
class JobRunner {
 public:
  virtual ~JobRunner() = default;
  /// The handle belongs to parent. The job does not begin before control is back in the event loop
  /// or in another thread, so that signals can be connected first.
  JobHandle* start(Job job, QObject* parent);

 protected:
  /// What a runner does with a job: call it once, anywhere. It never throws.
  virtual void run(JobPriority priority, std::function<void()> body, std::stop_source stop,
                   JobHandle* handle) = 0;
};

/// Threads: two for quick jobs, two of low priority for computing. Its end stops all jobs and
/// waits.
class ThreadedJobRunner final : public JobRunner {
 public:
  ThreadedJobRunner();
  ~ThreadedJobRunner() override;

 protected:
  void run(JobPriority priority, std::function<void()> body, std::stop_source stop,
           JobHandle* handle) override;

 private:
  struct Pools;
  std::unique_ptr<Pools> pools_;
};

/// In the window's own thread, at the next turn of the event loop, one after the other.
class InlineJobRunner final : public JobRunner {
 protected:
  void run(JobPriority priority, std::function<void()> body, std::stop_source stop,
           JobHandle* handle) override;
};

/// A job from a function that returns Result<T>, T copyable; Result<void> too.
template <class Function>
Job makeJob(Function function, JobPriority priority = JobPriority::Quick) {
  return {[function = std::move(function)](Progress& progress, std::stop_token stop) -> JobOutcome {
            auto result = function(progress, stop);
            if (!result.has_value()) return result.error();
            if constexpr (std::is_same_v<decltype(result), Result<void>>)
              return std::any();
            else
              return std::any(std::move(*result));
          },
          priority};
}

/// Called in a job with the progress that it was handed: the value arrives as JobHandle::told, in
/// order. With any other progress nothing happens.
void tell(Progress& progress, std::any value);

/// The value of a job made by makeJob, as the Result<T> that its function returned.
template <class T>
Result<T> outcomeAs(const JobOutcome& outcome) {
  if (!outcome.has_value()) return outcome.error();
  if constexpr (std::is_void_v<T>)
    return {};
  else
    return std::any_cast<const T&>(*outcome);
}

}  // namespace ostraka::ui

Q_DECLARE_METATYPE(ostraka::ui::JobProgress)
Q_DECLARE_METATYPE(ostraka::NoteLevel)
