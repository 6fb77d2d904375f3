#include "ui/import/import_batch.h"

#include <QCoreApplication>
#include <algorithm>
#include <cstdint>
#include <system_error>
#include <utility>
#include <vector>

#include "base/message.h"
#include "batch/batch.h"
#include "batch/copied_photographs.h"
#include "batch/exif.h"
#include "batch/mask_source.h"
#include "batch/photographs.h"
#include "files/files.h"
#include "intake/side_photographs.h"
#include "pipeline/proposed_sheet.h"
#include "upkeep/project.h"

namespace ostraka::ui {
namespace {

namespace fs = std::filesystem;

constexpr const char* kCopy = "import.partial";  // no batch's number

// A file and its place in the batch.
struct Taken {
  fs::path file, as;
};

bool isScan(const fs::path& file) {
  return file.extension() == ".ply" || file.extension() == ".PLY";
}

Result<std::vector<Taken>> scansIn(const fs::path& folder) {
  std::vector<Taken> files;
  for (const char* side : {"front", "back"}) {
    const std::size_t before = files.size();
    std::error_code error;
    for (fs::directory_iterator at(folder / side, error), end; !error && at != end;
         at.increment(error))
      if (isScan(at->path())) files.push_back({at->path(), side / at->path().filename()});
    if (files.size() == before)
      return Error{ErrorCode::UnusableInput,
                   QCoreApplication::translate("ImportBatch",
                                               "There are no scans (*.ply) in its folder %1/. "
                                               "Choose a folder that holds front/ and back/.")
                       .arg(QLatin1String(side))
                       .toStdString(),
                   folder.string()};
  }
  return files;
}

// Better now than at the end of an hour in the queue.
Result<void> isComputable(batch::Batch& batch, Progress& progress) {
  if (const auto masks = batch::maskSource("auto", batch); !masks) return masks.error();
  return batch::leaveOutCopies(batch, {}, progress);
}

Result<std::vector<Taken>> batchIn(const fs::path& folder, Progress& progress) {
  Result<batch::Batch> batch = batch::readBatch(folder, {}, progress);
  if (!batch) return batch.error();
  if (const Result<void> computable = isComputable(*batch, progress); !computable)
    return computable.error();
  std::vector<Taken> files;
  std::error_code error;
  for (fs::recursive_directory_iterator at(folder, error), end; !error && at != end;
       at.increment(error)) {
    if (at->is_directory() && at->path().filename() == "truth") {
      at.disable_recursion_pending();
      continue;
    }
    if (at->is_regular_file()) files.push_back({at->path(), fs::relative(at->path(), folder)});
  }
  if (error)
    return Error{
        ErrorCode::UnusableInput,
        QCoreApplication::translate("ImportBatch", "This folder cannot be read to its end: %1.")
            .arg(QString::fromStdString(error.message()))
            .toStdString(),
        folder.string()};
  return files;
}

// Those photographs that are used, and what describes the sheet.
Result<std::vector<Taken>> sidesOf(const ImportSides& sides, Progress& progress) {
  batch::ReadBatchOptions options;
  options.sheet = sides.sheet;
  std::vector<batch::FreeSide> free;
  for (const batch::Side side : {batch::Side::Front, batch::Side::Back}) {
    const std::vector<fs::path>& files = side == batch::Side::Front ? sides.front : sides.back;
    if (!files.empty()) free.push_back({side, files, files.front().parent_path(), {}});
  }
  Result<batch::Batch> batch = batch::freeCameraBatch(free, {}, {}, options, progress);
  if (!batch) return batch.error();
  if (const Result<void> computable = isComputable(*batch, progress); !computable)
    return computable.error();
  std::vector<Taken> files;
  for (const batch::Shot& shot : batch->shots)
    files.push_back({shot.file, batch::name(shot.side) / shot.file.filename()});
  if (!batch->plate_file.empty()) files.push_back({batch->plate_file, "plate.json"});
  return files;
}

Result<Imported> batchWithTheSame(const ImportOptions& options, const std::stop_token& stop) {
  const Result<catalogue::Catalogue> rows = upkeep::Project::connect(options.project);
  if (!rows) return rows.error();
  std::vector<batch::SideFile> files;
  if (options.sides) {
    files = batch::sideFiles(options.sides->front);
    const std::vector<batch::SideFile> backs = batch::sideFiles(options.sides->back);
    files.insert(files.end(), backs.begin(), backs.end());
  } else {
    files = batch::sideFilesIn(options.from);
  }
  const auto shared = intake::sharedPhotographs(
      *rows, options.project, std::move(files), [](const records::BatchRecord&) { return true; },
      stop);
  if (!shared) return shared.error();
  Imported there_already;
  if (*shared) {
    there_already.same_as = (*shared)->batch;
    there_already.same = (*shared)->shared;
    there_already.files = (*shared)->of;
  }
  return there_already;
}

Error anotherImport(const fs::path& folder) {
  return {ErrorCode::CannotWrite,
          message("Another run is writing to this folder. What it has saved is kept, and this run "
                  "has changed nothing; wait until the other one ends, or choose another folder."),
          folder.string()};
}

// An empty folder, marked and held.
Result<void> beginCopy(const fs::path& project, Imported& imported) {
  const fs::path folder = project / "batches" / kCopy;
  std::error_code ignored;
  if (fs::exists(fs::symlink_status(folder, ignored))) {  // of an import that was killed
    const std::optional<Hold> left = Hold::take(folder);
    if (!left) return anotherImport(folder);
    fs::remove_all(folder, ignored);
  }
  if (Result<void> made = writeFileAtomically(folder / kImportMark, {}); !made) {
    fs::remove(folder, ignored);
    return made;
  }
  std::optional<Hold> hold = Hold::take(folder);
  if (!hold) return anotherImport(folder);
  imported.folder = folder;
  imported.hold = std::make_shared<const Hold>(std::move(*hold));
  return {};
}

Result<void> copyFiles(const std::vector<Taken>& files, Imported& imported, Progress& progress,
                       const std::stop_token& stop) {
  for (const auto& [file, as] : files) {
    if (stop.stop_requested()) return Error::cancelled();
    progress.report(imported.files, static_cast<std::int64_t>(files.size()));
    const Result<std::string> bytes = readFile(file);
    if (!bytes) return bytes.error();
    if (Result<void> written = writeFileAtomically(imported.folder / as, *bytes); !written)
      return written;
    ++imported.files;
    const std::optional<std::int64_t> taken_ms = batch::exifIn(*bytes).takenMs();
    if (!taken_ms) continue;
    imported.first_taken_ms = std::min(imported.first_taken_ms.value_or(*taken_ms), *taken_ms);
    imported.last_taken_ms = std::max(imported.last_taken_ms.value_or(*taken_ms), *taken_ms);
  }
  return {};
}

}  // namespace

Result<Imported> copyBatch(const ImportOptions& options, Progress& progress, std::stop_token stop) {
  Result<std::vector<Taken>> files = options.kind == ImportKind::Scans ? scansIn(options.from)
                                     : options.sides ? sidesOf(*options.sides, progress)
                                                     : batchIn(options.from, progress);
  if (!files) return files.error();
  std::ranges::sort(*files, {}, &Taken::as);
  Imported imported;
  if (!options.twice) {
    Result<Imported> same = batchWithTheSame(options, stop);
    if (!same || !same->same_as.empty()) return same;
  }
  if (Result<void> begun = beginCopy(options.project, imported); !begun) return begun.error();
  const Result<void> copied = [&]() -> Result<void> {
    if (Result<void> all = copyFiles(*files, imported, progress, stop); !all) return all;
    if (!options.sides || !options.sides->marker_mm) return {};
    Result<batch::Plate> found =
        pipeline::setMarkerSide(imported.folder, *options.sides->marker_mm, progress, stop);
    if (!found) return Error{found.error().code, found.error().what, options.from.string()};
    imported.found_sheet = std::move(*found);
    return {};
  }();
  if (copied) return imported;
  std::error_code ignored;
  fs::remove_all(imported.folder, ignored);
  return copied.error();
}

void removeLeftImports(const fs::path& project,
                       const std::function<bool(const std::string&)>& isBatch) {
  std::vector<fs::path> marked;
  std::error_code failed;
  for (fs::directory_iterator at(project / "batches", failed), end; !failed && at != end;
       at.increment(failed))
    if (std::error_code code;
        at->path().filename() == kCopy || fs::exists(at->path() / kImportMark, code))
      marked.push_back(at->path());
  for (const fs::path& folder : marked) {
    const std::optional<Hold> hold = Hold::take(folder);
    if (!hold) continue;
    if (isBatch(folder.filename().string()))
      fs::remove(folder / kImportMark, failed);
    else
      fs::remove_all(folder, failed);
  }
}

}  // namespace ostraka::ui
