#include "ui/import/record_photographs.h"

#include "catalogue/batches.h"
#include "intake/enter_results.h"
#include "records/records.h"
#include "ui/frame/project_session.h"
#include "ui/jobs/when_done.h"
#include "upkeep/project.h"

namespace ostraka::ui {

void recordPhotographs(ProjectSession& session, const QString& batch, const char* source) {
  records::Provenance provenance = session.provenance();
  provenance.source = source;
  Job job = makeJob(
      [project = session.folder(), number = batch.toStdString(), provenance](
          Progress& progress, std::stop_token stop) -> Result<int> {
        Result<catalogue::Catalogue> rows = upkeep::Project::connect(project);
        if (!rows) return rows.error();
        const auto record = catalogue::Batches(*rows).byNumber(number);
        if (!record) return record.error();
        return intake::enterPhotographs(*rows, project, record->row, provenance, progress, stop);
      },
      JobPriority::Background);
  job.is_promised = true;
  JobHandle* handle = session.jobs().start(std::move(job), &session);
  whenDone<int>(handle, &session, [&session, batch](const auto& entered) {
    if (entered) session.tellBatchChanged(batch);
  });
}

}  // namespace ostraka::ui
