#pragma once
#include <memory>
#include <stop_token>

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

}  // namespace ostraka::devices
