#include "tests/core/devices/fake_usb.h"

#include <gtest/gtest.h>
#include <sys/ioctl.h>

#include <linux/usbdevice_fs.h>  // after the macros that it needs

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>

namespace ostraka::devices {
namespace {

using capture::testing::SimulatedGrbl;

constexpr const char* kNode = "/dev/bus/usb/001/002";
constexpr const char* kPlace = "/sys/devices/pci0000:00/usb1/1-1";

std::string hexOf(const std::vector<int>& bytes) {
  std::string text;
  for (const int b : bytes) {
    char pair[3];
    std::snprintf(pair, sizeof pair, "%02X", b);
    text += pair;
  }
  return text;
}

// A CDC-ACM device: interface 0 with an interrupt endpoint, interface 1 with bulk in and out.
std::string descriptors() {
  return hexOf(
      {18, 1,  0,  2, 2, 0, 0, 64,   0x09, 0x12, 0x01, 0x00, 0, 1, 1,    2,  3,  1,  // device
       9,  2,  48, 0, 2, 1, 0, 0x80, 50,  // configuration
       9,  4,  0,  0, 1, 2, 2, 1,    0,    7,    5,    0x82, 3, 8, 0,    10, 9,  4, 1, 0,
       2,  10, 0,  0, 0, 7, 5, 0x81, 2,    64,   0,    0,    7, 5, 0x01, 2,  64, 0, 0});
}

UMockdevIoctlData* argument(UMockdevIoctlClient* client, std::size_t size) {
  return umockdev_ioctl_data_resolve(umockdev_ioctl_client_get_arg(client), 0, size, nullptr);
}

void done(UMockdevIoctlClient* client, long result, int reason = 0) {
  umockdev_ioctl_client_complete(client, result, reason);
}

usbdevfs_urb* urbOf(UMockdevIoctlData* data) {
  return reinterpret_cast<usbdevfs_urb*>(data->data);
}

}  // namespace

FakeUsb::FakeUsb(std::shared_ptr<SimulatedGrbl> controller)
    : controller_(std::move(controller)), testbed_(umockdev_testbed_new()) {
  base_ = umockdev_ioctl_base_new();
  g_signal_connect(base_, "handle-ioctl", G_CALLBACK(&FakeUsb::onIoctl), this);
}

FakeUsb::~FakeUsb() {
  if (plugged_) unplug();
  g_object_unref(base_);
  g_object_unref(testbed_);
}

void FakeUsb::plugIn() {
  const std::string hex = descriptors();
  const std::string device =
      "P: /devices/pci0000:00/usb1/1-1\nN: bus/usb/001/002=" + hex +
      "\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_device\nE: DEVNAME=/dev/bus/usb/001/002\n"
      "E: BUSNUM=001\nE: DEVNUM=002\nE: MAJOR=189\nE: MINOR=1\nA: busnum=1\\n\nA: devnum=2\\n\n"
      "A: speed=12\\n\nA: bConfigurationValue=1\\n\nA: idVendor=1209\\n\nA: idProduct=0001\\n\n"
      "H: descriptors=" +
      hex + "\n\n";
  GError* failed = nullptr;
  umockdev_testbed_add_from_string(testbed_, device.c_str(), &failed);
  ASSERT_EQ(failed, nullptr) << failed->message;
  umockdev_testbed_attach_ioctl(testbed_, kNode, base_, &failed);
  ASSERT_EQ(failed, nullptr) << failed->message;
  umockdev_testbed_uevent(testbed_, kPlace, "add");
  const std::lock_guard lock(guard_);
  plugged_ = true;
  with_kernel_ = {0, 1};
}

void FakeUsb::pullOut() {
  const std::lock_guard lock(guard_);
  plugged_ = false;
}

void FakeUsb::unplug() {
  pullOut();
  GError* failed = nullptr;
  umockdev_testbed_detach_ioctl(testbed_, kNode, &failed);
  umockdev_testbed_uevent(testbed_, kPlace, "remove");
  umockdev_testbed_remove_device(testbed_, kPlace);
}

std::set<int> FakeUsb::withKernel() const {
  const std::lock_guard lock(guard_);
  return with_kernel_;
}

std::vector<int> FakeUsb::lineCoding() const {
  const std::lock_guard lock(guard_);
  return line_coding_;
}

gboolean FakeUsb::onIoctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, FakeUsb* self) {
  const std::lock_guard lock(self->guard_);
  self->handle(client);
  return TRUE;
}

void FakeUsb::handle(UMockdevIoctlClient* client) {
  if (!plugged_) return done(client, -1, ENODEV);
  switch (umockdev_ioctl_client_get_request(client)) {
    case USBDEVFS_GET_CAPABILITIES: {
      UMockdevIoctlData* value = argument(client, 4);
      std::memset(value->data, 0, 4);
      return done(client, 0);
    }
    case USBDEVFS_GETDRIVER:
      return getDriver(client);
    case USBDEVFS_IOCTL:
      return kernelDriver(client);
    case USBDEVFS_CLAIMINTERFACE:
      return held_by_another ? done(client, -1, EBUSY) : done(client, 0);
    case USBDEVFS_RELEASEINTERFACE:
    case USBDEVFS_CLEAR_HALT:
    case USBDEVFS_SETCONFIGURATION:
      return done(client, 0);
    case USBDEVFS_SUBMITURB:
      return submit(client);
    case USBDEVFS_REAPURBNDELAY:
    case USBDEVFS_REAPURB:
      return reap(client);
    case USBDEVFS_DISCARDURB:
      return discard(client);
    default:
      return done(client, -1, ENOTTY);
  }
}

