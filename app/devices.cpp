#include "capture/devices.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "capture/gphoto_camera.h"
#include "command.h"

namespace ostraka::app {
namespace {

// What only the camera itself tells: the number that binds it to its place.
void askCameras(std::vector<capture::FoundDevice>& devices) {
  const Result<std::vector<capture::FoundCamera>> cameras = capture::listGphotoCameras();
  if (!cameras) return;
  for (capture::FoundDevice& device : devices)
    for (const capture::FoundCamera& camera : *cameras) {
      if (device.kind != capture::DeviceKind::Camera || device.port != camera.id.port) continue;
      device.model = camera.id.model;
      if (!camera.id.serial.empty()) device.serial = device.address = camera.id.serial;
      if (!camera.trouble.empty() && device.troubles.empty())
        device.troubles.push_back(camera.trouble);
    }
}

int runDevices(Session& session) {
  std::vector<capture::FoundDevice> devices = capture::findDevices({});
  askCameras(devices);
  if (session.json) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const capture::FoundDevice& d : devices)
      list.push_back({{"kind", capture::name(d.kind)},
                      {"model", d.model},
                      {"serial", d.serial},
                      {"usb", d.usb},
                      {"driver", d.driver},
                      {"address", d.address},
                      {"troubles", d.troubles}});
    printJson({{"devices", list}, {"exit_status", static_cast<int>(Whole)}});
    return Whole;
  }
  for (const capture::FoundDevice& d : devices) {
    std::printf("%s: %s%s%s\n", capture::name(d.kind).c_str(), d.model.c_str(),
                d.serial.empty() ? "" : ", number ", d.serial.c_str());
    std::printf("  in RIG.json: driver %s, %s\n", d.driver.c_str(),
                d.address.empty() ? "no address" : d.address.c_str());
    for (const std::string& trouble : d.troubles) std::printf("  %s\n", trouble.c_str());
    if (d.troubles.empty()) std::printf("  ready\n");
  }
  if (devices.empty())
    std::printf(
        "No camera and no turntable is plugged in. Cameras that are asleep, or set to mass "
        "storage, do not show; the virtual rig needs none: ostraka capture --rig virtual\n");
  return Whole;
}

}  // namespace

void addDevices(CLI::App& root, Command& chosen) {
  CLI::App* command =
      root.add_subcommand("devices", "Cameras and turntables: what is plugged in, what is wrong");
  command->callback([&chosen] { chosen = [](Session& session) { return runDevices(session); }; });
}

}  // namespace ostraka::app
