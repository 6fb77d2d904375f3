#pragma once
#include <algorithm>
#include <mutex>

#include "devices/clock.h"

namespace ostraka::capture::testing {

/// Time that passes only when somebody waits.
class SimulatedClock final : public devices::Clock {
 public:
  double now_s() override {
    const std::lock_guard lock(guard_);
    return now_s_;
  }
  bool sleep(double seconds, std::stop_token stop) override {
    const std::lock_guard lock(guard_);
    now_s_ += std::max(0.0, seconds);
    return !stop.stop_requested();
  }

 private:
  std::mutex guard_;
  double now_s_ = 0;
};

}  // namespace ostraka::capture::testing
