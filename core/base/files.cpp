#include "base/files.h"

#include <fcntl.h>
#include <openssl/sha.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <system_error>

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

std::string reason() {
  return std::strerror(errno);
}

Error cannotWrite(const std::filesystem::path& path) {
  const std::string hint =
      errno == ENOSPC ? "The disk is full; free some space and start the same command again."
                      : "This cannot be written (" + reason() +
                            "); choose another place, or check its permissions.";
  return {ErrorCode::CannotWrite, hint, path.string()};
}

bool writeAll(int fd, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t n = ::write(fd, bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(n));
  }
  return true;
}

}  // namespace

Result<std::string> readFile(const std::filesystem::path& path, std::size_t max_bytes) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (!file.open())
    return Error{ErrorCode::UnusableInput,
                 errno == ENOENT
                     ? "There is no such file; check its name."
                     : "The file cannot be opened (" + reason() + "); check its permissions.",
                 path};
  struct stat info {};
  if (::fstat(file.get(), &info) != 0 || !S_ISREG(info.st_mode))
    return Error{ErrorCode::UnusableInput, "This is not a regular file; name a file.", path};
  const auto size = static_cast<std::size_t>(info.st_size);
  if (size > max_bytes)
    return Error{ErrorCode::UnusableInput,
                 "The file is larger than the " + std::to_string(max_bytes) +
                     " bytes that are read here; is it the right one?",
                 path};
  std::string bytes(size, '\0');
  std::size_t done = 0;
  while (done < size) {
    const ssize_t n = ::read(file.get(), bytes.data() + done, size - done);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0)
      return Error{ErrorCode::UnusableInput,
                   "The file cannot be read (" + reason() + "); copy it again.", path};
    if (n == 0) break;
    done += static_cast<std::size_t>(n);
  }
  bytes.resize(done);
  return bytes;
}

Result<void> writeFileAtomically(const std::filesystem::path& path, std::string_view bytes) {
  const std::filesystem::path folder =
      path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (failed) {
    errno = failed.value();
    return cannotWrite(folder);
  }
  const std::filesystem::path partial = path.string() + ".partial";
  {
    const Descriptor file(::open(partial.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644));
    if (!file.open()) return cannotWrite(path);
    if (!writeAll(file.get(), bytes) || ::fsync(file.get()) != 0) {
      const Error error = cannotWrite(path);
      ::unlink(partial.c_str());
      return error;
    }
  }
  if (::rename(partial.c_str(), path.c_str()) != 0) {
    const Error error = cannotWrite(path);
    ::unlink(partial.c_str());
    return error;
  }
  syncFolder(folder);
  return {};
}

void syncFolder(const std::filesystem::path& folder) {
  const Descriptor opened(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (opened.open()) ::fsync(opened.get());
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

}  // namespace ostraka
