// For the tests of the queue: a project without photographs, and a queue whose work does nothing.
#pragma once
#include <QStringList>

#include "../project_in.h"
#include "catalogue/batches.h"
#include "ui/frame/project_session.h"
#include "ui/queue/batch_computation.h"
#include "ui/queue/batch_queue.h"
#include "ui/queue/queue_switches.h"

namespace ostraka::ui {

using records::BatchState;

inline QString addBatch(ProjectSession& session, BatchState state) {
  records::BatchRecord record;
  record.state = state;
  catalogue::Catalogue& rows = session.project().catalogue();
  const auto row = catalogue::Batches(rows).add(record, {});
  if (!row) qFatal("%s", row.error().sentence().english().c_str());
  return QString::fromStdString(catalogue::Batches(rows).get(*row)->number);
}

inline BatchState stateOf(ProjectSession& session, const QString& number) {
  return catalogue::Batches(session.project().catalogue()).byNumber(number.toStdString())->state;
}

// A queue with work that notes its batches, sets the state that intake::computeBatch sets, and
// ends.
struct Bench {
  explicit Bench(const std::filesystem::path& folder, JobRunner& jobs)
      : session(projectIn(folder), folder, jobs) {
    setWork([this](const intake::ComputeOptions& options, Progress&,
                   std::stop_token) -> Result<intake::BatchFigures> {
      computed << QString::fromStdString(options.number);
      auto project = upkeep::Project::open(options.project);
      const auto batch = catalogue::Batches(project->catalogue()).byNumber(options.number);
      (void)catalogue::Batches(project->catalogue()).setState(batch->row, BatchState::Review, {});
      return intake::BatchFigures{3, 2, 1, 0.07, 5};
    });
  }
  void setWork(intake::ComputeWork work) { queue.computation()->setWork(std::move(work)); }

  ProjectSession session;
  BatchQueue queue;
  QStringList computed;
};

}  // namespace ostraka::ui
