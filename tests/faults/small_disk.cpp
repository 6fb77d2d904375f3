// Loaded before the C library (LD_PRELOAD) it makes the disk fill: below OSTRAKA_SMALL_DISK so many
// writes succeed as OSTRAKA_SMALL_DISK_WRITES says, and from then on nothing is written or made.
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/types.h>
#include <sys/uio.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

std::atomic<long> used{0};

// Of the writes that the disk takes this is one. Errors otherwise.
bool hasRoom(const char* path) {
  const char* disk = std::getenv("OSTRAKA_SMALL_DISK");
  const char* writes = std::getenv("OSTRAKA_SMALL_DISK_WRITES");
  if (disk == nullptr || writes == nullptr || std::strncmp(path, disk, std::strlen(disk)) != 0)
    return true;
  if (used++ < std::atol(writes)) return true;
  errno = ENOSPC;
  return false;
}

bool hasRoom(int fd) {
  char link[64], path[4096];
  std::snprintf(link, sizeof link, "/proc/self/fd/%d", fd);
  const ssize_t length = ::readlink(link, path, sizeof path - 1);
  if (length <= 0) return true;
  path[length] = 0;
  return hasRoom(path);
}

template <class Function>
Function* following(const char* name) {
  return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

bool makes(int flags) {
  return (flags & O_CREAT) != 0;
}

}  // namespace

extern "C" {

ssize_t write(int fd, const void* bytes, size_t size) {
  static auto* const next = following<ssize_t(int, const void*, size_t)>("write");
  return hasRoom(fd) ? next(fd, bytes, size) : -1;
}

ssize_t writev(int fd, const iovec* parts, int count) {
  static auto* const next = following<ssize_t(int, const iovec*, int)>("writev");
  return hasRoom(fd) ? next(fd, parts, count) : -1;
}

int mkdir(const char* path, mode_t mode) {
  static auto* const next = following<int(const char*, mode_t)>("mkdir");
  struct stat there {};
  const bool known = ::stat(path, &there) == 0;  // then the disk is not asked for anything
  return known || hasRoom(path) ? next(path, mode) : -1;
}

int open(const char* path, int flags, ...) {
  static auto* const next = following<int(const char*, int, ...)>("open");
  mode_t mode = 0;
  if (makes(flags)) {
    va_list rest;
    va_start(rest, flags);
    mode = va_arg(rest, mode_t);
    va_end(rest);
  }
  struct stat there {};
  if (makes(flags) && ::stat(path, &there) != 0 && !hasRoom(path)) return -1;
  return next(path, flags, mode);
}

int open64(const char* path, int flags, ...) {
  mode_t mode = 0;
  if (makes(flags)) {
    va_list rest;
    va_start(rest, flags);
    mode = va_arg(rest, mode_t);
    va_end(rest);
  }
  return open(path, flags, mode);
}

}  // extern "C"
