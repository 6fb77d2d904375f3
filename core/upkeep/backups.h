#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"
#include "catalogue/catalogue.h"

namespace ostraka::upkeep {

/// 20261121-181557-123, UTC: sorts as time does.
std::string timeStamp(std::int64_t now_ms);
/// Of a project's folder, the newest first; those of a time that is still to come are last.
std::vector<std::filesystem::path> backupsOf(const std::filesystem::path& folder,
                                             std::int64_t now_ms);
/// A copy of the project's catalogue in backups/, read back; kind stands behind its time. Copies of
/// the kinds -before-update and -before-repair are never removed.
Result<std::filesystem::path> backUpInto(const std::filesystem::path& folder,
                                         const catalogue::Catalogue& catalogue,
                                         const std::string& kind);

}  // namespace ostraka::upkeep
