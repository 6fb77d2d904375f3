#pragma once
#include <atomic>
#include <mutex>
#include <thread>

#include "base/progress.h"
#include "base/result.h"

namespace ostraka::virtualrig {

/// First error of photographs that are written in parallel, and progress from the thread that made
/// it.
class ShotReport {
 public:
  ShotReport(Progress& progress, std::int64_t total) : progress_(progress), total_(total) {
    progress_.report(0, total_);  // the first takes long
  }
  void done(const Result<void>& result) {
    if (!result) {
      const std::lock_guard lock(guard_);
      if (error_.what.empty()) error_ = result.error();
    }
    const std::int64_t now = ++done_;
    if (std::this_thread::get_id() == owner_) progress_.report(now, total_);
  }
  bool failed() const {
    const std::lock_guard lock(guard_);
    return !error_.what.empty();
  }
  Result<void> result() const { return failed() ? Result<void>(error_) : Result<void>(); }

 private:
  Progress& progress_;
  std::int64_t total_;
  std::atomic<std::int64_t> done_{0};
  std::thread::id owner_ = std::this_thread::get_id();
  mutable std::mutex guard_;
  Error error_;
};

}  // namespace ostraka::virtualrig
