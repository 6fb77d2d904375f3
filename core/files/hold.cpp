#include "files/hold.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <thread>

namespace ostraka {

std::optional<Hold> Hold::take(const std::filesystem::path& path) {
  FileDescriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (!file.isOpen() || ::flock(file.get(), LOCK_EX | LOCK_NB) != 0) return std::nullopt;
  return Hold(std::move(file));
}

std::optional<Hold> Hold::wait(const std::filesystem::path& path, std::chrono::milliseconds most) {
  const auto end = std::chrono::steady_clock::now() + most;
  for (;;) {
    std::optional<Hold> hold = take(path);
    if (hold || std::chrono::steady_clock::now() >= end) return hold;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}

}  // namespace ostraka
