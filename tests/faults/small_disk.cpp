// Loaded before the C library (LD_PRELOAD) it makes the disk fill: below OSTRAKA_SMALL_DISK so many
// writes succeed as OSTRAKA_SMALL_DISK_WRITES says, and from then on nothing is written or made;
// with OSTRAKA_SMALL_DISK_KILLS the process is killed there instead. Where OSTRAKA_SMALL_DISK_COUNT
// names a file, it says in the end how many there were.
#include <dlfcn.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/sendfile.h>
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
  if (std::getenv("OSTRAKA_SMALL_DISK_KILLS") != nullptr) ::kill(::getpid(), SIGKILL);
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

// Of the third argument, which is there only where a file is made.
mode_t modeOf(int flags, va_list rest) {
  return makes(flags) ? va_arg(rest, mode_t) : 0;
}

// The C library writes its streams without asking anybody: they count when they are filled.
bool hasRoom(std::FILE* stream) {
  return hasRoom(::fileno(stream));
}

__attribute__((destructor)) void tellCount() {
  const char* file = std::getenv("OSTRAKA_SMALL_DISK_COUNT");
  std::FILE* out = file == nullptr || *file == 0 ? nullptr : std::fopen(file, "w");
  if (out == nullptr) return;
  std::fprintf(out, "%ld", used.load());
  std::fclose(out);
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

ssize_t pwrite64(int fd, const void* bytes, size_t size, off64_t at) {
  static auto* const next = following<ssize_t(int, const void*, size_t, off64_t)>("pwrite64");
  return hasRoom(fd) ? next(fd, bytes, size, at) : -1;
}

ssize_t pwrite(int fd, const void* bytes, size_t size, off_t at) {
  return pwrite64(fd, bytes, size, at);
}

ssize_t copy_file_range(int from, off64_t* from_at, int to, off64_t* to_at, size_t size,
                        unsigned flags) {
  static auto* const next =
      following<ssize_t(int, off64_t*, int, off64_t*, size_t, unsigned)>("copy_file_range");
  return hasRoom(to) ? next(from, from_at, to, to_at, size, flags) : -1;
}

ssize_t sendfile64(int to, int from, off64_t* at, size_t size) {
  static auto* const next = following<ssize_t(int, int, off64_t*, size_t)>("sendfile64");
  return hasRoom(to) ? next(to, from, at, size) : -1;
}

ssize_t sendfile(int to, int from, off_t* at, size_t size) {
  return sendfile64(to, from, at, size);
}

int mkdir(const char* path, mode_t mode) {
  static auto* const next = following<int(const char*, mode_t)>("mkdir");
  struct stat there {};
  const bool known = ::stat(path, &there) == 0;  // then the disk is not asked for anything
  return known || hasRoom(path) ? next(path, mode) : -1;
}

int mkdirat(int folder, const char* name, mode_t mode) {
  static auto* const next = following<int(int, const char*, mode_t)>("mkdirat");
  struct stat there {};
  const bool known = ::fstatat(folder, name, &there, 0) == 0;
  return known || hasRoom(folder) ? next(folder, name, mode) : -1;
}

int open(const char* path, int flags, ...) {
  static auto* const next = following<int(const char*, int, ...)>("open");
  va_list rest;
  va_start(rest, flags);
  const mode_t mode = modeOf(flags, rest);
  va_end(rest);
  struct stat there {};
  if (makes(flags) && ::stat(path, &there) != 0 && !hasRoom(path)) return -1;
  return next(path, flags, mode);
}

int open64(const char* path, int flags, ...) __attribute__((alias("open")));

FILE* fopen64(const char* path, const char* mode) {
  static auto* const next = following<FILE*(const char*, const char*)>("fopen64");
  struct stat there {};
  if (mode[0] != 'r' && ::stat(path, &there) != 0 && !hasRoom(path)) return nullptr;
  return next(path, mode);
}

FILE* fopen(const char* path, const char* mode) {
  return fopen64(path, mode);
}

size_t fwrite(const void* bytes, size_t size, size_t count, FILE* stream) {
  static auto* const next = following<size_t(const void*, size_t, size_t, FILE*)>("fwrite");
  return hasRoom(stream) ? next(bytes, size, count, stream) : 0;
}

int symlink(const char* target, const char* path) {
  static auto* const next = following<int(const char*, const char*)>("symlink");
  return hasRoom(path) ? next(target, path) : -1;
}

int link(const char* from, const char* to) {
  static auto* const next = following<int(const char*, const char*)>("link");
  return hasRoom(to) ? next(from, to) : -1;
}

int openat(int folder, const char* name, int flags, ...) {
  static auto* const next = following<int(int, const char*, int, ...)>("openat");
  va_list rest;
  va_start(rest, flags);
  const mode_t mode = modeOf(flags, rest);
  va_end(rest);
  struct stat there {};
  const bool fresh = makes(flags) && ::fstatat(folder, name, &there, 0) != 0;
  if (fresh && !(name[0] == '/' ? hasRoom(name) : hasRoom(folder))) return -1;
  return next(folder, name, flags, mode);
}

int openat64(int folder, const char* name, int flags, ...) __attribute__((alias("openat")));

}  // extern "C"
