// The real libusb on a device of umockdev.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "devices/byte_channel.h"
#include "devices/clock.h"
#include "tests/core/devices/fake_usb.h"
#include "turntables/grbl.h"

namespace ostraka::devices {
namespace {

using capture::testing::Mischief;
using capture::testing::SimulatedGrbl;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class UsbChannel : public ::testing::Test {
 protected:
  std::shared_ptr<SimulatedGrbl> controller_ =
      std::make_shared<SimulatedGrbl>(steadyClock(), Mischief{});
  FakeUsb usb_{controller_};
};

TEST_F(UsbChannel, TakesTheDeviceFromTheKernelAndGivesItBack) {
  usb_.plugIn();
  {
    const auto channel = openUsb("1209:0001:S7", 115200);
    ASSERT_TRUE(channel.has_value()) << channel.error().what;
    EXPECT_TRUE(usb_.withKernel().empty());
    // 115200 is 0x01C200, least byte first; then 1 stop bit, no parity, 8 bits.
    EXPECT_THAT(usb_.lineCoding(), ElementsAre(0x00, 0xC2, 0x01, 0x00, 0, 0, 8));
    EXPECT_EQ(usb_.control_lines, 3);
  }
  EXPECT_THAT(usb_.withKernel(), ElementsAre(0, 1));
}

TEST_F(UsbChannel, TurnsATable) {
  usb_.plugIn();
  controller_->opened();
  auto channel = openUsb("1209:0001", 115200);
  ASSERT_TRUE(channel.has_value()) << channel.error().what;
  auto table = turntables::openGrbl(std::move(*channel), {.speed_deg_s = 2000}, steadyClock(), {});
  ASSERT_TRUE(table.has_value()) << table.error().what;
  ASSERT_TRUE((*table)->zeroHere({}).has_value());
  ASSERT_TRUE((*table)->moveTo(45, {}).has_value());
  EXPECT_NEAR(controller_->degrees(), 45, 1e-3);
}

TEST_F(UsbChannel, NoticesThatTheCableIsPulledAndComesBack) {
  usb_.plugIn();
  const auto channel = openUsb("1209:0001", 115200);
  ASSERT_TRUE(channel.has_value()) << channel.error().what;
  EXPECT_EQ((*channel)->read(0.02, {}).value(), "");
  usb_.pullOut();
  const auto read = (*channel)->read(1, {});
  ASSERT_FALSE(read.has_value());
  EXPECT_EQ(read.error().code, ErrorCode::Missing);
  EXPECT_EQ((*channel)->write("?").error().code, ErrorCode::Missing);
  usb_.unplug();
  usb_.plugIn();
  ASSERT_TRUE((*channel)->reopen({}).has_value());
  ASSERT_TRUE((*channel)->write("$I\n").has_value());
  std::string said;
  for (int k = 0; k < 20 && said.find("VER") == std::string::npos; ++k)
    said += (*channel)->read(0.05, {}).value();
  EXPECT_THAT(said, HasSubstr("[VER:1.1h"));
}

TEST_F(UsbChannel, SaysWhyADeviceCannotBeUsed) {
  EXPECT_THAT(openUsb("1209:0001", 115200).error().what, HasSubstr("not plugged in"));
  EXPECT_EQ(openUsb("turntable", 115200).error().code, ErrorCode::UnusableInput);
  EXPECT_EQ(openUsb("1209:zz", 115200).error().code, ErrorCode::UnusableInput);
  usb_.plugIn();
  EXPECT_THAT(openUsb("1209:0001:S8", 115200).error().what, HasSubstr("serial number"));
  usb_.held_by_another = true;
  EXPECT_THAT(openUsb("1209:0001", 115200).error().what, HasSubstr("Another program"));
}

}  // namespace
}  // namespace ostraka::devices
