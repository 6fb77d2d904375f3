#include "files/input_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "base/message.h"

namespace ostraka {
namespace {

Message kindOf(mode_t mode) {
  if (S_ISDIR(mode)) return message("This is a folder, not a file; choose a file.");
  if (S_ISFIFO(mode)) return message("This is a pipe, not a file; choose a file.");
  if (S_ISSOCK(mode)) return message("This is a socket, not a file; choose a file.");
  if (S_ISCHR(mode) || S_ISBLK(mode))
    return message("This is a device, not a file; choose a file.");
  return {};
}

}  // namespace

Message otherThanAFile(const std::filesystem::path& path) {
  struct stat info {};
  return ::stat(path.c_str(), &info) == 0 ? kindOf(info.st_mode) : Message();
}

Result<InputFile> InputFile::open(const std::filesystem::path& path) {
  // Before it is opened: opening a device may do something to it.
  if (Message other = otherThanAFile(path); !other.empty())
    return Error::unusable(std::move(other), path);
  const int fd = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
  if (fd < 0)
    return Error::unusable(errno == ENOENT
                               ? message("There is no such file; check its name.")
                               : message("The file cannot be opened (%1); check its permissions.",
                                         std::string(std::strerror(errno))),
                           path);
  struct stat info {};
  const bool known = ::fstat(fd, &info) == 0;
  InputFile file(fd, static_cast<std::size_t>(std::max<off_t>(0, info.st_size)), path);
  // Again, of what was opened: another may have taken the name meanwhile.
  if (!known || !S_ISREG(info.st_mode)) return Error::unusable(kindOf(info.st_mode), path);
  return file;
}

InputFile::InputFile(int fd, std::size_t size_bytes, std::filesystem::path path)
    : fd_(fd), size_bytes_(size_bytes), path_(std::move(path)) {}

InputFile::InputFile(InputFile&& other) noexcept
    : fd_(std::exchange(other.fd_, -1)),
      size_bytes_(other.size_bytes_),
      path_(std::move(other.path_)) {}

InputFile::~InputFile() {
  if (fd_ >= 0) ::close(fd_);
}

Result<std::string> InputFile::read(std::size_t most_bytes) {
  std::string bytes(most_bytes, '\0');
  std::size_t done = 0;
  while (done < most_bytes) {
    const ssize_t n = ::read(fd_, bytes.data() + done, most_bytes - done);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0)
      return Error::unusable(message("The file cannot be read (%1); copy it again.",
                                     std::string(std::strerror(errno))),
                             path_);
    if (n == 0) break;
    done += static_cast<std::size_t>(n);
  }
  bytes.resize(done);
  return bytes;
}

}  // namespace ostraka
