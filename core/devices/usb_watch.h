#pragma once
#include <functional>
#include <memory>

#include "base/result.h"

namespace ostraka::devices {

struct UsbWatchOptions {
  enum class How { Events, Polling };
  How how = How::Events;    ///< where the system has none, it is polled all the same
  double poll_s = 1.0;      ///< between two looks
  double settled_s = 0.15;  ///< a device comes with several events; told once they are over
};

/// Notices that something was plugged in or pulled out at USB, until it is destroyed.
class UsbWatch {
 public:
  virtual ~UsbWatch() = default;
  virtual UsbWatchOptions::How how() const = 0;  ///< what it came down to
};

/// changed: called from a thread of the watch, one call at a time, and never once the watch is
/// gone. It opens no device. Errors: Missing (no USB on this computer).
Result<std::unique_ptr<UsbWatch>> watchUsb(std::function<void()> changed,
                                           const UsbWatchOptions& options);

}  // namespace ostraka::devices
