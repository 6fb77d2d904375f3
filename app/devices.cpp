#include "devices/devices.h"

#include <CLI/CLI.hpp>
#include <condition_variable>
#include <cstdio>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>

#include "cameras/desktop_hold.h"
#include "cameras/gphoto_camera.h"
#include "command.h"
#include "devices/usb_watch.h"
#include "shown.h"

namespace ostraka::app {
namespace {

// What only the camera itself tells: the number that binds it to its place.
void askCameras(std::vector<devices::FoundDevice>& devices) {
  const std::vector<cameras::FoundCamera> cameras = cameras::listGphotoCameras();
  for (devices::FoundDevice& device : devices)
    for (const cameras::FoundCamera& camera : cameras) {
      if (device.kind != devices::DeviceKind::Camera || device.port != camera.id.port) continue;
      device.model = camera.id.model;
      if (!camera.id.serial.empty()) device.serial = device.address = camera.id.serial;
      if (!camera.trouble.empty() && device.troubles.empty())
        device.troubles.push_back(camera.trouble);
    }
}

struct DevicesArguments {
  bool release = false, watch = false;
};

void print(const std::vector<devices::FoundDevice>& devices) {
  for (const devices::FoundDevice& d : devices) {
    show(stdout, "%s: %s%s%s\n", devices::name(d.kind).c_str(), d.model.c_str(),
         d.serial.empty() ? "" : ", number ", d.serial.c_str());
    show(stdout, "  in RIG.json: driver %s, %s\n", d.driver.c_str(),
         d.address.empty() ? "no address" : d.address.c_str());
    for (const Message& trouble : d.troubles) show(stdout, "  %s\n", trouble.english().c_str());
    if (d.troubles.empty()) show(stdout, "  ready\n");
  }
  if (devices.empty())
    show(stdout,
         "No camera and no turntable is plugged in. Cameras that are asleep, or set to mass "
         "storage, do not show; the virtual rig needs none: ostraka capture --rig virtual\n");
}

int printDevices(const Session& session) {
  std::vector<devices::FoundDevice> devices = devices::findDevices({});
  askCameras(devices);
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const devices::FoundDevice& d : devices)
    list.push_back({{"kind", devices::name(d.kind)},
                    {"model", d.model},
                    {"serial", d.serial},
                    {"usb", d.usb},
                    {"driver", d.driver},
                    {"address", d.address},
                    {"troubles", d.troubles}});
  return finish(session, Whole, {{"devices", list}}, [&] { print(devices); });
}

// Again whenever something was plugged in or out, until Ctrl-C.
int watchDevices(Session& session) {
  std::mutex guard;
  std::condition_variable_any told;
  bool changed = true;
  const Result<std::unique_ptr<devices::UsbWatch>> watch = devices::watchUsb(
      [&] {
        const std::lock_guard lock(guard);
        changed = true;
        told.notify_all();
      },
      {});
  if (!watch) return fail(session, watch.error());
  while (!session.stop.stop_requested()) {
    std::unique_lock lock(guard);
    if (!told.wait(lock, session.stop, [&] { return changed; })) break;
    changed = false;
    lock.unlock();
    printDevices(session);
    if (!session.json) show(stdout, "\n");
    std::fflush(stdout);
  }
  return Whole;
}

int runDevices(const DevicesArguments& arguments, Session& session) {
  if (arguments.release)
    if (const Result<void> released = cameras::releaseFromDesktop(
            devices::findDevices({}), cameras::programRunner(session.stop),
            [] { return devices::findDevices({}); });
        !released)
      return fail(session, released.error());
  return arguments.watch ? watchDevices(session) : printDevices(session);
}

}  // namespace

void addDevices(CLI::App& root, Command& chosen) {
  CLI::App* command =
      root.add_subcommand("devices", "Cameras and turntables: what is plugged in, what is wrong");
  auto arguments = std::make_shared<DevicesArguments>();
  command->add_flag("--release", arguments->release,
                    "First make the desktop let go of cameras that it holds");
  command->add_flag("--watch", arguments->watch,
                    "List them again whenever one is plugged in or out, until Ctrl-C");
  workOf(*command, chosen, runDevices, arguments);
}

}  // namespace ostraka::app
