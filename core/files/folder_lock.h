#pragma once
#include <filesystem>
#include <stop_token>
#include <string_view>
#include <utility>

#include "base/progress.h"
#include "base/result.h"
#include "files/file_descriptor.h"

namespace ostraka {

/// Of the program that holds a folder, and part of nothing that is archived, sent or merged.
inline constexpr const char* kLockFile = "lock";

/// Holds a folder for one program at a time: an advisory lock on FOLDER/lock that ends with this
/// object, or with the process, however it ends. On a file system without locks (some network
/// shares) it silently holds nothing.
class FolderLock {
 public:
  /// Error: CannotWrite when another holds the folder.
  static Result<FolderLock> take(const std::filesystem::path& folder);
  /// Waits until nobody else holds the folder; if it has to wait, it notes `waiting` once. Errors:
  /// Cancelled, CannotWrite.
  static Result<FolderLock> waitFor(const std::filesystem::path& folder, const Message& waiting,
                                    Progress& progress, const std::stop_token& stop);
  const std::filesystem::path& folder() const { return folder_; }
  /// False once the folder was deleted or moved away, even if another now has its name.
  bool stands() const;
  /// Lets go and takes the file away: for folders in which people look for their own files.
  void endWithoutTrace();

 private:
  enum class Held { Here, Elsewhere };
  static Result<std::pair<FolderLock, Held>> tryTo(const std::filesystem::path& folder);
  FolderLock(std::filesystem::path folder, FileDescriptor file)
      : folder_(std::move(folder)), file_(std::move(file)) {}
  bool holdsNothingOrStands() const;
  std::filesystem::path folder_;
  FileDescriptor file_;
};

}  // namespace ostraka