void FakeUsb::getDriver(UMockdevIoctlClient* client) {
  auto* about =
      reinterpret_cast<usbdevfs_getdriver*>(argument(client, sizeof(usbdevfs_getdriver))->data);
  if (!with_kernel_.contains(static_cast<int>(about->interface))) return done(client, -1, ENODATA);
  std::strcpy(about->driver, "cdc_acm");
  done(client, 0);
}

void FakeUsb::kernelDriver(UMockdevIoctlClient* client) {
  const auto* command =
      reinterpret_cast<usbdevfs_ioctl*>(argument(client, sizeof(usbdevfs_ioctl))->data);
  if (static_cast<unsigned>(command->ioctl_code) == USBDEVFS_DISCONNECT) {
    if (with_kernel_.erase(command->ifno) == 0) return done(client, -1, ENODATA);
    return done(client, 0);
  }
  with_kernel_.insert(command->ifno);
  done(client, 1);
}

void FakeUsb::submit(UMockdevIoctlClient* client) {
  UMockdevIoctlData* data = argument(client, sizeof(usbdevfs_urb));
  usbdevfs_urb* urb = urbOf(data);
  UMockdevIoctlData* buffer = umockdev_ioctl_data_resolve(
      data, offsetof(usbdevfs_urb, buffer), static_cast<std::size_t>(urb->buffer_length), nullptr);
  g_object_ref(data);
  const Transfer transfer{data, buffer};
  if (urb->type == USBDEVFS_URB_TYPE_CONTROL) {
    control(transfer);
  } else if ((urb->endpoint & 0x80) == 0) {
    controller_->receive(std::string(reinterpret_cast<char*>(buffer->data),
                                     static_cast<std::size_t>(urb->buffer_length)));
    finish(transfer, urb->buffer_length);
  } else {
    waiting_.push_back(transfer);
  }
  done(client, 0);
}

void FakeUsb::control(const Transfer& transfer) {
  const guint8* setup = transfer.buffer->data;
  guint8* payload = transfer.buffer->data + 8;
  const int length = setup[6] | setup[7] << 8;
  if (setup[1] == 0x20) {
    line_coding_.assign(payload, payload + length);
    return finish(transfer, length);
  }
  if (setup[1] == 0x22) {
    control_lines = setup[2];
    return finish(transfer, 0);
  }
  if (setup[0] == 0x80 && setup[1] == 6 && setup[3] == 3) {  // a string: languages, or "S7"
    const std::vector<guint8> text =
        setup[2] == 0 ? std::vector<guint8>{4, 3, 9, 4} : std::vector<guint8>{6, 3, 'S', 0, '7', 0};
    const int n = std::min<int>(length, static_cast<int>(text.size()));
    std::memcpy(payload, text.data(), static_cast<std::size_t>(n));
    return finish(transfer, n);
  }
  urbOf(transfer.urb)->status = -EPIPE;
  finished_.push_back(transfer);
}

void FakeUsb::finish(const Transfer& transfer, int length) {
  urbOf(transfer.urb)->status = 0;
  urbOf(transfer.urb)->actual_length = length;
  finished_.push_back(transfer);
}

void FakeUsb::reap(UMockdevIoctlClient* client) {
  said_ += controller_->said();
  if (!waiting_.empty() && !said_.empty()) {
    const Transfer transfer = waiting_.front();
    waiting_.pop_front();
    const std::size_t n =
        std::min(said_.size(), static_cast<std::size_t>(urbOf(transfer.urb)->buffer_length));
    std::memcpy(transfer.buffer->data, said_.data(), n);
    said_.erase(0, n);
    finish(transfer, static_cast<int>(n));
  }
  if (finished_.empty()) return done(client, -1, EAGAIN);
  const Transfer transfer = finished_.front();
  finished_.pop_front();
  umockdev_ioctl_data_set_ptr(argument(client, sizeof(void*)), 0, transfer.urb);
  done(client, 0);
}

void FakeUsb::discard(UMockdevIoctlClient* client) {
  gulong address = 0;
  std::memcpy(&address, umockdev_ioctl_client_get_arg(client)->data, sizeof address);
  for (auto it = waiting_.begin(); it != waiting_.end(); ++it) {
    if (it->urb->client_addr != address) continue;
    urbOf(it->urb)->status = -ENOENT;
    urbOf(it->urb)->actual_length = 0;
    finished_.push_back(*it);
    waiting_.erase(it);
    return done(client, 0);
  }
  done(client, -1, EINVAL);
}

}  // namespace ostraka::devices
