#pragma once
#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"
#include "catalogue/catalogue.h"
#include "records/records.h"
#include "store/database.h"

namespace ostraka::upkeep {

/// A project is a folder:
///   catalogue.sqlite
///   batches/B0031/    photographs, a batch folder as `ostraka process` reads it
///   results/B0031/    OUT of `ostraka process`
///   models/B0031/     the models that the catalogue shows (keepModel)
///   backups/          copies of the catalogue, the newest last by name
class Project {
 public:
  /// Makes the folder (new or empty); its catalogue gets its name last, so that a killed process
  /// leaves nothing that is a project, and the same call makes it. Errors: UnusableInput (not
  /// empty, code, numbering), a folder on a network share, CannotWrite.
  static Result<Project> create(const std::filesystem::path& folder,
                                const records::ProjectRecord& record,
                                const catalogue::Catalogue::Clock& clock = {});
  /// Opens it; an older schema is brought up to date after a backup, a newer one is refused, and a
  /// merge that was killed after its catalogue was saved is completed (keptFiles()). Where nothing
  /// can be written it is open for reading only (catalogue().readOnly()). Errors: Damaged, see
  /// catalogue/repair.h; UnusableInput where the catalogue names a place outside the project, and
  /// in an archive that can be written to.
  static Result<Project> open(const std::filesystem::path& folder,
                              const catalogue::Catalogue::Clock& clock = {},
                              const store::Waiting& waiting = {});
  /// Removes a project in which nobody worked: its history is no longer than `history`, and its
  /// folder holds nothing but what the program makes of itself. False otherwise; it stays then. It
  /// must be closed. Errors: those of open, CannotWrite.
  static Result<bool> removeUnused(const std::filesystem::path& folder, std::int64_t history);
  static bool isProject(const std::filesystem::path& folder);

  const std::filesystem::path& folder() const { return folder_; }
  catalogue::Catalogue& catalogue() { return catalogue_; }
  const catalogue::Catalogue& catalogue() const { return catalogue_; }
  /// A separate connection for another thread; callable from any thread.
  static Result<catalogue::Catalogue> connect(const std::filesystem::path& folder);

  /// What such a merge left as it is, since it was changed meanwhile.
  const std::vector<std::string>& keptFiles() const { return kept_files_; }

  std::filesystem::path batchFolder(const std::string& number) const;
  std::filesystem::path resultsFolder(const std::string& number) const;

  /// Into backups/, checked by reading it back. This one and the `keep` whose history goes furthest
  /// stay, of each of the latest `days` (UTC) with a copy the last one, all with changes that this
  /// one lacks, and what is no copy of this project. Returns the file.
  Result<std::filesystem::path> backUp(int keep = 20, int days = 30) const;
  /// The same if anything changed since the newest copy and that is at least `after` old.
  /// Returns whether a copy was made.
  Result<bool> backUpIfChanged(std::chrono::milliseconds after = std::chrono::hours(1)) const;
  /// Newest first; those with a time in the future are last and never removed.
  std::vector<std::filesystem::path> backups() const;

 private:
  Project(std::filesystem::path folder, catalogue::Catalogue catalogue)
      : folder_(std::move(folder)), catalogue_(std::move(catalogue)) {}
  std::filesystem::path folder_;
  catalogue::Catalogue catalogue_;
  std::vector<std::string> kept_files_;
};

/// Refuses the data of an archive, wherever links lead from: opening it for writing alone changes
/// files whose hashes the archive states.
Result<void> checkOutsideArchives(const std::filesystem::path& project);

}  // namespace ostraka::upkeep
