#pragma once
#include <mutex>

#include "base/result.h"
#include "base/shared_progress.h"

namespace ostraka::virtualrig {

/// First error of photographs that are written in parallel, and progress from the thread that made
/// it.
class ShotReport {
 public:
  ShotReport(Progress& progress, std::int64_t total) : written_(progress, total) {
    progress.report(0, total);  // the first takes long
  }
  void done(const Result<void>& result) {
    if (!result) {
      const std::lock_guard lock(guard_);
      if (error_.what.empty()) error_ = result.error();
    }
    written_.count();
  }
  bool failed() const {
    const std::lock_guard lock(guard_);
    return !error_.what.empty();
  }
  Result<void> result() const { return failed() ? Result<void>(error_) : Result<void>(); }

 private:
  SharedProgress written_;
  mutable std::mutex guard_;
  Error error_;
};

}  // namespace ostraka::virtualrig
