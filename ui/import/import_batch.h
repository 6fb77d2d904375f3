#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>

#include "base/progress.h"
#include "base/result.h"
#include "batch/batch.h"
#include "files/hold.h"
#include "ui/import/import_sides.h"

namespace ostraka::ui {

enum class ImportKind { Photographs, Scans };

struct ImportOptions {
  /// A batch folder, one with front/*.ply and back/*.ply, or where the sides' photographs are.
  std::filesystem::path from;
  std::filesystem::path project;
  ImportKind kind = ImportKind::Photographs;
  bool twice = false;                ///< also when the project has the same files already
  std::optional<ImportSides> sides;  ///< photographs by hand: these become front/ and back/
};

struct Imported {
  std::filesystem::path folder;  ///< a whole copy beside the project's batches, not yet one of them
  std::shared_ptr<const Hold> hold;  ///< on the folder, until it is one or goes
  int files = 0;
  /// By the cameras' clocks, since 1970, UTC; nothing where no photograph says it.
  std::optional<std::int64_t> first_taken_ms, last_taken_ms;
  std::optional<batch::Plate> found_sheet;  ///< in the photographs, as large as a person typed it
  std::string same_as;  ///< "B0031" has some of these photographs or scans; nothing was copied
  int same = 0;         ///< how many of `files` that batch has; photographs or scans
};

/// Checks the folder and copies what belongs to the batch (never truth/) into PROJECT/batches under
/// a name that is no batch's. What is there is read only. Errors: UnusableInput, CannotWrite,
/// Cancelled; then nothing is left behind.
Result<Imported> copyBatch(const ImportOptions& options, Progress& progress, std::stop_token stop);

/// In a copy until its batch is in the catalogue.
constexpr const char* kImportMark = ".import.partial";

/// Removes copies that belong to no batch and that nobody holds: a killed import left them.
/// isBatch: whether the catalogue has this number.
void removeLeftImports(const std::filesystem::path& project,
                       const std::function<bool(const std::string&)>& isBatch);

}  // namespace ostraka::ui
