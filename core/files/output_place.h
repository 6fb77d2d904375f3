#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace ostraka {

/// Whether something new may be made at a place that a person chose: not in a project (a folder
/// with a catalogue.sqlite) and not in an archive or export (one with a bagit.txt), whose files are
/// theirs alone. target: a file or a folder, which need not be there; links are followed.
/// filled: the folder of a project, as "results", in which a command makes one folder, and that
/// alone is no harm: PROJECT/results/NAME, as long as no link stands there. Error: UnusableInput.
Result<void> checkOutputPlace(const std::filesystem::path& target, std::string_view filled = {});

/// The same of a file that a command is told to write: it must have one of these endings (".pdf",
/// in capitals or not), so that a mistyped name does not cost another file, be no folder, and be
/// none of the files that the command reads, by whatever name. Error: UnusableInput.
Result<void> checkOutputFile(const std::filesystem::path& file,
                             const std::vector<std::string>& endings,
                             const std::vector<std::filesystem::path>& inputs = {});

enum class LinkedFolders { OfTheseNames, AndBelow };
/// Refuses links that have taken the place of folders that the program fills and empties: what lies
/// behind them is not its own. names: relative paths of those folders, or of what is not there
/// yet. Links to files below them are left to the writers, which replace them. Error:
/// UnusableInput, which names the link.
Result<void> checkNoLinkedFolder(const std::filesystem::path& folder,
                                 std::span<const std::string_view> names, LinkedFolders which);

/// The same of all folders that lead from a project to a place in it, and of the place: what a link
/// leads to is not the project's, and enters no catalogue. Good for places in no project.
Result<void> checkNoLinkInProject(const std::filesystem::path& place);

}  // namespace ostraka
