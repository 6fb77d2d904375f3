#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <stop_token>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "catalogue/catalogue.h"
#include "files/open_folder.h"
#include "merge/outcome.h"

namespace ostraka::merge {

/// The folders of a project's files, one for each batch: a merge writes nowhere else but in
/// imported/, where the files of imported exports lie, of whatever batch.
inline constexpr const char* kFoldersOfBatches[] = {"batches/", "results/", "models/"};
bool isPlaceOfFiles(const std::string& path);
Error notAPlaceOfFiles(const std::string& path);

/// Files on their way into a project: they wait in PROJECT/merge.partial, whole, until the
/// catalogue that names them is saved, and are then renamed to their places. The same transaction
/// records which file goes where (setting merge.files), so that the next merge completes one that
/// was killed in between, and one that was killed earlier leaves nothing.
class StagedFiles {
 public:
  /// After what an earlier merge left was completed or removed.
  static Result<StagedFiles> begin(catalogue::Catalogue& catalogue,
                                   const std::filesystem::path& project);
  /// Each is compared with its checksum, in B's catalogue and after writing. Files that B lacks are
  /// listed. Error: UnusableInput for a file that differs from B's catalogue, a link, or a place
  /// taken by another file that FileCopy::replaces does not allow to replace.
  Result<void> copy(const std::filesystem::path& b, const std::vector<FileCopy>& files,
                    Progress& progress, const std::stop_token& stop);
  Result<void> put(const std::string& to, const std::string& bytes);
  /// Within the transaction.
  Result<void> note(catalogue::Catalogue& catalogue) const;
  /// After it.
  Result<void> finish(catalogue::Catalogue& catalogue);
  /// Where nothing was saved.
  void drop();

  const std::vector<std::string>& missing() const { return missing_; }
  int files() const { return static_cast<int>(staged_.size()); }
  std::int64_t bytes() const { return bytes_; }

 private:
  explicit StagedFiles(std::filesystem::path project) : project_(std::move(project)) {}
  std::string nextName();
  std::filesystem::path project_;
  std::map<std::string, std::string> staged_;  ///< its final place -> its temporary name
  std::vector<std::string> missing_;
  std::int64_t bytes_ = 0;
  int names_ = 0;
};

/// The files below these folders of B and what its catalogue names, each once. Errors: a link.
Result<std::vector<FileCopy>> filesToCopy(const std::filesystem::path& b, const Outcome& outcome);

}  // namespace ostraka::merge
