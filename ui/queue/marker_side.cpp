#include "ui/queue/marker_side.h"

#include <QInputDialog>
#include <filesystem>

#include "batch/batch.h"
#include "catalogue/batches.h"
#include "files/files.h"
#include "intake/enter_results.h"
#include "pipeline/proposed_sheet.h"
#include "ui/frame/batch_place.h"
#include "ui/frame/project_session.h"
#include "ui/jobs/when_done.h"
#include "ui/widgets/parts.h"
#include "upkeep/project.h"

namespace ostraka::ui {
namespace {

constexpr double kMostMarker_mm = 500;

std::filesystem::path folderOf(const ProjectSession& session, const QString& batch) {
  return session.folder() / "batches" / batch.toStdString();
}

}  // namespace

void MarkerSide::setSession(ProjectSession* session) {
  dropJob(job_);
  session_ = session;
}

bool MarkerSide::isTyped(const QString& batch) const {
  std::error_code ignored;
  return session_ != nullptr && !batch.isEmpty() &&
         !std::filesystem::exists(folderOf(*session_, batch) / "rig.json", ignored) &&
         !frontPicture(folderOf(*session_, batch)).isEmpty();
}

void MarkerSide::ask(const QString& batch) {
  if (!isTyped(batch)) return;
  const Result<batch::Plate> plate = batch::readPlate(folderOf(*session_, batch) / "plate.json");
  auto* dialog = named<QInputDialog>("markerSide", screen_);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(tr("Marker side of %1").arg(batch));
  dialog->setInputMode(QInputDialog::DoubleInput);
  dialog->setLabelText(
      tr("Side of a marker's black square, mm. The batch is reprocessed with this size."));
  dialog->setDoubleRange(0, kMostMarker_mm);  // 0: not known, and refused
  dialog->setDoubleDecimals(2);
  if (plate)
    dialog->setDoubleValue(plate->typed_marker_mm.value_or(batch::markerSide(*plate).value_or(0)));
  connect(dialog, &QInputDialog::doubleValueSelected, this,
          [this, batch](double side_mm) { apply(batch, side_mm); });
  dialog->open();
}

void MarkerSide::apply(const QString& batch, double side_mm) {
  if (session_ == nullptr || job_ != nullptr) return;
  const records::Provenance provenance = session_->provenance(tr("marker side typed anew"));
  job_ = session_->jobs().start(
      makeJob([project = session_->folder(), folder = folderOf(*session_, batch),
               number = batch.toStdString(), side_mm,
               provenance](Progress& progress, std::stop_token stop) -> Result<int> {
        Result<catalogue::Catalogue> rows = upkeep::Project::connect(project);
        if (!rows) return rows.error();
        const auto record = catalogue::Batches(*rows).byNumber(number);
        if (!record) return record.error();
        const std::filesystem::path plate = folder / "plate.json";
        const Result<std::string> before = readFile(plate);
        const auto written = pipeline::setMarkerSide(folder, side_mm, progress, stop);
        if (!written) return written.error();
        auto entered =
            intake::enterPhotographs(*rows, project, record->row, provenance, progress, stop);
        std::error_code ignored;  // the first error is the one to say
        if (!entered && before)
          (void)writeFileAtomically(plate, *before);
        else if (!entered)
          std::filesystem::remove(plate, ignored);
        return entered;
      }),
      this);
  whenDone<int>(job_, this, [this, batch](const auto& entered) {
    if (!entered) return emit failed(entered.error());
    emit changed(batch);
  });
}

}  // namespace ostraka::ui
