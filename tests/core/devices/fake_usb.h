#pragma once
#include <umockdev.h>

#include <deque>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "tests/core/capture/simulated_controllers.h"

namespace ostraka::devices {

/// A USB device that exists in umockdev only and answers each request of the kernel's usbfs: a
/// CDC-ACM line, 1209:0001 with serial number S7, to a controller. Run with
/// libumockdev-preload.so.0 preloaded.
class FakeUsb {
 public:
  explicit FakeUsb(std::shared_ptr<capture::testing::SimulatedGrbl> controller);
  ~FakeUsb();
  FakeUsb(const FakeUsb&) = delete;
  FakeUsb& operator=(const FakeUsb&) = delete;

  void plugIn();
  /// Gone for those who use it; unplug: also for those who look for it.
  void pullOut();
  void unplug();

  std::set<int> withKernel() const;  ///< interfaces that the kernel's driver has
  std::vector<int> lineCoding() const;
  int control_lines = -1;
  bool held_by_another = false;

 private:
  struct Transfer {
    UMockdevIoctlData* urb;
    UMockdevIoctlData* buffer;
  };

  static gboolean onIoctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, FakeUsb* self);
  void handle(UMockdevIoctlClient* client);
  void getDriver(UMockdevIoctlClient* client);
  void kernelDriver(UMockdevIoctlClient* client);
  void submit(UMockdevIoctlClient* client);
  void control(const Transfer& transfer);
  void finish(const Transfer& transfer, int length);
  void reap(UMockdevIoctlClient* client);
  void discard(UMockdevIoctlClient* client);

  std::shared_ptr<capture::testing::SimulatedGrbl> controller_;
  UMockdevTestbed* testbed_;
  UMockdevIoctlBase* base_;
  mutable std::mutex guard_;
  bool plugged_ = false;
  std::set<int> with_kernel_;
  std::vector<int> line_coding_;
  std::deque<Transfer> waiting_, finished_;
  std::string said_;
};

}  // namespace ostraka::devices
