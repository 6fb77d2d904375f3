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
/// filled: the folder of a project, such as "results", in which a command may create one folder:
/// PROJECT/results/NAME, unless a link is there. Error: UnusableInput.
Result<void> checkOutputPlace(const std::filesystem::path& target, std::string_view filled = {});

/// The same for a file that a command is told to write: it must have one of these endings (".pdf",
/// in any case), so that a mistyped name does not overwrite another file, and it must not be a
/// folder or, under any name, one of the files that the command reads. Error: UnusableInput.
Result<void> checkOutputFile(const std::filesystem::path& file,
                             const std::vector<std::string>& endings,
                             const std::vector<std::filesystem::path>& inputs = {});

enum class LinkedFolders { OfTheseNames, AndBelow, AndLinksToFiles };
/// Rejects links that have taken the place of folders that the program fills and empties: what they
/// lead to may belong to others. names: relative paths of those folders, which need not exist yet.
/// Links to files below them are left to the writers, which replace them, unless these are programs
/// that follow links. Error: UnusableInput, which names the link.
Result<void> checkNoLinkedFolder(const std::filesystem::path& folder,
                                 std::span<const std::string_view> names, LinkedFolders which);

/// The same for all folders between a project and a place in it, and for the place itself: what a
/// link leads to does not belong to the project and enters no catalogue. Passes places outside
/// projects.
Result<void> checkNoLinkInProject(const std::filesystem::path& place);

}  // namespace ostraka
