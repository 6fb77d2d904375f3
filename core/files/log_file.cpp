#include "files/log_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <string>

namespace ostraka {
namespace {

int openedForAppending(const std::filesystem::path& path) {
  const auto opened = [&path] {
    return ::open(path.c_str(),
                  O_WRONLY | O_CREAT | O_APPEND | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC,
                  0666);
  };
  int fd = opened();
  if (fd < 0 && errno == ELOOP && ::unlink(path.c_str()) == 0) fd = opened();
  struct stat info {};
  if (fd >= 0 && ::fstat(fd, &info) == 0 && S_ISREG(info.st_mode)) return fd;
  if (fd >= 0) ::close(fd);
  return -1;
}

}  // namespace

LogFile::LogFile(const std::filesystem::path& path) : fd_(openedForAppending(path)) {}

LogFile::~LogFile() {
  if (fd_ >= 0) ::close(fd_);
}

void LogFile::line(std::string_view text) {
  if (fd_ < 0) return;
  const std::string whole = std::string(text) + "\n";
  // A log that cannot be written does not stop the work that it tells of.
  [[maybe_unused]] const ssize_t ignored = ::write(fd_, whole.data(), whole.size());
}

}  // namespace ostraka
