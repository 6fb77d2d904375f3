#pragma once
#include <chrono>
#include <filesystem>
#include <optional>

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
  ~Hold();
  Hold(Hold&& other) noexcept : fd_(other.fd_) { other.fd_ = -1; }
  Hold& operator=(Hold&&) = delete;

 private:
  explicit Hold(int fd) : fd_(fd) {}
  int fd_;
};

}  // namespace ostraka
