#include "files/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <thread>

#include "base/message.h"

namespace ostraka {

Result<std::pair<FolderLock, FolderLock::Held>> FolderLock::tryTo(
    const std::filesystem::path& folder) {
  std::error_code ignored;
  std::filesystem::create_directories(folder, ignored);
  const std::filesystem::path file = folder / kLockFile;
  FileDescriptor lock(
      ::open(file.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, 0666));
  if (!lock.isOpen() && errno == ELOOP)
    return Error{ErrorCode::CannotWrite,
                 message("A link has taken the place of this folder's lock file; delete the link."),
                 file.string()};
  // Without a file nothing is held; who writes there next says why it cannot.
  const bool elsewhere =
      lock.isOpen() && ::flock(lock.get(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  return std::pair(FolderLock(folder, std::move(lock)), elsewhere ? Held::Elsewhere : Held::Here);
}

// One that was taken of a file or folder that went away meanwhile keeps nobody out of the new one.
bool FolderLock::holdsNothingOrStands() const {
  return !file_.isOpen() || stands();
}

Result<FolderLock> FolderLock::take(const std::filesystem::path& folder) {
  constexpr int kMostTries = 100;  // a share may number its files anew each time it is asked
  for (int tries = 1;; ++tries) {
    Result<std::pair<FolderLock, Held>> tried = tryTo(folder);
    if (!tried) return tried.error();
    if (tried->second == Held::Elsewhere)
      return Error{ErrorCode::CannotWrite,
                   message("Another run is writing to this folder. What it has saved is kept, and "
                           "this run has changed nothing; wait until the other one ends, or choose "
                           "another folder."),
                   folder.string()};
    if (tried->first.holdsNothingOrStands() || tries == kMostTries) return std::move(tried->first);
  }
}

Result<FolderLock> FolderLock::waitFor(const std::filesystem::path& folder, const Message& waiting,
                                       Progress& progress, const std::stop_token& stop) {
  constexpr std::chrono::milliseconds kPause(50);
  bool noted = false;
  for (;; std::this_thread::sleep_for(kPause)) {
    if (stop.stop_requested()) return Error::cancelled();
    Result<std::pair<FolderLock, Held>> tried = tryTo(folder);
    if (!tried) return tried.error();
    const bool here = tried->second == Held::Here;
    if (here && tried->first.holdsNothingOrStands()) return std::move(tried->first);
    if (!here && !std::exchange(noted, true)) progress.note(NoteLevel::Warning, waiting);
  }
}

// By the file that is held open: its number cannot be given to another meanwhile.
bool FolderLock::stands() const {
  std::error_code failed;
  if (!file_.isOpen()) return std::filesystem::is_directory(folder_, failed);
  struct stat held {
  }, there{};
  return ::fstat(file_.get(), &held) == 0 && ::stat((folder_ / kLockFile).c_str(), &there) == 0 &&
         held.st_dev == there.st_dev && held.st_ino == there.st_ino;
}

// While it is held: nobody else can hold the file that goes.
void FolderLock::endWithoutTrace() {
  std::error_code ignored;
  if (file_.isOpen() && stands()) std::filesystem::remove(folder_ / kLockFile, ignored);
  file_ = FileDescriptor();
}

}  // namespace ostraka
