#include "ui/wizard/rig_renewal.h"

#include "checks/moved_cameras.h"
#include "ui/frame/project_session.h"
#include "ui/jobs/when_done.h"
#include "upkeep/project.h"

namespace ostraka::ui {

void RigRenewal::forget() {
  dropJob(job_);
}

void RigRenewal::start(ProjectSession& session, const std::filesystem::path& rig_file,
                       const QString& batch) {
  if (job_ != nullptr) return;
  const auto work = [output = session.project().resultsFolder(batch.toStdString()), rig_file](
                        Progress&, std::stop_token) -> Result<std::string> {
    const Result<std::filesystem::path> kept = checks::calibrateFrom(output, rig_file);
    if (!kept) return kept.error();
    return kept->string();
  };
  job_ = session.jobs().start(makeJob(work), this);
  whenDone<std::string>(job_, this, [this, batch](const auto& kept) {
    if (!kept) return emit failed(kept.error());
    emit renewed(batch, QString::fromStdString(*kept));
  });
}

}  // namespace ostraka::ui
