#include "ui/capture/import_batch.h"

#include <QCoreApplication>
#include <algorithm>
#include <system_error>
#include <vector>

#include "base/files.h"
#include "batch/batch.h"

namespace ostraka::ui {
namespace {

namespace fs = std::filesystem;

bool isScan(const fs::path& file) {
  return file.extension() == ".ply" || file.extension() == ".PLY";
}

Result<std::vector<fs::path>> scansIn(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const char* side : {"front", "back"}) {
    const std::size_t before = files.size();
    std::error_code error;
    for (fs::directory_iterator at(folder / side, error), end; !error && at != end;
         at.increment(error))
      if (isScan(at->path())) files.push_back(at->path());
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

Result<std::vector<fs::path>> photographsIn(const fs::path& folder, Progress& progress) {
  const Result<batch::Batch> batch = batch::readBatch(folder, {}, progress);
  if (!batch) return batch.error();
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::recursive_directory_iterator at(folder, error), end; !error && at != end;
       at.increment(error)) {
    if (at->is_directory() && at->path().filename() == "truth") {
      at.disable_recursion_pending();
      continue;
    }
    if (at->is_regular_file()) files.push_back(at->path());
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

}  // namespace

Result<Imported> copyBatch(const ImportOptions& options, Progress& progress, std::stop_token stop) {
  Result<std::vector<fs::path>> files = options.kind == ImportKind::Scans
                                            ? scansIn(options.from)
                                            : photographsIn(options.from, progress);
  if (!files) return files.error();
  std::sort(files->begin(), files->end());
  Imported imported;
  imported.folder = options.project / "batches" / "import.partial";
  std::error_code ignored;
  fs::remove_all(imported.folder, ignored);  // of an import that was killed
  for (const fs::path& file : *files) {
    if (stop.stop_requested()) {
      fs::remove_all(imported.folder, ignored);
      return Error::cancelled();
    }
    progress.report(imported.files, static_cast<std::int64_t>(files->size()));
    const Result<std::string> bytes = readFile(file);
    Result<void> written =
        bytes ? writeFileAtomically(imported.folder / fs::relative(file, options.from), *bytes)
              : Result<void>(bytes.error());
    if (!written) {
      fs::remove_all(imported.folder, ignored);
      return written.error();
    }
    ++imported.files;
  }
  return imported;
}

}  // namespace ostraka::ui
