#pragma once
#include <string>
#include <string_view>

#include "base/result.h"
#include "files/contained_path.h"

namespace ostraka::catalogue {

/// The folders of a project's files, one for each batch.
inline constexpr const char* kFoldersOfBatches[] = {"batches/", "results/", "models/"};

/// Where a file that came with an export may lie in the project: pictures and the plate's, board's
/// and rig's descriptions in batches/NUMBER/ of their own batch, scans and reports in
/// results/NUMBER/, models with previews in models/NUMBER/, files of sherds in imported/NAME/. What
/// steers the program (catalogue, backups, decisions, strokes, stages, locks, hidden files) never
/// comes in as a file. batch: the number of the file's batch in the project, empty for a file of a
/// sherd. Error: UnusableInput.
Result<ContainedPath> importPlace(const std::string& path, const std::string& batch);

/// Where a file that a catalogue lists may lie: the same, with the scans and the report that the
/// program computed for the batch; in imported/ whatever batch it is of.
bool isRecordedPlace(const std::string& path, const std::string& batch);

/// A path that a catalogue may list, in whatever batch's folder, in its canonical form (checkedPath
/// of store/values.h). Error: UnusableInput.
Result<std::string> recordedPath(std::string_view path);

/// Where a merge may put a file of a batch that comes with all its files: anywhere in the folders
/// of the batch, but nothing hidden or unfinished and no lock; in imported/ as above.
bool isPlaceOfFiles(const std::string& path);

}  // namespace ostraka::catalogue
