#pragma once
#include <chrono>
#include <filesystem>
#include <optional>
#include <utility>

#include "files/file_descriptor.h"

namespace ostraka {

/// Holds an existing file or folder, for one holder at a time, until this object or its process
/// ends: an unfinished file that nobody holds was left by a process that no longer runs.
class Hold {
 public:
  /// None if another holds it or it does not exist.
  static std::optional<Hold> take(const std::filesystem::path& path);
  /// Waits at most this long for another holder.
  static std::optional<Hold> wait(const std::filesystem::path& path,
                                  std::chrono::milliseconds most);

 private:
  explicit Hold(FileDescriptor file) : file_(std::move(file)) {}
  FileDescriptor file_;
};

}  // namespace ostraka
