#pragma once
#include <vector>

#include "base/result.h"
#include "files/open_folder.h"
#include "upkeep/file_check.h"

namespace ostraka::upkeep {

/// What people say of a batch beside its results (batch/peoples_files.h), which changes without the
/// catalogue: each file can be read, and the decisions that the catalogue has are among those of
/// the file. Of batches whose results were entered; those of an import have no such files. Errors:
/// those of the catalogue.
Result<std::vector<DamagedFile>> checkPeoplesFiles(const catalogue::Catalogue& catalogue,
                                                   const OpenFolder& project);

}  // namespace ostraka::upkeep
