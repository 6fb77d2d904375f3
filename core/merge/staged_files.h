#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <stop_token>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "catalogue/catalogue.h"
#include "merge/outcome.h"
#include "upkeep/staged_files.h"

namespace ostraka::merge {

/// Files on their way into a project: they wait in PROJECT/merge.partial, whole, until the
/// catalogue that names them is saved, and are then moved to their places (upkeep::placeStaged).
/// The same transaction records which file goes where, so that whoever opens the project next
/// completes a merge that was killed in between; of one that was killed earlier the next merge
/// removes what it copied.
class StagedFiles {
 public:
  explicit StagedFiles(std::filesystem::path project) : project_(std::move(project)) { drop(); }
  /// Each is compared with its checksum, in B's catalogue and after writing. Files that B lacks are
  /// listed, and their batches noted, so that the next merge looks for them. Each waits under the
  /// path of its place, so that names which the disk refuses, or takes for one, show now. Error:
  /// UnusableInput for such a name, a file that differs from B's catalogue, a link, or a place
  /// taken by another file that FileCopy::replaces does not allow to replace.
  Result<void> copy(const std::filesystem::path& b, const std::vector<FileCopy>& files,
                    Progress& progress, const std::stop_token& stop);
  /// Before the file in this place is read for what put() makes of it.
  Result<void> expect(const std::string& to, const std::stop_token& stop);
  Result<void> put(const std::string& to, const std::string& bytes);
  /// Within the transaction.
  Result<void> note(catalogue::Catalogue& catalogue, const Outcome& outcome) const;
  /// Where nothing was saved.
  void drop();

  const std::vector<std::string>& missing() const { return missing_; }
  int files() const { return static_cast<int>(staged_.size()); }
  std::int64_t bytes() const { return bytes_; }

 private:
  std::filesystem::path project_;
  upkeep::StagedFiles staged_;
  std::map<std::string, std::string> expected_;  ///< by place: as StagedFile::over
  std::vector<std::string> missing_;
  std::set<std::string> incomplete_;  ///< batches of A that lack them
  std::int64_t bytes_ = 0;
};

/// The files below these folders of B and what its catalogue names, each once. Errors: a link.
Result<std::vector<FileCopy>> filesToCopy(const std::filesystem::path& a,
                                          const std::filesystem::path& b, const Outcome& outcome);

}  // namespace ostraka::merge
