#pragma once
#include <cstddef>
#include <filesystem>
#include <string>

#include "base/result.h"

namespace ostraka {

/// A regular file, opened for reading: all files that people name are opened this way. A folder,
/// pipe, device or socket is rejected by its kind, so that nothing waits for a writer that may
/// never come.
class InputFile {
 public:
  /// Error: UnusableInput.
  static Result<InputFile> open(const std::filesystem::path& path);
  ~InputFile();
  InputFile(InputFile&& other) noexcept;
  InputFile& operator=(InputFile&&) = delete;

  /// When it was opened.
  std::size_t size_bytes() const { return size_bytes_; }
  /// The next bytes, at most this many; fewer at the end of the file.
  Result<std::string> read(std::size_t most_bytes);

 private:
  InputFile(int fd, std::size_t size_bytes, std::filesystem::path path);
  int fd_;
  std::size_t size_bytes_;
  std::filesystem::path path_;
};

/// A sentence that says what is there instead of a regular file; empty for a regular file and for
/// nothing. A link counts as what it leads to.
Message otherThanAFile(const std::filesystem::path& path);

}  // namespace ostraka
