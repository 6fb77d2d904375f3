#pragma once
#include <filesystem>
#include <string_view>

#include "base/result.h"

namespace ostraka {

/// A new temporary folder that nobody else may enter. It is removed with its content when this
/// object ends.
class ScratchFolder {
 public:
  /// In `parent`, or in the system's folder for temporary files (TMPDIR, /tmp); its name begins
  /// with `name`. Error: CannotWrite.
  static Result<ScratchFolder> make(std::string_view name,
                                    const std::filesystem::path& parent = {});
  ~ScratchFolder();
  ScratchFolder(ScratchFolder&& other) noexcept;
  ScratchFolder& operator=(ScratchFolder&&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  explicit ScratchFolder(std::filesystem::path path) : path_(std::move(path)) {}
  std::filesystem::path path_;  // empty when it was handed on
};

}  // namespace ostraka
