#include "files/unfinished_file.h"

#include <dirent.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <memory>
#include <string_view>

namespace ostraka {
namespace {

// A file is written under the name .NAME.<12 hexadecimal digits>.partial in its folder, which
// nobody can guess and prepare, and its writer holds a lock on it. One that nobody holds was left
// by a program that was killed.
constexpr std::size_t kDigits = 12;
constexpr std::string_view kEnding = ".partial";
constexpr const char* kHex = "0123456789abcdef";

std::string partialStart(const std::string& name) {
  constexpr std::size_t kMostLetters = 200;  // a name has at most 255
  return "." + name.substr(0, kMostLetters) + ".";
}

std::string partialName(const std::string& start) {
  std::array<unsigned char, kDigits> random{};
  if (::getrandom(random.data(), random.size(), 0) != static_cast<ssize_t>(random.size()))
    return {};
  std::string name = start;
  for (const unsigned char byte : random) name += kHex[byte & 15];
  return name + std::string(kEnding);
}

bool isPartial(std::string_view name, const std::string& start) {
  return name.size() == start.size() + kDigits + kEnding.size() && name.starts_with(start) &&
         name.ends_with(kEnding) &&
         name.substr(start.size(), kDigits).find_first_not_of(kHex) == std::string_view::npos;
}

void removeAbandonedPartials(int folder, const std::string& start) {
  const int listed = ::openat(folder, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (listed < 0) return;
  const std::unique_ptr<DIR, int (*)(DIR*)> entries(::fdopendir(listed), ::closedir);
  while (const dirent* entry = entries ? ::readdir(entries.get()) : nullptr) {
    if (!isPartial(entry->d_name, start)) continue;
    const FileDescriptor file(
        ::openat(folder, entry->d_name, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
    struct stat info {};
    if (file.isOpen() && ::fstat(file.get(), &info) == 0 && S_ISREG(info.st_mode) &&
        ::flock(file.get(), LOCK_EX | LOCK_NB) == 0)
      ::unlinkat(folder, entry->d_name, 0);
  }
}

}  // namespace

// Locked, and still under its name: another write may have taken it for abandoned in between.
UnfinishedFile beginFile(int folder, const std::string& of, mode_t mode) {
  const std::string start = partialStart(of);
  removeAbandonedPartials(folder, start);
  for (int attempt = 0; attempt < 100; ++attempt) {
    const std::string name = partialName(start);
    if (name.empty()) break;
    FileDescriptor file(
        ::openat(folder, name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, mode));
    if (!file.isOpen() && errno == EEXIST) continue;
    if (!file.isOpen()) break;
    struct stat info {};
    const bool taken = ::flock(file.get(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
    if (!taken && ::fstat(file.get(), &info) == 0 && info.st_nlink > 0)
      return {std::move(file), name};
    errno = EAGAIN;
  }
  return {};
}

bool writeAll(int fd, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t n = ::write(fd, bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR) continue;
    if (n == 0) errno = ENOSPC;
    if (n <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(n));
  }
  return true;
}

}  // namespace ostraka
