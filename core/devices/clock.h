#pragma once
#include <memory>
#include <stop_token>

#include "base/result.h"

namespace ostraka::devices {

/// Time as the drivers and the sequence see it. Handed in, so that tests of a thousand stops with
/// time-outs take seconds.
class Clock {
 public:
  virtual ~Clock() = default;
  virtual double now_s() = 0;  ///< never goes back; its zero means nothing
  /// Waits; false when a stop was requested first.
  virtual bool sleep(double seconds, std::stop_token stop) = 0;
};

/// The computer's steady clock; a request to stop ends a sleep at once.
std::shared_ptr<Clock> steadyClock();

/// Calls open every pause_s until it succeeds, for the given time; then with its last error.
/// Errors: those of open; Cancelled.
template <typename Open>
Result<void> openWithin(double seconds, double pause_s, Clock& clock, std::stop_token stop,
                        Open&& open) {
  const double deadline_s = clock.now_s() + seconds;
  while (true) {
    const Result<void> opened = open();
    if (opened || clock.now_s() >= deadline_s) return opened;
    if (!clock.sleep(pause_s, stop)) return Error::cancelled();
  }
}

}  // namespace ostraka::devices
