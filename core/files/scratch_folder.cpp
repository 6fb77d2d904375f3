#include "files/scratch_folder.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>
#include <utility>

#include "base/message.h"

namespace ostraka {
namespace fs = std::filesystem;

Result<ScratchFolder> ScratchFolder::make(std::string_view name, const fs::path& parent) {
  std::error_code failed;
  const fs::path folder = parent.empty() ? fs::temp_directory_path(failed) : parent;
  std::string path = (folder / (std::string(name) + "-XXXXXX")).string();
  if (failed || ::mkdtemp(path.data()) == nullptr)  // for its owner alone (0700), never one there
    return Error{ErrorCode::CannotWrite,
                 message("No temporary folder can be created here (%1); free some space, or set "
                         "TMPDIR to another folder.",
                         (failed ? failed.message() : std::string(std::strerror(errno)))),
                 folder.string()};
  return ScratchFolder(fs::path(path));
}

ScratchFolder::ScratchFolder(ScratchFolder&& other) noexcept
    : path_(std::exchange(other.path_, {})) {}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  if (!path_.empty()) fs::remove_all(path_, ignored);
}

}  // namespace ostraka
