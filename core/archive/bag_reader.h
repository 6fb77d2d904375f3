#pragma once
#include <filesystem>
#include <map>
#include <stop_token>
#include <string>
#include <vector>

#include "archive/bagit.h"
#include "base/progress.h"
#include "base/result.h"
#include "files/open_folder.h"

namespace ostraka::archive {

/// A bag that anybody may have written, and may be changing. Its manifests are read once; what is
/// read of a file later is held against them again, so that no other file takes its place.
class BagReader {
 public:
  /// After all hashes agreed. Errors: UnusableInput for a file that is missing, changed, a link or
  /// not listed; a path that does not lie in data/, leads out of it, or is the same as another on
  /// other systems; a tag file that is none of ours.
  static Result<BagReader> open(const std::filesystem::path& folder, Progress& progress,
                                std::stop_token stop);
  const std::vector<BagFile>& files() const { return files_; }
  /// By its path in the bag, data/...; null when there is none.
  const BagFile* find(const std::string& path) const;
  /// Its bytes. Errors: it is larger than max_bytes, or another one by now.
  Result<std::string> read(const BagFile& file, std::size_t max_bytes) const;
  /// Into a new file. Errors: a file is there, it is another one by now, CannotWrite, Cancelled.
  Result<void> copy(const BagFile& file, const OpenFolder& to, const ContainedPath& as,
                    const std::stop_token& stop) const;
  /// What damage.txt says, a line each; empty for a bag that was sealed whole.
  const std::vector<Message>& damage() const { return damage_; }

 private:
  explicit BagReader(OpenFolder folder) : folder_(std::move(folder)) {}
  Result<std::map<std::string, std::string>> tagFiles() const;
  Result<std::map<std::string, std::string>> listed(const std::string& manifest) const;
  Result<void> checkNames(const std::map<std::string, std::string>& hashes) const;
  std::string where(const std::string& path) const { return (folder_.path() / path).string(); }
  OpenFolder folder_;
  std::vector<BagFile> files_;  ///< in the order of their paths
  std::vector<Message> damage_;
};

}  // namespace ostraka::archive
