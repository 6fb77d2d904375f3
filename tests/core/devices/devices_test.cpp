#include "devices/devices.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "tests/core/files/temporary_folder.h"

namespace ostraka::devices {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// A computer in a folder: what /sys, /dev and /proc would show.
class Devices : public ::testing::Test {
 protected:
  void write(const fs::path& file, const std::string& text) const {
    fs::create_directories((root_ / file).parent_path());
    std::ofstream(root_ / file) << text << "\n";
  }
  fs::path plugIn(const std::string& place, const std::string& vendor, const std::string& product,
                  const std::string& name, const std::string& serial, int number) const {
    const fs::path device = fs::path("sys/bus/usb/devices") / place;
    write(device / "idVendor", vendor);
    write(device / "idProduct", product);
    write(device / "product", name);
    if (!serial.empty()) write(device / "serial", serial);
    write(device / "busnum", "1");
    write(device / "devnum", std::to_string(number));
    write(fs::path("dev/bus/usb/001") / ("00" + std::to_string(number)), "");
    return device;
  }
  void addInterface(const fs::path& device, const std::string& name, const std::string& kind,
                    const std::string& subclass) const {
    write(device / name / "bInterfaceClass", kind);
    write(device / name / "bInterfaceSubClass", subclass);
  }
  void hold(const std::string& process, const std::string& program, const fs::path& file) const {
    write(fs::path("proc") / process / "comm", program);
    fs::create_directories(root_ / "proc" / process / "fd");
    fs::create_symlink(file, root_ / "proc" / process / "fd" / "7");
  }
  std::vector<FoundDevice> find() const {
    return findDevices({root_ / "sys", root_ / "dev", root_ / "proc"});
  }

  TemporaryFolder temporary_;
  fs::path root_ = temporary_.path();
};

TEST_F(Devices, ListsCamerasControllersAndVideo) {
  const fs::path camera = plugIn("1-1", "04b0", "0428", "D3200", "0815", 2);
  addInterface(camera, "1-1:1.0", "06", "01");
  const fs::path table = plugIn("1-2", "1209", "0001", "Turntable", "T1", 3);
  addInterface(table, "1-2:1.0", "02", "02");
  addInterface(table, "1-2:1.1", "0a", "00");
  write(table / "1-2:1.0" / "tty" / "ttyACM0" / "dev", "166:0");
  const fs::path adapter = plugIn("1-3", "1a86", "7523", "USB Serial", "", 4);
  addInterface(adapter, "1-3:1.0", "ff", "01");
  write(adapter / "1-3:1.0" / "ttyUSB0" / "dev", "188:0");
  write("dev/ttyUSB0", "");
  const fs::path video = plugIn("1-4", "046d", "0825", "Webcam", "", 5);
  addInterface(video, "1-4:1.0", "0e", "01");
  addInterface(video, "1-4:1.1", "0e", "02");
  write(video / "1-4:1.0" / "video4linux" / "video0" / "dev", "81:0");
  write("dev/video0", "");
  fs::create_directories(root_ / "dev/v4l/by-id");
  fs::create_symlink("../../video0", root_ / "dev/v4l/by-id/usb-webcam-index0");
  addInterface(plugIn("1-5", "05ac", "0250", "Keyboard", "", 6), "1-5:1.0", "03", "01");

  const auto found = find();
  ASSERT_EQ(found.size(), 4u);
  EXPECT_EQ(found[0].kind, DeviceKind::Camera);
  EXPECT_EQ(found[0].model, "D3200");
  EXPECT_EQ(found[0].address, "0815");
  EXPECT_EQ(found[0].port, "usb:001,002");
  EXPECT_EQ(found[1].address, (root_ / "dev/ttyUSB0").string());
  EXPECT_EQ(found[2].address, "usb:1209:0001:T1");
  EXPECT_EQ(found[3].kind, DeviceKind::VideoCamera);
  EXPECT_EQ(found[3].address, (root_ / "dev/v4l/by-id/usb-webcam-index0").string());
  for (const FoundDevice& d : found) EXPECT_THAT(d.troubles, IsEmpty());
}

TEST_F(Devices, NamesTheProgramInTheWay) {
  const fs::path camera = plugIn("1-1", "04b0", "0428", "D3200", "0815", 2);
  addInterface(camera, "1-1:1.0", "06", "01");
  hold("4321", "gvfsd-gphoto2", root_ / "dev/bus/usb/001/002");
  hold("99", "editor", root_ / "somewhere/else");
  const auto found = find();
  ASSERT_EQ(found.size(), 1u);
  EXPECT_THAT(
      found[0].troubles,
      ElementsAre(HasSubstr("in use by gvfsd-gphoto2 (4321): 'ostraka devices --release'")));
  EXPECT_THAT(holdersOf(root_ / "somewhere/else", {root_ / "sys", root_ / "dev", root_ / "proc"}),
              ElementsAre("editor (99)"));
}

TEST_F(Devices, SaysThatAnAdapterHasNoDriver) {
  addInterface(plugIn("1-3", "1a86", "7523", "USB Serial", "", 4), "1-3:1.0", "ff", "01");
  const auto found = find();
  ASSERT_EQ(found.size(), 1u);
  EXPECT_THAT(found[0].troubles, ElementsAre(HasSubstr("no driver")));
}

TEST_F(Devices, AreNoneOnAComputerWithoutUsb) {
  EXPECT_THAT(find(), IsEmpty());
}

}  // namespace
}  // namespace ostraka::devices
