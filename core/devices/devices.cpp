#include "devices/devices.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <tuple>

#include "base/text.h"

namespace ostraka::devices {
namespace {

namespace fs = std::filesystem;

// The first line of a file of /sys; empty when there is none.
std::string lineOf(const fs::path& file) {
  std::ifstream in(file);
  std::string line;
  std::getline(in, line);
  while (!line.empty() && (line.back() == ' ' || line.back() == '\n')) line.pop_back();
  return line;
}

std::vector<fs::path> entriesOf(const fs::path& folder) {
  std::vector<fs::path> entries;
  std::error_code failed;
  for (fs::directory_iterator it(folder, failed); !failed && it != fs::directory_iterator();
       it.increment(failed))
    entries.push_back(it->path());
  std::sort(entries.begin(), entries.end());
  return entries;
}

// Serial adapters that are no CDC-ACM: their protocols live in the kernel's drivers.
bool isSerialAdapter(const std::string& vendor) {
  constexpr std::array kVendors{"1a86", "0403", "10c4", "067b"};  // CH340, FTDI, CP210x, PL2303
  return std::any_of(kVendors.begin(), kVendors.end(),
                     [&](const char* known) { return vendor == known; });
}

// "001/002" or "001,002".
std::string busNumbers(const fs::path& device, const char* between) {
  const auto number = [](const std::string& text) { return std::atoi(text.c_str()); };
  return formatted("%03d%s%03d", number(lineOf(device / "busnum")), between,
                   number(lineOf(device / "devnum")));
}

// "ttyACM0" below an interface, however deep the driver puts it.
std::optional<std::string> ttyOf(const fs::path& interface) {
  for (const fs::path& entry : entriesOf(interface)) {
    const std::string file = entry.filename().string();
    if (file == "tty")
      for (const fs::path& tty : entriesOf(entry)) return tty.filename().string();
    if (file.starts_with("ttyUSB")) return file;
  }
  return std::nullopt;
}

// A name that stays when other devices come and go.
std::string stableName(const std::string& node, const fs::path& by_id) {
  for (const fs::path& link : entriesOf(by_id)) {
    std::error_code failed;
    if (fs::read_symlink(link, failed).filename() == node) return link.string();
  }
  return {};
}

void judgeUse(const fs::path& node, const SystemFolders& folders, FoundDevice& device) {
  std::error_code absent;
  if (!fs::exists(node, absent)) return;
  if (::access(node.c_str(), R_OK | W_OK) != 0)
    device.troubles.push_back(
        message("You have no permission to use it: copy packaging/udev/70-ostraka.rules to "
                "/etc/udev/rules.d/ and plug it in again."));
  for (const std::string& holder : holdersOf(node, folders)) {
    device.holders.push_back(holder);
    const bool desktop = holder.starts_with("gvfs");
    device.troubles.push_back(
        desktop ? message("It is in use by %1: 'ostraka devices --release' releases it.", holder)
                : message("It is in use by %1: close that program.", holder));
  }
}

void addVideo(const fs::path& interface, const SystemFolders& folders, FoundDevice device,
              std::vector<FoundDevice>& found) {
  const std::vector<fs::path> nodes = entriesOf(interface / "video4linux");
  if (nodes.empty()) return;  // a second interface of the same camera
  const std::string node = nodes.front().filename().string();
  device.kind = DeviceKind::VideoCamera;
  device.driver = "uvc";
  device.address = stableName(node, folders.dev / "v4l" / "by-id");
  if (device.address.empty()) device.address = (folders.dev / node).string();
  judgeUse(folders.dev / node, folders, device);
  found.push_back(std::move(device));
}

void addSerial(const fs::path& interface, const SystemFolders& folders, bool cdc,
               FoundDevice device, std::vector<FoundDevice>& found) {
  device.kind = DeviceKind::Turntable;
  device.driver = "grbl";
  const std::optional<std::string> tty = ttyOf(interface);
  if (cdc) {
    device.address = "usb:" + device.usb + (device.serial.empty() ? "" : ":" + device.serial);
  } else {
    if (!tty) {
      device.troubles.push_back(
          message("The kernel has no driver for it; install one for this adapter."));
    } else {
      device.address = stableName(*tty, folders.dev / "serial" / "by-id");
      if (device.address.empty()) device.address = (folders.dev / *tty).string();
    }
  }
  if (tty) judgeUse(folders.dev / *tty, folders, device);
  found.push_back(std::move(device));
}

}  // namespace

std::string name(DeviceKind kind) {
  switch (kind) {
    case DeviceKind::Camera:
      return "camera";
    case DeviceKind::Turntable:
      return "serial controller";
    case DeviceKind::VideoCamera:
      return "video camera";
  }
  return {};
}

std::vector<std::string> holdersOf(const fs::path& device_file, const SystemFolders& folders) {
  std::vector<std::string> holders;
  for (const fs::path& process : entriesOf(folders.proc)) {
    const std::string id = process.filename().string();
    if (id.empty() || id.find_first_not_of("0123456789") != std::string::npos) continue;
    if (id == std::to_string(::getpid())) continue;
    for (const fs::path& open : entriesOf(process / "fd")) {
      std::error_code failed;
      if (fs::read_symlink(open, failed) != device_file) continue;
      holders.push_back(lineOf(process / "comm") + " (" + id + ")");
      break;
    }
  }
  return holders;
}

std::vector<FoundDevice> findDevices(const SystemFolders& folders) {
  std::vector<FoundDevice> found;
  for (const fs::path& path : entriesOf(folders.sys / "bus" / "usb" / "devices")) {
    const std::string vendor = lineOf(path / "idVendor");
    if (vendor.empty()) continue;  // an interface, not a device
    FoundDevice device;
    device.usb = vendor + ":" + lineOf(path / "idProduct");
    device.serial = lineOf(path / "serial");
    device.model = lineOf(path / "manufacturer");
    const std::string product = lineOf(path / "product");
    if (!product.empty()) device.model += (device.model.empty() ? "" : " ") + product;
    if (device.model.empty()) device.model = device.usb;
    const fs::path node = folders.dev / "bus" / "usb" / busNumbers(path, "/");
    device.port = "usb:" + busNumbers(path, ",");
    for (const fs::path& interface : entriesOf(path)) {
      const std::string kind = lineOf(interface / "bInterfaceClass"),
                        subclass = lineOf(interface / "bInterfaceSubClass");
      if (kind == "06") {  // still image: PTP
        FoundDevice camera = device;
        camera.kind = DeviceKind::Camera;
        camera.driver = "gphoto2";
        camera.address = camera.serial;
        judgeUse(node, folders, camera);
        found.push_back(std::move(camera));
      } else if (kind == "0e" && subclass == "01") {
        addVideo(interface, folders, device, found);
      } else if (kind == "02" && subclass == "02") {
        FoundDevice serial = device;
        judgeUse(node, folders, serial);
        addSerial(interface, folders, true, std::move(serial), found);
      } else if (kind == "ff" && isSerialAdapter(vendor)) {
        addSerial(interface, folders, false, device, found);
      }
    }
  }
  std::stable_sort(found.begin(), found.end(), [](const FoundDevice& a, const FoundDevice& b) {
    return std::tie(a.kind, a.address) < std::tie(b.kind, b.address);
  });
  return found;
}

}  // namespace ostraka::devices
