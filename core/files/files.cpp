#include "files/files.h"

#include <fcntl.h>
#include <openssl/sha.h>
#include <sys/stat.h>
#include <unistd.h>
#include <string>

#include <array>
#include <cerrno>
#include <cstring>
#include <system_error>

#include "base/message.h"
#include "files/input_file.h"
#include "files/unfinished_file.h"

namespace ostraka {
namespace {

class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int get() const { return fd_; }
  bool open() const { return fd_ >= 0; }

 private:
  int fd_;
};

bool writeAll(int fd, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t n = ::write(fd, bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(n));
  }
  return true;
}

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
  Result<InputFile> file = InputFile::open(path);
  if (!file) return file.error();
  if (file->size_bytes() > max_bytes)
    return Error::unusable(
        message("The file is larger than the limit of %1 bytes; check that it is the right one.",
                max_bytes),
        path);
  return file->read(file->size_bytes());
}

// A link of this name is replaced by the file, and what it led to stays as it is: nothing outside
// of the folder is ever written. A file there before keeps its permissions, and its owner and group
// where that is allowed; a new one gets those that the person's umask says.
Result<void> writeFileAtomically(const std::filesystem::path& path, std::string_view bytes) {
  const std::filesystem::path in =
      path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
  std::error_code failed;
  std::filesystem::create_directories(in, failed);
  if (failed) return cannotWrite(in, failed.value());
  if (Message other = otherThanAFile(path); !other.empty())
    return Error{ErrorCode::CannotWrite, std::move(other), path.string()};
  const Descriptor folder(::open(in.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!folder.open()) return cannotWrite(path, errno);
  const std::string name = path.filename().string();
  struct stat before {};
  const bool replaces = ::fstatat(folder.get(), name.c_str(), &before, AT_SYMLINK_NOFOLLOW) == 0 &&
                        S_ISREG(before.st_mode);
  const UnfinishedFile partial = beginFile(folder.get(), name, replaces ? 0600 : 0666);
  const Descriptor file(partial.fd);
  if (!file.open()) return cannotWrite(path, errno);
  if ((replaces && !takeOver(file.get(), before)) || !writeAll(file.get(), bytes) ||
      ::fsync(file.get()) != 0 ||
      ::renameat(folder.get(), partial.name.c_str(), folder.get(), name.c_str()) != 0) {
    const int reason = errno;
    ::unlinkat(folder.get(), partial.name.c_str(), 0);
    return cannotWrite(path, reason);
  }
  ::fsync(folder.get());
  return {};
}

void syncFolder(const std::filesystem::path& folder) {
  const Descriptor opened(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (opened.open()) ::fsync(opened.get());
}

Result<void> syncFile(const std::filesystem::path& file) {
  const Descriptor opened(::open(file.c_str(), O_RDONLY | O_CLOEXEC));
  if (!opened.open() || ::fsync(opened.get()) != 0) return cannotWrite(file, errno);
  return {};
}

bool mayBeWritten(const std::filesystem::path& path) {
  return ::faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) == 0;
}

std::string sha256(std::string_view bytes) {
  std::array<unsigned char, SHA256_DIGEST_LENGTH> digest{};
  SHA256(reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(), digest.data());
  std::string hex;
  for (const unsigned char byte : digest) {
    hex += "0123456789abcdef"[byte >> 4];
    hex += "0123456789abcdef"[byte & 15];
  }
  return hex;
}

Error cannotWrite(const std::filesystem::path& path, int reason) {
  const bool full = reason == ENOSPC || reason == EDQUOT;
  return {ErrorCode::CannotWrite,
          full ? message("The disk is full; free some space and try again.")
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
