#pragma once
#include <chrono>
#include <filesystem>
#include <optional>

namespace ostraka {

/// Holds a file or a folder that is there, for one holder at a time, until this object or its
/// process ends: what nobody holds although it is unfinished was left by a process that is gone.
class Hold {
 public:
  /// None when another holds it, or it is not there.
  static std::optional<Hold> take(const std::filesystem::path& path);
  /// Waits at most so long for another one.
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
