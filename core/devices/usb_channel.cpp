#include <libusb-1.0/libusb.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <optional>
#include <vector>

#include "base/message.h"
#include "devices/byte_channel.h"
#include "devices/clock.h"

namespace ostraka::devices {
namespace {

constexpr double kUsbReopen_s = 2;           // a device needs a moment after it was plugged in
constexpr unsigned kWrite_ms = 1000;         // for one short line
constexpr unsigned kSlice_ms = 50;           // libusb is asked in slices: a stop is noticed
constexpr std::uint8_t kToInterface = 0x21;  // class request, host to interface
constexpr std::uint8_t kSetLineCoding = 0x20, kSetControlLines = 0x22;
constexpr std::uint16_t kDtrAndRts = 3;

struct Wanted {
  std::uint16_t vendor = 0, product = 0;
  std::string serial;  // empty: any
};

std::optional<Wanted> parsed(const std::string& text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos) return std::nullopt;
  const std::size_t second = text.find(':', colon + 1);
  const auto hex = [](const std::string& part) -> std::optional<std::uint16_t> {
    char* end = nullptr;
    const unsigned long value = std::strtoul(part.c_str(), &end, 16);
    if (part.empty() || *end != '\0' || value > 0xFFFF) return std::nullopt;
    return static_cast<std::uint16_t>(value);
  };
  const auto vendor = hex(text.substr(0, colon)),
             product = hex(text.substr(colon + 1, second - colon - 1));
  if (!vendor || !product) return std::nullopt;
  return Wanted{*vendor, *product, second == std::string::npos ? "" : text.substr(second + 1)};
}

// The interfaces and endpoints of a CDC-ACM device, from its descriptors.
struct Layout {
  int control_interface = -1, bulk_interface = -1;
  std::uint8_t in = 0, out = 0;
  int packet = 64;
};

std::optional<Layout> layoutOf(libusb_device* device) {
  libusb_config_descriptor* config = nullptr;
  if (libusb_get_active_config_descriptor(device, &config) != 0) return std::nullopt;
  Layout layout;
  for (int i = 0; i < config->bNumInterfaces; ++i) {
    if (config->interface[i].num_altsetting < 1) continue;
    const libusb_interface_descriptor& face = config->interface[i].altsetting[0];
    if (face.bInterfaceClass == LIBUSB_CLASS_COMM && face.bInterfaceSubClass == 2)
      layout.control_interface = face.bInterfaceNumber;
    if (face.bInterfaceClass != LIBUSB_CLASS_DATA) continue;
    layout.bulk_interface = face.bInterfaceNumber;
    for (int e = 0; e < face.bNumEndpoints; ++e) {
      const libusb_endpoint_descriptor& end = face.endpoint[e];
      if ((end.bmAttributes & 3) != LIBUSB_TRANSFER_TYPE_BULK) continue;
      if ((end.bEndpointAddress & LIBUSB_ENDPOINT_IN) != 0) {
        layout.in = end.bEndpointAddress;
        layout.packet = std::max<int>(end.wMaxPacketSize, 8);
      } else {
        layout.out = end.bEndpointAddress;
      }
    }
  }
  libusb_free_config_descriptor(config);
  if (layout.control_interface < 0 || layout.bulk_interface < 0 || layout.in == 0 ||
      layout.out == 0)
    return std::nullopt;
  return layout;
}

std::string serialOf(libusb_device_handle* handle, std::uint8_t index) {
  if (index == 0) return {};
  std::array<unsigned char, 256> text{};
  const int n =
      libusb_get_string_descriptor_ascii(handle, index, text.data(), static_cast<int>(text.size()));
  return n > 0 ? std::string(reinterpret_cast<char*>(text.data()), static_cast<std::size_t>(n))
               : std::string();
}

class UsbChannel final : public ByteChannel {
 public:
  UsbChannel(std::string name, Wanted wanted, int baud)
      : name_(std::move(name)), wanted_(std::move(wanted)), baud_(baud) {}
  ~UsbChannel() override {
    close();
    if (context_ != nullptr) libusb_exit(context_);
  }
  UsbChannel(const UsbChannel&) = delete;
  UsbChannel& operator=(const UsbChannel&) = delete;

  Result<void> open() {
    if (context_ == nullptr && libusb_init(&context_) != 0) {
      context_ = nullptr;
      return gone(message("USB does not work on this computer."));
    }
    libusb_device** list = nullptr;
    const ssize_t count = libusb_get_device_list(context_, &list);
    Result<void> result = gone(message("The turntable is not plugged in."));
    for (ssize_t i = 0; i < count; ++i) {
      libusb_device_descriptor about{};
      if (libusb_get_device_descriptor(list[i], &about) != 0) continue;
      if (about.idVendor != wanted_.vendor || about.idProduct != wanted_.product) continue;
      result = openDevice(list[i], about);
      if (result) break;
    }
    if (count >= 0) libusb_free_device_list(list, 1);
    return result;
  }

  std::string name() const override { return name_; }

  Result<void> write(std::string_view bytes) override {
    if (handle_ == nullptr) return gone(message("The turntable is not plugged in."));
    std::vector<unsigned char> rest(bytes.begin(), bytes.end());
    while (!rest.empty()) {
      int sent = 0;
      const int rc = libusb_bulk_transfer(handle_, layout_.out, rest.data(),
                                          static_cast<int>(rest.size()), &sent, kWrite_ms);
      if (sent > 0) rest.erase(rest.begin(), rest.begin() + sent);
      if (rc == LIBUSB_ERROR_INTERRUPTED) continue;
      if (rc != 0) return failed(rc);
    }
    return {};
  }

