#pragma once
#include <filesystem>
#include <map>
#include <stop_token>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "catalogue/catalogue.h"
#include "files/open_folder.h"
#include "store/database.h"

namespace ostraka::upkeep {

Error notAPlaceOfFiles(const std::string& path);

/// Where files of a merge wait, whole, until the catalogue that names them is saved.
inline constexpr const char* kStagingFolder = "merge.partial";

/// SHA-256 of the file in a place; empty: nothing is there. Errors: those of OpenFolder::read.
Result<std::string> sha256At(const OpenFolder& project, const ContainedPath& place,
                             const std::stop_token& stop);

struct StagedFile {
  std::string name;  ///< in merge.partial: as its place, so that the disk accepts it there, too
  std::string over;  ///< sha256At of its place when it was staged
};
using StagedFiles = std::map<std::string, StagedFile>;  ///< by their places in the project

/// Within the transaction that saves the catalogue (setting merge.files); none: forgets them.
Result<void> noteStaged(catalogue::Catalogue& catalogue, const StagedFiles& files);

/// Moves the noted files to their places and forgets them; whoever calls it holds the project's
/// lock. Where people decided or painted meanwhile, both lists are joined. Other files that changed
/// meanwhile stay, with all of their folder (results/B0031), so that no folder has files of two
/// computations. Files that cannot be moved (a folder or a link lies in the place, the disk does
/// not accept the name) go on waiting for the next call. Returns these folders and files, each with
/// a warning. Killed at any moment, the same call goes on. Errors: UnusableInput for a place that
/// is not of files, CannotWrite (the catalogue), Cancelled.
Result<std::vector<std::string>> placeStaged(catalogue::Catalogue& catalogue,
                                             const std::filesystem::path& project,
                                             Progress& progress, const std::stop_token& stop);

/// Error: UnusableInput, of a file that waits since an earlier merge.
Result<void> checkNoneWaits(const catalogue::Catalogue& catalogue,
                            const std::filesystem::path& project);

/// The same under the project's lock, where a merge that was killed left any.
Result<std::vector<std::string>> finishMerge(catalogue::Catalogue& catalogue,
                                             const std::filesystem::path& project,
                                             const store::Waiting& waiting);

}  // namespace ostraka::upkeep
