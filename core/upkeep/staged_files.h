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
  std::string name;  ///< in merge.partial
  std::string over;  ///< sha256At of its place when it was staged
};
using StagedFiles = std::map<std::string, StagedFile>;  ///< by their places in the project

/// Within the transaction that saves the catalogue (setting merge.files).
Result<void> noteStaged(catalogue::Catalogue& catalogue, const StagedFiles& files);

/// Moves the noted files to their places and forgets them; whoever calls it holds the project's
/// lock. Where people decided or painted meanwhile, both lists are joined. Other files that changed
/// meanwhile stay, with all of their folder (results/B0031), so that no folder has files of two
/// computations; returns these folders. Killed at any moment, the same call goes on. Errors:
/// UnusableInput for a place that is not of files, CannotWrite, Cancelled.
Result<std::vector<std::string>> placeStaged(catalogue::Catalogue& catalogue,
                                             const std::filesystem::path& project,
                                             Progress& progress, const std::stop_token& stop);

/// The same under the project's lock, where a merge that was killed left any.
Result<std::vector<std::string>> finishMerge(catalogue::Catalogue& catalogue,
                                             const std::filesystem::path& project,
                                             const store::Waiting& waiting);

}  // namespace ostraka::upkeep
