#pragma once
#include <filesystem>

#include "base/result.h"

namespace ostraka {

/// Holds a folder for one program at a time: an advisory lock on FOLDER/lock that ends with this
/// object, or with the process however that ends. Where a file system knows no locks (some network
/// shares) it holds nothing and says nothing.
class FolderLock {
 public:
  /// Error: CannotWrite when another holds the folder.
  static Result<FolderLock> take(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(FolderLock&& other) noexcept : fd_(other.fd_) { other.fd_ = -1; }
  FolderLock& operator=(FolderLock&&) = delete;

 private:
  explicit FolderLock(int fd) : fd_(fd) {}
  int fd_;
};

}  // namespace ostraka
