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
  std::string serial;                           ///< of uvc: /dev/v4l/by-id/...; of a folder: empty
  std::filesystem::path folder;                 ///< of a folder
  std::map<std::string, std::string> settings;  ///< compared, and set, before each side
};

/// How the table is reached.
struct TurntablePlace {
  std::string driver;   ///< "grbl", "comxim1", "comxim2", "text" or "hand"
  std::string channel;  ///< "usb:1209:0001[:serial]", "/dev/serial/by-id/...", "tcp:host:port"
  int baud = 115200;
  double speed_deg_s = 20;
  bool clockwise = false;  ///< the table counts clockwise
  std::string shutter{};   ///< GRBL: "M8", "M3" or "M62 P0"; empty: each camera is triggered
  std::string dialect{};   ///< of "text": its words as JSON, or "marlin" (text_turntable.h)
};

/// The part "devices" of RIG.json, written by a person: what stands in the laboratory.
struct DevicesFile {
  TurntablePlace turntable;
  std::vector<CameraPlace> cameras;  ///< by place
  double settle_s = 1.5;
  std::filesystem::path plate;  ///< plate.json; relative to RIG.json
};

/// Errors: UnusableInput with what is missing or wrong.
Result<DevicesFile> readDevices(const std::filesystem::path& rig_file);

/// Where the table stands is written down beside RIG.json, in RIG.turntable.json.
/// Opens all devices of RIG.json; a camera that is not plugged in stops with its serial number, and
/// with those that are. ask: needed by the driver "hand" only. The virtual rig is
/// virtualrig::openVirtualRig. Errors: UnusableInput (the file), Missing (a device).
Result<RigDevices> openRigDevices(const std::filesystem::path& rig_file,
                                  const devices::AskPerson& ask, std::stop_token stop);

}  // namespace ostraka::capture
