#include "devices/usb_watch.h"

#include <libusb-1.0/libusb.h>

#include <atomic>
#include <thread>
#include <tuple>
#include <vector>

#include "base/message.h"
#include "devices/clock.h"

namespace ostraka::devices {
namespace {

using How = UsbWatchOptions::How;
using Place = std::tuple<int, int, int, int>;  // bus, address, vendor, product

class LibusbWatch final : public UsbWatch {
 public:
  LibusbWatch(libusb_context* context, std::function<void()> changed,
              const UsbWatchOptions& options)
      : context_(context), changed_(std::move(changed)), options_(options) {
    if (options.how == How::Events && libusb_has_capability(LIBUSB_CAP_HAS_HOTPLUG) != 0)
      registered_ =
          libusb_hotplug_register_callback(
              context_, LIBUSB_HOTPLUG_EVENT_DEVICE_ARRIVED | LIBUSB_HOTPLUG_EVENT_DEVICE_LEFT,
              LIBUSB_HOTPLUG_NO_FLAGS, LIBUSB_HOTPLUG_MATCH_ANY, LIBUSB_HOTPLUG_MATCH_ANY,
              LIBUSB_HOTPLUG_MATCH_ANY, &LibusbWatch::onEvent, this, &callback_) == LIBUSB_SUCCESS;
    thread_ = std::jthread([this](std::stop_token stop) { watch(stop); });
  }
  ~LibusbWatch() override {
    thread_.request_stop();
    thread_.join();
    if (registered_) libusb_hotplug_deregister_callback(context_, callback_);
    libusb_exit(context_);
  }
  LibusbWatch(const LibusbWatch&) = delete;
  LibusbWatch& operator=(const LibusbWatch&) = delete;

  How how() const override { return registered_ ? How::Events : How::Polling; }

 private:
  // Within libusb's own work no device may be touched: it is only noted.
  static int LIBUSB_CALL onEvent(libusb_context*, libusb_device*, libusb_hotplug_event,
                                 void* self) {
    static_cast<LibusbWatch*>(self)->noticed_ = true;
    return 0;
  }

  std::vector<Place> places() const {
    std::vector<Place> all;
    libusb_device** list = nullptr;
    const ssize_t count = libusb_get_device_list(context_, &list);
    for (ssize_t i = 0; i < count; ++i) {
      libusb_device_descriptor about{};
      if (libusb_get_device_descriptor(list[i], &about) != 0) continue;
      all.emplace_back(libusb_get_bus_number(list[i]), libusb_get_device_address(list[i]),
                       about.idVendor, about.idProduct);
    }
    if (count >= 0) libusb_free_device_list(list, 1);
    return all;
  }

  void watch(const std::stop_token& stop) {
    std::vector<Place> before = registered_ ? std::vector<Place>() : places();
    bool pending = false;
    double since_s = 0;
    while (!stop.stop_requested()) {
      if (registered_) {
        timeval slice{0, 50'000};
        if (libusb_handle_events_timeout_completed(context_, &slice, nullptr) != 0 &&
            !clock_->sleep(0.05, stop))  // it failed at once: do not spin
          return;
      } else {
        if (!clock_->sleep(options_.poll_s, stop)) return;
        std::vector<Place> now = places();
        noticed_ = now != before;
        before = std::move(now);
      }
      if (noticed_.exchange(false)) {
        pending = true;
        since_s = clock_->now_s();
      }
      const bool over = !registered_ || clock_->now_s() - since_s >= options_.settled_s;
      if (!pending || !over || stop.stop_requested()) continue;
      pending = false;
      changed_();
    }
  }

  libusb_context* context_;
  std::function<void()> changed_;
  UsbWatchOptions options_;
  std::shared_ptr<Clock> clock_ = steadyClock();
  libusb_hotplug_callback_handle callback_ = 0;
  bool registered_ = false;
  std::atomic<bool> noticed_ = false;
  std::jthread thread_;  // last: it works with all others
};

}  // namespace

Result<std::unique_ptr<UsbWatch>> watchUsb(std::function<void()> changed,
                                           const UsbWatchOptions& options) {
  libusb_context* context = nullptr;
  if (libusb_init(&context) != 0)
    return Error::missing(message("USB does not work on this computer."));
  return std::unique_ptr<UsbWatch>(
      std::make_unique<LibusbWatch>(context, std::move(changed), options));
}

}  // namespace ostraka::devices
