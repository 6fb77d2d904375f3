#pragma once
#include <string>

#include "base/result.h"
#include "files/contained_path.h"

namespace ostraka::tables {

/// Where a file that came with an export may lie in the project: pictures and the plate's, board's
/// and rig's descriptions in batches/NUMBER/ of their own batch, scans and reports in
/// results/NUMBER/, models with previews in models/NUMBER/, files of sherds in imported/NAME/. What
/// steers the program (catalogue, backups, decisions, strokes, stages, locks, hidden files) never
/// comes in as a file. batch: the number of the file's batch in the project, empty for a file of a
/// sherd. Error: UnusableInput.
Result<ContainedPath> importPlace(const std::string& path, const std::string& batch);

/// Where a file that the catalogue of a merged project lists may lie: the same, with the scans and
/// the report that the program computed for the batch; in imported/ whatever batch it is of.
bool isMergePlace(const std::string& path, const std::string& batch);

}  // namespace ostraka::tables
