#include "ui/capture/batch_importer.h"

#include <system_error>

#include "catalogue/batches.h"
#include "records/records.h"
#include "ui/frame/project_session.h"
#include "ui/words/sentence.h"
#include "upkeep/project.h"

namespace ostraka::ui {

void BatchImporter::setSession(ProjectSession* session) {
  if (job_ != nullptr) {
    job_->drop();
    job_ = nullptr;
    emit ended();
  }
  session_ = session;
}

void BatchImporter::start(const QString& folder, ImportKind kind, const PlaceText& place,
                          const std::optional<ImportSides>& sides) {
  if (session_ == nullptr || isBusy()) return;
  copy({folder.toStdString(), session_->folder(), kind, false, sides}, place);
}

void BatchImporter::startAllTheSame() {
  if (session_ == nullptr || isBusy() || asked_.project != session_->folder()) return;
  asked_.twice = true;
  copy(asked_, asked_place_);
}

void BatchImporter::copy(const ImportOptions& options, const PlaceText& place) {
  if (!session_->isThere()) return emit failed(session_->goneError());
  const QString folder = QString::fromStdString(options.from.string());
  job_ = session_->jobs().start(makeJob(
                                    tr("Import of %1").arg(folder),
                                    [options](Progress& progress, std::stop_token stop) {
                                      return copyBatch(options, progress, stop);
                                    },
                                    JobPriority::Background),
                                this);
  connect(job_, &JobHandle::progressed, this,
          [this](const JobProgress& progress) { emit progressed(progress.fraction); });
  doubts_.clear();
  connect(job_, &JobHandle::noted, this, [this](NoteLevel level, const QString& text) {
    if (level == NoteLevel::Warning) doubts_ << wordsOf(text.toStdString());
  });
  connect(job_, &JobHandle::finished, this, [this, options, place](const JobOutcome& outcome) {
    job_->deleteLater();
    job_ = nullptr;
    emit ended();
    const Result<Imported> copied = outcomeAs<Imported>(outcome);
    if (copied && !copied->same_as.empty()) {
      asked_ = options;
      asked_place_ = place;
      emit alreadyThere(QString::fromStdString(copied->same_as),
                        QString::fromStdString(options.from.string()), copied->same, copied->files);
      return;
    }
    const Result<QString> number = copied ? enter(*copied, place) : copied.error();
    if (!number) {
      emit failed(number.error());
      return;
    }
    emit imported(*number, copied->files, doubts_);
    session_->tellBatchChanged(*number);
  });
  emit started(job_->title());
}

void BatchImporter::cancel() {
  if (job_ != nullptr) job_->cancel();
}

Result<QString> BatchImporter::enter(const Imported& copied, const PlaceText& place) {
  upkeep::Project& project = session_->project();
  catalogue::Catalogue& rows = project.catalogue();
  records::Provenance provenance = session_->provenance();
  provenance.source = "import";
  const Result<std::int64_t> bag = bagRowOf(rows, place, provenance);
  if (!bag) return bag.error();
  records::BatchRecord batch;
  if (*bag != 0) batch.bags.push_back({*bag});
  batch.operator_ = provenance.person;
  batch.started_ms = copied.first_taken_ms;  // the day of the import is not the photographs'
  batch.ended_ms = copied.last_taken_ms;
  batch.state = records::BatchState::Failed;  // until its files are in place
  const auto row = catalogue::Batches(rows).add(batch, provenance);
  if (!row) return row.error();
  const auto made = catalogue::Batches(rows).get(*row);
  if (!made) return made.error();
  std::error_code error;
  std::filesystem::rename(copied.folder, project.batchFolder(made->number), error);
  if (error)
    return Error{ErrorCode::CannotWrite,
                 tr("The copy cannot be put in its place: %1.")
                     .arg(QString::fromStdString(error.message()))
                     .toStdString(),
                 project.batchFolder(made->number).string()};
  if (const auto queued =
          catalogue::Batches(rows).setState(*row, records::BatchState::Queued, provenance);
      !queued)
    return queued.error();
  return QString::fromStdString(made->number);
}

}  // namespace ostraka::ui
