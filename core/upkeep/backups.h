#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"
#include "catalogue/catalogue.h"

namespace ostraka::upkeep {

/// 20261121-181557-123, UTC: sorts chronologically.
std::string timeStamp(std::int64_t now_ms);
/// Of a project's folder, the newest first; those with a time in the future are last.
std::vector<std::filesystem::path> backupsOf(const std::filesystem::path& folder,
                                             std::int64_t now_ms);
/// A copy of a catalogue, and the number of the last change that it contains.
struct Backup {
  std::filesystem::path file;
  std::string project;  ///< its id
  std::int64_t history = 0;
};
/// Those of `files` that are catalogues of one project, the one whose history goes furthest first,
/// as the clock may have been wrong; equal ones stay in their order. project: its id. All but their
/// schema may be damaged.
std::vector<Backup> copiesOf(const std::string& project,
                             const std::vector<std::filesystem::path>& files);
/// The id of the project that a folder is by its backups alone: of several that of which most files
/// lie in the folder; empty without any. Error: UnusableInput, as many of one lie there as of
/// another.
Result<std::string> projectIn(const std::filesystem::path& folder,
                              const std::vector<std::filesystem::path>& backups);
/// A copy of the project's catalogue in backups/, read back; kind follows its time. Copies of
/// the kinds -before-update and -before-repair are never removed.
Result<std::filesystem::path> backUpInto(const std::filesystem::path& folder,
                                         const catalogue::Catalogue& catalogue,
                                         const std::string& kind);

}  // namespace ostraka::upkeep
