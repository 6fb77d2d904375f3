#pragma once
#include <cstdint>
#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "upkeep/file_check.h"
#include "upkeep/project.h"

namespace ostraka::archive {

/// What becomes of an archive when files of the catalogue are missing or changed.
enum class DamagedFiles { Refuse, Seal };

struct ArchiveOptions {
  std::filesystem::path target;     ///< new folder
  std::string program = "ostraka";  ///< with its version
  DamagedFiles damaged = DamagedFiles::Refuse;
};
struct Archived {
  bool sealed = false;  ///< else nothing was left at the target
  std::int64_t bytes = 0;
  std::vector<upkeep::DamagedFile> damage;
  std::vector<std::string> links;  ///< in the project; what they lead to is not archived
  bool whole() const { return damage.empty() && links.empty(); }
};
/// The whole project, catalogue and all files, as a bag: what a laptop that is lost leaves behind.
/// README.txt says what it is and how it is restored.
/// Each file of the catalogue that is archived is held against its hash while it is copied; an
/// archive that is sealed with damage lists it in damage.txt. Links are not followed: each counts
/// as damage, and the catalogue's files behind it as missing. Errors: the target is there or lies
/// in the project, a folder that cannot be read, a full disk, Cancelled.
Result<Archived> archiveProject(const upkeep::Project& project, const ArchiveOptions& options,
                                Progress& progress, std::stop_token stop);

struct Restored {
  std::vector<Message> damage;  ///< with which it was archived, a sentence a file
};
/// Into a new folder, after all hashes agreed; each file is hashed again as it is copied, and the
/// catalogue is checked before the folder gets its name. Its queue is paused where batches wait
/// (catalogue/queue_pause.h). Reports two stages. Errors as BagReader::open, and UnusableInput for
/// a catalogue that names places outside the project, has a journal beside it, or tables, triggers
/// or values that Ostraka does not make; nothing stays.
Result<Restored> restoreProject(const std::filesystem::path& archive,
                                const std::filesystem::path& folder, Progress& progress,
                                std::stop_token stop);

}  // namespace ostraka::archive
