#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "base/message.h"

namespace ostraka::devices {

enum class DeviceKind { Camera, Turntable, VideoCamera };
std::string name(DeviceKind kind);

/// Something plugged in that the rig could use.
struct FoundDevice {
  DeviceKind kind = DeviceKind::Turntable;
  std::string model;                   ///< as the device calls itself
  std::string serial;                  ///< empty when it has none
  std::string usb;                     ///< "1209:0001"
  std::string port;                    ///< "usb:001,002"
  std::string address;                 ///< for RIG.json: turntable.channel, or a camera's serial
  std::string driver;                  ///< for RIG.json: "grbl", "gphoto2" or "uvc"
  std::vector<std::string> holders{};  ///< programs that have it open: "gvfsd-gphoto2 (1234)"
  std::vector<Message> troubles;       ///< what is wrong and what to do; empty: all is well
};

/// Where the system's files lie; handed in for tests.
struct SystemFolders {
  std::filesystem::path sys = "/sys", dev = "/dev", proc = "/proc";
};

/// What is plugged in at USB, and what is wrong with it: no permission, or held by which program.
/// Opens no device. Sorted by kind and place.
std::vector<FoundDevice> findDevices(const SystemFolders& folders);

/// Programs that hold a device file open: "gvfsd-gphoto2 (1234)".
std::vector<std::string> holdersOf(const std::filesystem::path& device_file,
                                   const SystemFolders& folders);

}  // namespace ostraka::devices
