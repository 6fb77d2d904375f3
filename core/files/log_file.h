#pragma once
#include <filesystem>
#include <string_view>

#include "files/file_descriptor.h"

namespace ostraka {

/// A text file that is appended to. A link with its name is replaced, not followed; nothing is
/// written if a pipe or device has the name or the file cannot be written.
class LogFile {
 public:
  explicit LogFile(const std::filesystem::path& path);
  /// Written immediately, so that it survives if the program ends the next moment.
  void line(std::string_view text);
  /// For a program that writes into it; negative if it is not open.
  int descriptor() const { return file_.get(); }

 private:
  FileDescriptor file_;
};

}  // namespace ostraka
