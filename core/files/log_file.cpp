#include "files/log_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <string>

namespace ostraka {
namespace {

FileDescriptor openedForAppending(const std::filesystem::path& path) {
  const auto opened = [&path] {
    return FileDescriptor(::open(
        path.c_str(),
        O_WRONLY | O_CREAT | O_APPEND | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC, 0666));
  };
  FileDescriptor file = opened();
  if (!file.isOpen() && errno == ELOOP && ::unlink(path.c_str()) == 0) file = opened();
  struct stat info {};
  return ::fstat(file.get(), &info) == 0 && S_ISREG(info.st_mode) ? std::move(file)
                                                                  : FileDescriptor();
}

}  // namespace

LogFile::LogFile(const std::filesystem::path& path) : file_(openedForAppending(path)) {}

void LogFile::line(std::string_view text) {
  if (!file_.isOpen()) return;
  const std::string whole = std::string(text) + "\n";
  // A log that cannot be written does not stop the work that it tells of.
  [[maybe_unused]] const ssize_t ignored = ::write(file_.get(), whole.data(), whole.size());
}

}  // namespace ostraka
