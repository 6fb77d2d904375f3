#include "files/files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>
#include <vector>

#include "base/message.h"
#include "files/open_folder.h"
#include "files/unfinished_file.h"

namespace ostraka {
namespace {

// As it was before; a group that cannot be kept gets no more than everybody.
bool takeOver(int fd, const struct stat& before) {
  struct stat now {};
  if (::fstat(fd, &now) != 0) return false;
  mode_t mode = before.st_mode & 0777;
  const bool same = now.st_uid == before.st_uid && now.st_gid == before.st_gid;
  if (!same && ::fchown(fd, before.st_uid, before.st_gid) != 0 &&
      ::fchown(fd, static_cast<uid_t>(-1), before.st_gid) != 0)
    mode &= ~070U | (mode & 07U) << 3;
  return ::fchmod(fd, mode) == 0;
}

}  // namespace

Result<std::string> readFile(const std::filesystem::path& path, std::size_t max_bytes) {
  Result<OpenFile> file = OpenFile::open(path);
  return file ? file->readAll(max_bytes) : Result<std::string>(file.error());
}

// A link of this name is replaced by the file, and what it led to stays as it is: nothing outside
// of the folder is ever written. A file there before keeps its permissions, and its owner and group
// where that is allowed; a new one gets those that the person's umask says.
Result<void> writeFileAtomically(const std::filesystem::path& path, std::string_view bytes) {
  const std::filesystem::path in =
      path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
  if (Result<void> made = makeFolder(in); !made) return made;
  if (Message other = otherThanAFile(path); !other.empty())
    return Error{ErrorCode::CannotWrite, std::move(other), path.string()};
  const FileDescriptor folder(::open(in.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!folder.isOpen()) return cannotWrite(path, errno);
  const std::string name = path.filename().string();
  struct stat before {};
  const bool replaces = ::fstatat(folder.get(), name.c_str(), &before, AT_SYMLINK_NOFOLLOW) == 0 &&
                        S_ISREG(before.st_mode);
  const UnfinishedFile partial = beginFile(folder.get(), name, replaces ? 0600 : 0666);
  if (!partial.file.isOpen()) return cannotWrite(path, errno);
  const int file = partial.file.get();
  if ((replaces && !takeOver(file, before)) || !writeAll(file, bytes) || ::fsync(file) != 0 ||
      ::renameat(folder.get(), partial.name.c_str(), folder.get(), name.c_str()) != 0) {
    const int reason = errno;
    ::unlinkat(folder.get(), partial.name.c_str(), 0);
    return cannotWrite(path, reason);
  }
  ::fsync(folder.get());
  return {};
}

Result<void> copyFile(const std::filesystem::path& from, const std::filesystem::path& to) {
  Result<OpenFile> source = OpenFile::open(from);
  if (!source) return source.error();
  struct stat original {};
  const mode_t mode = ::stat(from.c_str(), &original) == 0 ? original.st_mode & 0777 : mode_t{0600};
  const FileDescriptor target(
      ::open(to.c_str(), O_WRONLY | O_CREAT | O_NOFOLLOW | O_CLOEXEC, mode));
  struct stat there {};
  if (!target.isOpen() || ::fstat(target.get(), &there) != 0) return cannotWrite(to, errno);
  if (there.st_size > 0) return cannotWrite(to, EEXIST);
  const auto without = [&](const Error& error) {  // half a file would look like a whole one
    if (S_ISREG(there.st_mode)) ::unlink(to.c_str());
    return error;
  };
  std::vector<char> piece(std::size_t{1} << 20);
  for (;;) {
    const Result<std::size_t> bytes = source->read(piece);
    if (!bytes) return without(bytes.error());
    if (*bytes == 0) return {};
    if (!writeAll(target.get(), {piece.data(), *bytes})) return without(cannotWrite(to, errno));
  }
}

void syncFolder(const std::filesystem::path& folder) {
  const FileDescriptor opened(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (opened.isOpen()) ::fsync(opened.get());
}

Result<void> syncFile(const std::filesystem::path& file) {
  const FileDescriptor opened(::open(file.c_str(), O_RDONLY | O_CLOEXEC));
  if (!opened.isOpen() || ::fsync(opened.get()) != 0) return cannotWrite(file, errno);
  return {};
}

bool mayBeWritten(const std::filesystem::path& path) {
  return ::faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) == 0;
}

bool isFullDisk(int reason) {
  return reason == ENOSPC || reason == EDQUOT || reason == EFBIG;
}

Error cannotWrite(const std::filesystem::path& path, int reason) {
  return {ErrorCode::CannotWrite,
          isFullDisk(reason)
              ? message("The disk is full; free some space and try again.")
              : message("The file or folder cannot be written (%1); choose another location, or "
                        "check its permissions.",
                        std::string(std::strerror(reason))),
          path.string()};
}

Result<void> makeFolder(const std::filesystem::path& folder) {
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  return failed ? Result<void>(cannotWrite(folder, failed.value())) : Result<void>();
}

}  // namespace ostraka
