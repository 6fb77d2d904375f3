#pragma once
#include <vector>

#include "base/result.h"
#include "files/open_folder.h"
#include "upkeep/file_check.h"

namespace ostraka::upkeep {

/// What people say of a batch beside its results (batch/peoples_files.h), which changes without the
/// catalogue: each file can be read and has the decisions and strokes that the catalogue knows, but
/// for decisions that came with an export, which brings no such file. Errors: those of the
/// catalogue.
Result<std::vector<DamagedFile>> checkPeoplesFiles(const catalogue::Catalogue& catalogue,
                                                   const OpenFolder& project);

}  // namespace ostraka::upkeep
