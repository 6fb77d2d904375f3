#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "base/result.h"
#include "capture/sequence.h"

namespace ostraka::capture {

/// Which camera stands at a place.
struct CameraPlace {
  std::string driver;                           ///< "gphoto2", "uvc" or "folder"
  std::string serial;                           ///< of a folder: empty, or the EXIF body serial
  std::filesystem::path folder;                 ///< of a folder
  std::map<std::string, std::string> settings;  ///< compared, and set, before each side
};

/// How the table is reached.
struct TurntablePlace {
  std::string driver;   ///< "grbl", "comxim1", "comxim2", "hand"
  std::string channel;  ///< "usb:1209:0001[:serial]", "/dev/serial/by-id/...", "tcp:host:port"
  int baud = 115200;
  double speed_deg_s = 20;
  std::string
      shutter;  ///< GRBL: "M8", "M3" or "M62 P0"; empty: the cameras are triggered one by one
};

/// The part "devices" of RIG.json: what stands in the laboratory.
struct DevicesFile {
  TurntablePlace turntable;
  std::vector<CameraPlace> cameras;  ///< by place
  double settle_s = 1.5;
  std::filesystem::path plate;  ///< plate.json; relative to RIG.json
};

Result<DevicesFile> readDevices(const std::filesystem::path& rig_file);
/// Puts the part into RIG.json and leaves all others as they are.
Result<void> writeDevices(const std::filesystem::path& rig_file, const DevicesFile& devices);

/// Opens all devices of RIG.json; an unknown serial number stops with that number.
/// `rig virtual` is virtualrig::openVirtualRig.
Result<RigDevices> openRigDevices(const std::filesystem::path& rig_file, std::stop_token stop);

}  // namespace ostraka::capture
