#include "files/cannot_write.h"

#include <cerrno>
#include <cstring>
#include <string>
#include <system_error>

namespace ostraka {

Error cannotWrite(const std::filesystem::path& path, int reason) {
  const bool full = reason == ENOSPC || reason == EDQUOT;
  return {ErrorCode::CannotWrite,
          full ? "The disk is full; free some space and try again."
               : "The file or folder cannot be written (" + std::string(std::strerror(reason)) +
                     "); choose another location, or check its permissions.",
          path.string()};
}

Result<void> makeFolder(const std::filesystem::path& folder) {
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  return failed ? Result<void>(cannotWrite(folder, failed.value())) : Result<void>();
}

}  // namespace ostraka
