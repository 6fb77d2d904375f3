#include "devices/clock.h"

#include <chrono>
#include <condition_variable>
#include <mutex>

namespace ostraka::devices {
namespace {

class SteadyClock final : public Clock {
 public:
  double now_s() override {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
  }
  bool sleep(double seconds, std::stop_token stop) override {
    std::mutex mutex;
    std::condition_variable_any never;
    std::unique_lock lock(mutex);
    never.wait_for(lock, stop, std::chrono::duration<double>(seconds), [] { return false; });
    return !stop.stop_requested();
  }
};

}  // namespace

std::shared_ptr<Clock> steadyClock() {
  return std::make_shared<SteadyClock>();
}

}  // namespace ostraka::devices
