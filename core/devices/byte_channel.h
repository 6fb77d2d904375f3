#pragma once
#include <memory>
#include <stop_token>
#include <string>
#include <string_view>

#include "base/result.h"

namespace ostraka::devices {

/// A line to a controller: USB, a serial port or TCP. Errors name it; Missing means that it is
/// gone.
class ByteChannel {
 public:
  virtual ~ByteChannel() = default;
  virtual std::string name() const = 0;
  virtual Result<void> write(std::string_view bytes) = 0;
  /// What has come so far, at least one byte; empty after timeout_s or when a stop was requested.
  virtual Result<std::string> read(double timeout_s, std::stop_token stop) = 0;
  /// Opens the same device again, wherever it is plugged in now; waits up to 2 s for it.
  virtual Result<void> reopen(std::stop_token stop) = 0;
  virtual void close() = 0;
};

/// A serial port, raw, 8N1, no hang-up at the end, for us alone. path: best /dev/serial/by-id/...
/// Errors: Missing (not there, no permission, held by another program), UnusableInput (baud).
Result<std::unique_ptr<ByteChannel>> openSerial(const std::string& path, int baud);

/// A controller in the network, "host:port".
Result<std::unique_ptr<ByteChannel>> openTcp(const std::string& host_and_port);

/// A CDC-ACM device by libusb, "1209:0001" or "1209:0001:serial". The kernel's driver is detached
/// and given back.
Result<std::unique_ptr<ByteChannel>> openUsb(const std::string& vendor_and_product, int baud);

/// "usb:1209:0001", "tcp:host:port", or the path of a serial port.
Result<std::unique_ptr<ByteChannel>> openChannel(const std::string& name, int baud);

}  // namespace ostraka::devices
