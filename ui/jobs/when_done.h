#pragma once
#include <QPointer>
#include <utility>

#include "ui/jobs/job.h"

namespace ostraka::ui {

/// When the job ends its handle goes, and then(Result<T>) is called, unless context went before.
template <class T, class Then>
void whenDone(JobHandle* job, QObject* context, Then then) {
  QObject::connect(job, &JobHandle::finished, context,
                   [job, then = std::move(then)](const JobOutcome& outcome) {
                     job->deleteLater();
                     then(outcomeAs<T>(outcome));
                   });
}

/// The same for a job that context names: its name is empty before then is called. No other job
/// takes that name meanwhile.
template <class T, class Then>
void whenDone(QPointer<JobHandle>& job, QObject* context, Then then) {
  whenDone<T>(job.data(), context, [&job, then = std::move(then)](const Result<T>& result) {
    job.clear();
    then(result);
  });
}

/// Stops a job that context names; nothing of it arrives any more.
inline void dropJob(QPointer<JobHandle>& job) {
  if (job != nullptr) job->drop();
  job.clear();
}

}  // namespace ostraka::ui
