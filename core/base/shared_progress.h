#pragma once
#include <atomic>
#include <cstdint>
#include <thread>

#include "base/progress.h"

namespace ostraka {

/// What the threads of a loop have done together. Any of them counts; the one that made this, which
/// parallelFor makes work as well, reports.
class SharedProgress {
 public:
  SharedProgress(Progress& progress, std::int64_t total) : progress_(progress), total_(total) {}
  void count(std::int64_t steps = 1) {
    const std::int64_t done = done_ += steps;
    if (std::this_thread::get_id() == owner_) progress_.report(done, total_);
  }

 private:
  Progress& progress_;
  std::int64_t total_;
  std::atomic<std::int64_t> done_{0};
  std::thread::id owner_ = std::this_thread::get_id();
};

}  // namespace ostraka
