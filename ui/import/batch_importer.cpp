#include "ui/import/batch_importer.h"

#include <QLocale>
#include <algorithm>
#include <system_error>

#include "catalogue/batches.h"
#include "intake/side_photographs.h"
#include "records/records.h"
#include "ui/frame/project_session.h"
#include "ui/import/record_photographs.h"
#include "ui/jobs/when_done.h"
#include "upkeep/project.h"

namespace ostraka::ui {
namespace {

QString noteOn(const Imported& copied) {
  if (!copied.found_sheet) return {};
  const QLocale locale;
  return BatchImporter::tr(
             "Sheet recognised: %n marker(s). Sizes follow from the marker side that was typed, %1 "
             "mm; check it on the paper with a ruler.",
             nullptr, static_cast<int>(copied.found_sheet->markers.size()))
      .arg(locale.toString(copied.found_sheet->typed_marker_mm.value_or(0), 'g',
                           QLocale::FloatingPointShortest));
}

}  // namespace

void BatchImporter::setSession(ProjectSession* session) {
  if (job_ != nullptr) {
    job_->drop();
    job_ = nullptr;
    emit ended();
  }
  session_ = session;
  if (session == nullptr || !session->hasProject()) return;
  const catalogue::Catalogue& rows = session->project().catalogue();
  if (!rows.readOnly())
    removeLeftImports(session->folder(), [&rows](const std::string& number) {
      const auto all = catalogue::Batches(rows).all();
      return !all || std::any_of(all->begin(), all->end(),
                                 [&number](const auto& batch) { return batch.number == number; });
    });
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
  job_ = session_->jobs().start(
      makeJob([options](Progress& progress,
                        std::stop_token stop) { return copyBatch(options, progress, stop); },
              JobPriority::Background),
      this);
  connect(job_, &JobHandle::progressed, this,
          [this](const JobProgress& progress) { emit progressed(progress.fraction); });
  doubts_.clear();
  connect(job_, &JobHandle::noted, this, [this](NoteLevel level, const QString& text) {
    if (level == NoteLevel::Warning) doubts_ << text;
  });
  whenDone<Imported>(job_, this, [this, options, place](const auto& copied) {
    emit ended();
    if (copied && !copied->same_as.empty()) {
      asked_ = options;
      asked_place_ = place;
      emit alreadyThere(QString::fromStdString(copied->same_as),
                        QString::fromStdString(options.from.string()), copied->same, copied->files);
      return;
    }
    const Result<QString> number = copied ? enter(*copied, place, options.twice) : copied.error();
    if (!number) {
      emit failed(number.error());
      return;
    }
    if (options.kind == ImportKind::Photographs) recordPhotographs(*session_, *number, "import");
    session_->tellBatchChanged(*number);  // who hears of the import finds its batch
    emit imported(*number, copied->files, doubts_, noteOn(*copied));
  });
  title_ = tr("Import of %1").arg(folder);
  emit started(title_);
}

void BatchImporter::cancel() {
  if (job_ != nullptr) job_->cancel();
}

// The folder gets its name before the row is kept: what fails in between leaves neither.
Result<QString> BatchImporter::enter(const Imported& copied, const PlaceText& place, bool twice) {
  upkeep::Project& project = session_->project();
  catalogue::Catalogue& rows = project.catalogue();
  std::string number;
  std::filesystem::path now = copied.folder;
  const Result<void> entered = rows.together([&]() -> Result<void> {
    const Result<std::string> added = addBatch(copied, place);
    if (!added) return added.error();
    number = *added;
    if (twice)
      if (Result<void> kept = intake::keepBoth(rows, number, session_->provenance()); !kept)
        return kept;
    std::error_code error;
    std::filesystem::rename(copied.folder, project.batchFolder(number), error);
    if (error)
      return Error{ErrorCode::CannotWrite,
                   tr("The copy cannot be put in its place: %1.")
                       .arg(QString::fromStdString(error.message()))
                       .toStdString(),
                   project.batchFolder(number).string()};
    now = project.batchFolder(number);
    return {};
  });
  std::error_code ignored;
  if (entered)
    std::filesystem::remove(now / kImportMark, ignored);
  else
    std::filesystem::remove_all(now, ignored);
  return entered ? Result<QString>(QString::fromStdString(number)) : entered.error();
}

Result<std::string> BatchImporter::addBatch(const Imported& copied, const PlaceText& place) {
  catalogue::Catalogue& rows = session_->project().catalogue();
  records::Provenance provenance = session_->provenance();
  provenance.source = "import";
  const Result<std::int64_t> bag = bagRowOf(rows, place, provenance);
  if (!bag) return bag.error();
  records::BatchRecord batch;
  if (*bag != 0) batch.bags.push_back({*bag});
  batch.operator_ = provenance.person;
  batch.started_ms = copied.first_taken_ms;  // the day of the import is not the photographs'
  batch.ended_ms = copied.last_taken_ms;
  batch.state = records::BatchState::Queued;
  const auto row = catalogue::Batches(rows).add(batch, provenance);
  if (!row) return row.error();
  const auto made = catalogue::Batches(rows).get(*row);
  return made ? Result<std::string>(made->number) : made.error();
}

}  // namespace ostraka::ui
