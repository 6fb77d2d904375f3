#include "devices/usb_watch.h"

#include <gtest/gtest.h>

#include <atomic>

#include "devices/clock.h"
#include "tests/core/devices/fake_usb.h"

namespace ostraka::devices {
namespace {

TEST(UsbWatch, TellsThatADeviceCameAndWent) {
  for (const auto how : {UsbWatchOptions::How::Events, UsbWatchOptions::How::Polling}) {
    FakeUsb usb(std::make_shared<capture::testing::SimulatedGrbl>(steadyClock(),
                                                                  capture::testing::Mischief{}));
    std::atomic<int> told = 0;
    const auto watch = watchUsb([&] { ++told; }, {.how = how, .poll_s = 0.05});
    ASSERT_TRUE(watch.has_value()) << watch.error().what;
    EXPECT_EQ((*watch)->how(), how);
    const auto waitFor = [&](int count) {
      for (int k = 0; k < 200 && told < count; ++k) steadyClock()->sleep(0.02, {});
      return told.load();
    };
    steadyClock()->sleep(0.15, {});  // the polling one has to see the empty bus first
    EXPECT_EQ(told, 0);
    usb.plugIn();
    EXPECT_EQ(waitFor(1), 1);
    usb.unplug();
    EXPECT_EQ(waitFor(2), 2);
  }
}

}  // namespace
}  // namespace ostraka::devices
