#pragma once
#include <filesystem>
#include <stop_token>

#include "base/progress.h"
#include "base/result.h"
#include "catalogue/project.h"
#include "exchange/import_table.h"

namespace ostraka::exchange {

/// Reads a folder that exportFolder wrote (with JSON records) into a project. All hashes are
/// checked first; if a file is missing, changed or not listed, nothing enters. Records are known by
/// their uuid; what the project has already stays, and differences are counted and listed. Batches
/// come with their photographs, scans and decisions. The files of new sherds go to
/// PROJECT/imported/NAME, exported photographs to where they were.
Result<ImportReport> readBack(catalogue::Project& project, const std::filesystem::path& folder,
                              ImportMode mode, const catalogue::Act& act, Progress& progress,
                              std::stop_token stop);

/// The whole project, catalogue and all files, as a bag: what a laptop that is lost leaves behind.
/// A file of the catalogue that is missing or was changed since it was entered is a warning.
/// Errors: the target is there or lies in the project, a folder that cannot be read, a full disk,
/// Cancelled.
Result<std::int64_t> archiveProject(const catalogue::Project& project,
                                    const std::filesystem::path& target, const std::string& program,
                                    Progress& progress, std::stop_token stop);
/// Into a new folder, after all hashes agreed; the catalogue is checked before it gets its name.
Result<void> restoreProject(const std::filesystem::path& archive,
                            const std::filesystem::path& folder, Progress& progress,
                            std::stop_token stop);

}  // namespace ostraka::exchange
