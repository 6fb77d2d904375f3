#pragma once
#include <filesystem>

namespace ostraka::upkeep {

/// The archive of a project (archive::archiveProject) whose folder, or whose data, this is,
/// wherever links lead from; empty: it is neither.
std::filesystem::path archiveAt(const std::filesystem::path& folder);

}  // namespace ostraka::upkeep
