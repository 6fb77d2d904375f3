#include "decisions/change_peoples_file.h"

#include <chrono>
#include <optional>
#include <thread>

#include "base/message.h"
#include "files/folder_lock.h"

namespace ostraka::decisions {
namespace {

namespace fs = std::filesystem;

// A change takes milliseconds. Who stops within one, such as a program in a debugger, keeps no
// window from answering for ever.
constexpr std::chrono::seconds kMostWaiting(10);
constexpr std::chrono::milliseconds kPause(2);

// None: there is no OUT, and the lock makes none.
Result<std::optional<FolderLock>> heldOutput(const fs::path& output) {
  const auto end = std::chrono::steady_clock::now() + kMostWaiting;
  for (;; std::this_thread::sleep_for(kPause)) {
    std::error_code failed;
    if (!fs::is_directory(output, failed)) return std::optional<FolderLock>();
    Result<FolderLock> held = FolderLock::take(output);
    if (held) return std::optional<FolderLock>(std::move(*held));
    if (fs::is_symlink(output / kLockFile, failed)) return held.error();
    if (std::chrono::steady_clock::now() >= end)
      return Error{ErrorCode::CannotWrite,
                   message("Another program is writing decisions or masks of this batch, so "
                           "nothing was saved; try again in a moment."),
                   output.string()};
  }
}

}  // namespace

Result<void> changePeoplesFile(const fs::path& output,
                               const std::function<Result<void>()>& change) {
  Result<std::optional<FolderLock>> held = heldOutput(output);
  if (!held) return held.error();
  const Result<void> changed = change();
  if (*held) (*held)->endWithoutTrace();  // people look for their results there
  return changed;
}

}  // namespace ostraka::decisions
