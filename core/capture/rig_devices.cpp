#include "capture/rig_devices.h"

#include <nlohmann/json.hpp>

#include "base/message.h"
#include "cameras/folder_camera.h"
#include "cameras/gphoto_camera.h"
#include "cameras/uvc_camera.h"
#include "files/json.h"
#include "files/json_numbers.h"
#include "files/json_text.h"
#include "turntables/comxim.h"
#include "turntables/grbl.h"
#include "turntables/hand_turntable.h"
#include "turntables/journaled_turntable.h"
#include "turntables/text_turntable.h"

namespace ostraka::capture {
namespace {

namespace fs = std::filesystem;

// Throws nlohmann's exceptions; the caller words them.
DevicesFile devicesFromJson(const nlohmann::json& json) {
  DevicesFile devices;
  const nlohmann::json& table = json.at("turntable");
  devices.turntable.driver = table.at("driver").get<std::string>();
  devices.turntable.channel = table.value("channel", "");
  devices.turntable.baud = wholeOr(table, "baud", devices.turntable.baud, 50, 4'000'000);
  devices.turntable.speed_deg_s =
      numberOr(table, "speed_deg_s", devices.turntable.speed_deg_s, 0, 3600);
  devices.turntable.clockwise = table.value("clockwise", false);
  devices.turntable.shutter = table.value("shutter", "");
  if (table.contains("dialect")) devices.turntable.dialect = table.at("dialect").dump();
  for (const nlohmann::json& c : json.at("cameras")) {
    CameraPlace place;
    place.driver = c.at("driver").get<std::string>();
    place.serial = c.value("serial", "");
    place.folder = c.value("folder", "");
    place.settings = c.value("settings", std::map<std::string, std::string>{});
    devices.cameras.push_back(std::move(place));
  }
  devices.settle_s = numberOr(json, "settle_s", devices.settle_s, 0, 3600);
  devices.plate = json.value("plate", "plate.json");
  return devices;
}

Result<std::unique_ptr<devices::Turntable>> openTurntable(
    const TurntablePlace& place, const devices::AskPerson& ask,
    const std::shared_ptr<devices::Clock>& clock, const fs::path& rig_file, std::stop_token stop) {
  if (place.driver == "hand") return turntables::openHandTurntable(ask);
  const bool comxim = place.driver == "comxim1" || place.driver == "comxim2";
  const bool text = place.driver == "text";
  if (!comxim && !text && place.driver != "grbl")
    return Error::unusable(
        message(
            "The turntable driver %1 is unknown; available: grbl, comxim1, comxim2, text, hand.",
            place.driver),
        rig_file);
  turntables::TextTableOptions words{turntables::marlinDialect(), place.speed_deg_s,
                                     place.clockwise};
  if (text && !place.dialect.empty()) {
    const Result<turntables::TextDialect> dialect =
        turntables::dialectFromJson(jsonOrDiscarded(place.dialect));
    if (!dialect) return Error::unusable(dialect.error().what, rig_file);
    words.dialect = *dialect;
  }
  Result<std::unique_ptr<devices::ByteChannel>> channel =
      devices::openChannel(place.channel, place.baud);
  if (!channel) return channel.error();
  if (comxim) {
    const auto dialect = place.driver == "comxim1" ? turntables::ComXimDialect::Brackets
                                                   : turntables::ComXimDialect::Commas;
    return turntables::openComXim(
        std::move(*channel), {dialect, place.speed_deg_s, place.clockwise}, clock, std::move(stop));
  }
  if (text) return turntables::openTextTable(std::move(*channel), words, clock, std::move(stop));
  const turntables::GrblOptions options{place.speed_deg_s, place.shutter, place.clockwise};
  return turntables::openGrbl(std::move(*channel), options, clock, std::move(stop));
}

Result<std::unique_ptr<devices::Camera>> openCamera(const CameraPlace& place,
                                                    const std::shared_ptr<devices::Clock>& clock,
                                                    const fs::path& rig_file) {
  if (place.driver == "folder") {
    cameras::FolderCameraOptions options;
    options.folder =
        place.folder.is_relative() ? rig_file.parent_path() / place.folder : place.folder;
    return cameras::openFolderCamera(options, clock);
  }
  if (place.driver == "gphoto2") return cameras::openGphotoCamera(place.serial, clock);
  if (place.driver == "uvc") {
    cameras::UvcOptions options;
    options.source = place.serial;
    return cameras::openUvcCamera(options, clock);
  }
  return Error::unusable(
      message("The camera driver %1 is unknown; available: folder, gphoto2, uvc.", place.driver),
      rig_file);
}

}  // namespace

Result<DevicesFile> readDevices(const fs::path& rig_file) {
  const Result<nlohmann::json> json = readJson(rig_file);
  if (!json) return json.error();
  if (!json->is_object() || !json->contains("devices"))
    return Error::unusable(message("The rig names no devices; 'ostraka devices' lists what is "
                                   "plugged in and how to enter it "
                                   "in the rig."),
                           rig_file);
  try {
    DevicesFile devices = devicesFromJson(json->at("devices"));
    if (devices.cameras.empty())
      return Error::unusable(message("The rig names no camera."), rig_file);
    if (!(devices.settle_s >= 0) || !(devices.turntable.speed_deg_s > 0))
      return Error::unusable(message("settle_s and speed_deg_s must be positive."), rig_file);
    if (devices.plate.is_relative()) devices.plate = rig_file.parent_path() / devices.plate;
    return devices;
  } catch (const nlohmann::json::exception& refused) {
    return unusableJson(
        refused, message("The section 'devices' cannot be read; compare it with docs/devices.md."),
        rig_file);
  }
}

Result<RigDevices> openRigDevices(const fs::path& rig_file, const devices::AskPerson& ask,
                                  std::stop_token stop) {
  const Result<DevicesFile> file = readDevices(rig_file);
  if (!file) return file.error();
  RigDevices devices;
  devices.settle_s = file->settle_s;
  const Result<batch::Plate> plate = batch::readPlate(file->plate);
  if (!plate) return plate.error();
  devices.plate = *plate;
  for (const CameraPlace& place : file->cameras) {
    if (stop.stop_requested()) return Error::cancelled();
    Result<std::unique_ptr<devices::Camera>> camera = openCamera(place, devices.clock, rig_file);
    if (!camera) return camera.error();
    std::map<std::string, std::string>& wanted = devices.wanted_settings.emplace_back();
    for (const auto& [name, value] : place.settings) {
      const Result<devices::CameraSetting> set = (*camera)->set(name, value);
      if (!set) return set.error();
      wanted[name] = set->value;  // as the camera writes it
    }
    devices.cameras.push_back(std::move(*camera));
  }
  Result<std::unique_ptr<devices::Turntable>> table =
      openTurntable(file->turntable, ask, devices.clock, rig_file, stop);
  if (!table) return table.error();
  devices.turntable = std::move(*table);
  if (devices.turntable->turnsItself())
    devices.turntable = turntables::rememberPosition(
        std::move(devices.turntable), fs::path(rig_file).replace_extension(".turntable.json"));
  return devices;
}

}  // namespace ostraka::capture
