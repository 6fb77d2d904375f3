#pragma once
#include <stop_token>
#include <thread>

namespace ostraka::app {

/// Turns SIGINT and SIGTERM into a request to stop while it lives. The second signal ends the
/// program at once, which is safe as well: files are written whole or not at all. One at a time.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;
  std::stop_token token() const { return source_.get_token(); }

 private:
  std::stop_source source_;
  int wake_read_ = -1;
  std::jthread listener_;
};

}  // namespace ostraka::app
