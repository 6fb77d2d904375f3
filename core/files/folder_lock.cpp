#include "files/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

namespace ostraka {

Result<FolderLock> FolderLock::take(const std::filesystem::path& folder) {
  std::error_code ignored;
  std::filesystem::create_directories(folder, ignored);
  const std::filesystem::path file = folder / "lock";
  const int fd = ::open(file.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, 0666);
  if (fd < 0 && errno == ELOOP)
    return Error{ErrorCode::CannotWrite,
                 "A link has taken the place of this folder's lock file; delete the link.",
                 file.string()};
  if (fd < 0) return FolderLock(folder, -1);  // who writes there next says why it cannot
  if (::flock(fd, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    ::close(fd);
    return Error{
        ErrorCode::CannotWrite,
        "Another run is writing to this folder; wait until it ends, or choose another folder.",
        folder.string()};
  }
  return FolderLock(folder, fd);
}

// By the file that is held open: its number cannot be given to another meanwhile.
bool FolderLock::stands() const {
  std::error_code failed;
  if (fd_ < 0) return std::filesystem::is_directory(folder_, failed);
  struct stat held {
  }, there{};
  return ::fstat(fd_, &held) == 0 && ::stat((folder_ / "lock").c_str(), &there) == 0 &&
         held.st_dev == there.st_dev && held.st_ino == there.st_ino;
}

FolderLock::~FolderLock() {
  if (fd_ >= 0) ::close(fd_);
}

}  // namespace ostraka
