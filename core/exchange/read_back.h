#pragma once
#include <filesystem>
#include <stop_token>

#include "base/progress.h"
#include "base/result.h"
#include "records/records.h"
#include "tables/import_table.h"
#include "upkeep/project.h"

namespace ostraka::exchange {

/// What becomes of a batch of the export whose photographs another batch of the project has, too.
enum class SamePhotographs { Refuse, KeepBoth };

/// Reads a folder that exportFolder wrote (with JSON records) into a project. All hashes are
/// checked first; if a file is missing, changed or not listed, nothing enters. Records are known by
/// their uuid; what the project has already stays, and differences are counted and listed. Batches
/// come with their photographs, scans and decisions. The files of new sherds go to
/// PROJECT/imported/NAME, exported photographs to where they were; files that the project has lost
/// come back, and a warning counts them. One import at a time: the next one waits, and says so.
/// A batch whose photographs another batch of the project has (intake::sharedPhotographs) is a
/// warning of the preview, and UnusableInput on entering unless both are kept.
Result<tables::ImportReport> readBack(upkeep::Project& project, const std::filesystem::path& folder,
                                      tables::ImportMode mode,
                                      const records::Provenance& provenance, Progress& progress,
                                      std::stop_token stop,
                                      SamePhotographs same = SamePhotographs::Refuse);

}  // namespace ostraka::exchange
