#pragma once
#include <filesystem>

#include "base/result.h"
#include "files/hold.h"

namespace ostraka::store {

/// A database that is being written beside its place. It goes with this object unless it was given
/// its name; what a killed process left is removed by whoever writes there next.
class PartialFile {
 public:
  /// An empty file FILE.<process>-<n>.partial, held. The folder is there.
  static Result<PartialFile> beside(const std::filesystem::path& file);
  ~PartialFile();
  PartialFile(PartialFile&& other) noexcept;
  PartialFile& operator=(PartialFile&&) = delete;

  const std::filesystem::path& path() const { return path_; }
  enum class Existing { Replaced, Refused };
  /// Synced and renamed. No connection to it may be open.
  Result<void> become(const std::filesystem::path& file, Existing existing);

  /// What nobody holds any more, SQLite's own files beside them too.
  static void removeLeftovers(const std::filesystem::path& folder);
  static bool isLeftover(const std::filesystem::path& file);

 private:
  PartialFile(std::filesystem::path path, Hold hold)
      : path_(std::move(path)), hold_(std::move(hold)) {}
  std::filesystem::path path_;
  Hold hold_;
};

}  // namespace ostraka::store