  Result<std::string> read(double timeout_s, std::stop_token stop) override {
    const double deadline_s = clock_->now_s() + timeout_s;
    std::vector<unsigned char> buffer(static_cast<std::size_t>(8 * layout_.packet));
    while (true) {
      if (handle_ == nullptr) return gone(message("The turntable is not plugged in."));
      const double left_ms = 1000 * (deadline_s - clock_->now_s());
      int got = 0;
      const int rc = libusb_bulk_transfer(
          handle_, layout_.in, buffer.data(), static_cast<int>(buffer.size()), &got,
          static_cast<unsigned>(std::clamp(left_ms, 1.0, static_cast<double>(kSlice_ms))));
      if (got > 0) return std::string(buffer.begin(), buffer.begin() + got);
      if (rc != 0 && rc != LIBUSB_ERROR_TIMEOUT && rc != LIBUSB_ERROR_INTERRUPTED)
        return failed(rc);
      if (stop.stop_requested() || clock_->now_s() >= deadline_s) return std::string();
    }
  }

  Result<void> reopen(std::stop_token stop) override {
    close();
    return openWithin(kUsbReopen_s, 0.1, *clock_, stop, [this] { return open(); });
  }

  // Giving the interfaces back gives them to the kernel's driver again.
  void close() override {
    if (handle_ == nullptr) return;
    libusb_release_interface(handle_, layout_.bulk_interface);
    libusb_release_interface(handle_, layout_.control_interface);
    libusb_close(handle_);
    handle_ = nullptr;
  }

 private:
  Error gone(const Message& what) const { return Error::missing(what, name_); }

  Error failed(int rc) {
    if (rc == LIBUSB_ERROR_NO_DEVICE) {
      close();
      return gone(message("The turntable is not plugged in."));
    }
    if (rc == LIBUSB_ERROR_PIPE) {
      libusb_clear_halt(handle_, layout_.in);
      libusb_clear_halt(handle_, layout_.out);
    }
    return gone(message("The turntable's USB connection failed (%1); plug it in again.",
                        libusb_error_name(rc)));
  }

  Error cannotOpen(int rc) const {
    if (rc == LIBUSB_ERROR_ACCESS)
      return gone(message(
          "You have no permission to use this USB device; install packaging/udev/70-ostraka.rules "
          "and plug it in again."));
    if (rc == LIBUSB_ERROR_BUSY)
      return gone(message("Another program uses the turntable; close that program."));
    return gone(message("The turntable cannot be opened (%1).", libusb_error_name(rc)));
  }

  Result<void> openDevice(libusb_device* device, const libusb_device_descriptor& about) {
    const std::optional<Layout> layout = layoutOf(device);
    if (!layout) return gone(message("This USB device is not a serial controller (CDC-ACM)."));
    libusb_device_handle* handle = nullptr;
    if (const int rc = libusb_open(device, &handle); rc != 0) return cannotOpen(rc);
    if (!wanted_.serial.empty() && serialOf(handle, about.iSerialNumber) != wanted_.serial) {
      libusb_close(handle);
      return gone(message("The turntable with this serial number is not plugged in."));
    }
    libusb_set_auto_detach_kernel_driver(handle, 1);
    int rc = libusb_claim_interface(handle, layout->control_interface);
    if (rc == 0) {
      rc = libusb_claim_interface(handle, layout->bulk_interface);
      if (rc != 0) libusb_release_interface(handle, layout->control_interface);
    }
    if (rc != 0) {
      libusb_close(handle);
      return cannotOpen(rc);
    }
    handle_ = handle;
    layout_ = *layout;
    return setLine();
  }

  // Speed, 8 data bits, no parity, 1 stop bit; ready to talk.
  Result<void> setLine() {
    const auto rate = static_cast<std::uint32_t>(baud_);
    std::array<unsigned char, 7> coding{static_cast<unsigned char>(rate),
                                        static_cast<unsigned char>(rate >> 8),
                                        static_cast<unsigned char>(rate >> 16),
                                        static_cast<unsigned char>(rate >> 24),
                                        0,
                                        0,
                                        8};
    const auto face = static_cast<std::uint16_t>(layout_.control_interface);
    int rc = libusb_control_transfer(handle_, kToInterface, kSetLineCoding, 0, face, coding.data(),
                                     static_cast<std::uint16_t>(coding.size()), kWrite_ms);
    if (rc >= 0 || rc == LIBUSB_ERROR_PIPE)  // some controllers know no line coding
      rc = libusb_control_transfer(handle_, kToInterface, kSetControlLines, kDtrAndRts, face,
                                   nullptr, 0, kWrite_ms);
    if (rc >= 0 || rc == LIBUSB_ERROR_PIPE) return {};
    const Error error = failed(rc);
    close();
    return error;
  }

  std::string name_;
  Wanted wanted_;
  int baud_;
  libusb_context* context_ = nullptr;
  libusb_device_handle* handle_ = nullptr;
  Layout layout_;
  std::shared_ptr<Clock> clock_ = steadyClock();
};

}  // namespace

Result<std::unique_ptr<ByteChannel>> openUsb(const std::string& vendor_and_product, int baud) {
  const std::optional<Wanted> wanted = parsed(vendor_and_product);
  if (!wanted)
    return Error::unusable(
        message("A USB turntable is named by vendor and product, for example usb:1209:0001."),
        vendor_and_product);
  auto channel = std::make_unique<UsbChannel>("usb:" + vendor_and_product, *wanted, baud);
  if (const Result<void> opened = channel->open(); !opened) return opened.error();
  return std::unique_ptr<ByteChannel>(std::move(channel));
}

}  // namespace ostraka::devices
