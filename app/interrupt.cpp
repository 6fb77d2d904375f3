#include "interrupt.h"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <atomic>
#include <cstdio>
#include <system_error>
#include <utility>

namespace ostraka::app {
namespace {

// A signal handler has no argument to carry this: the one place of the program with a global.
std::atomic<int> wake_write{-1};

void onSignal(int) {
  const char byte = 's';
  const int fd = wake_write.load();
  if (fd >= 0) [[maybe_unused]]
    const auto written = ::write(fd, &byte, 1);
}

}  // namespace

Interrupt::Interrupt() {
  int ends[2] = {-1, -1};
  if (::pipe2(ends, O_CLOEXEC) != 0) return;  // without it a signal simply ends the program
  wake_read_ = ends[0];
  wake_write = ends[1];
  try {
    listener_ = std::jthread([this] {
      char byte = 0;
      while (::read(wake_read_, &byte, 1) == 1 && byte == 's') {
        if (source_.stop_requested()) ::_exit(1);
        std::fputs("\nostraka: stopping; press Ctrl-C again to end immediately.\n", stderr);
        source_.request_stop();
      }
    });
  } catch (const std::system_error&) {  // no thread is free: the same
    ::close(wake_write.exchange(-1));
    ::close(std::exchange(wake_read_, -1));
    return;
  }
  struct sigaction action {};
  action.sa_handler = onSignal;
  action.sa_flags = SA_RESTART;
  ::sigaction(SIGINT, &action, nullptr);
  ::sigaction(SIGTERM, &action, nullptr);
}

Interrupt::~Interrupt() {
  if (wake_read_ < 0) return;
  ::signal(SIGINT, SIG_DFL);
  ::signal(SIGTERM, SIG_DFL);
  const int fd = wake_write.exchange(-1);
  const char byte = 'q';
  [[maybe_unused]] const auto written = ::write(fd, &byte, 1);
  listener_.join();
  ::close(fd);
  ::close(wake_read_);
}

}  // namespace ostraka::app
