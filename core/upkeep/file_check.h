#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "catalogue/catalogue.h"
#include "files/checksum.h"

namespace ostraka::upkeep {

/// A file that the catalogue knows, with the numbers by which people know what it is of.
struct KnownFile {
  std::string path, sha256, role;
  std::int64_t bytes = 0;
  std::string sherd, batch;  ///< numbers; a draft's id; empty where it is of none
};
/// In the order of their paths. Without the scans and reports of batches that wait to be computed
/// or are being computed: those are replaced before the catalogue knows the new ones.
Result<std::vector<KnownFile>> knownFiles(const catalogue::Catalogue& catalogue);

enum class Damage { Missing, Changed, Unreadable };
struct DamagedFile {
  KnownFile file;
  Damage damage = Damage::Missing;
};
/// "models/B0001/…/model.ply (sherd ARM1-T3-0012-0007, batch B0001) was changed since it was
/// entered.", for logs and lists.
std::string sentenceOf(const DamagedFile& damaged);
/// What is wrong with a file of which this was read; none if it is as it was entered.
std::optional<Damage> damageOf(const KnownFile& file, const Checksum& found);

enum class CheckDepth { Hashes, NamesAndSizes };
struct CheckedFiles {
  std::int64_t files = 0;    ///< that the catalogue knows
  std::int64_t checked = 0;  ///< by this call; the others by earlier ones
  std::vector<DamagedFile> damaged;
};
/// All of them, against what the catalogue holds, and the decisions and mask strokes of people
/// (peoples_file_check.h), which are not counted. Progress counts bytes. A check of hashes that was
/// interrupted in the last seven days resumes where FOLDER/file-checks.txt says that it stopped;
/// files that were damaged or changed since are checked again. Errors: Cancelled, those of the
/// catalogue.
Result<CheckedFiles> checkFiles(const catalogue::Catalogue& catalogue,
                                const std::filesystem::path& folder, CheckDepth depth,
                                Progress& progress, std::stop_token stop);

/// Every page of the catalogue, then some of the files: those that were damaged at their last
/// check, then those checked longest ago, until most_bytes are read; and those of people. Errors:
/// Damaged (the catalogue itself), Cancelled, those of the catalogue.
Result<CheckedFiles> checkShare(const catalogue::Catalogue& catalogue,
                                const std::filesystem::path& folder, std::int64_t most_bytes,
                                Progress& progress, std::stop_token stop);

/// That every path in the catalogue stays within the project, and so do the folders that are made,
/// emptied and removed by the numbers of batches: a catalogue from elsewhere may contain anything.
Result<void> checkPaths(const catalogue::Catalogue& catalogue);
/// That neither the project's cluster/ nor anything below it is a link: jobs write there, results
/// are moved and removed there, and what a link leads to may belong to others. Error:
/// UnusableInput, which names the link.
Result<void> checkNoLinkInCluster(const std::filesystem::path& project);

}  // namespace ostraka::upkeep
