#pragma once
#include <filesystem>
#include <string_view>

namespace ostraka {

/// A text file that grows at its end. A link of its name is replaced, not followed; where a pipe or
/// device has the name, or nothing can be written, nothing is.
class LogFile {
 public:
  explicit LogFile(const std::filesystem::path& path);
  ~LogFile();
  LogFile(const LogFile&) = delete;
  LogFile& operator=(const LogFile&) = delete;

  /// Written at once, so that it is there if the program ends the next moment.
  void line(std::string_view text);
  /// For a program that writes into it; negative when it is not open.
  int descriptor() const { return fd_; }

 private:
  int fd_;
};

}  // namespace ostraka
