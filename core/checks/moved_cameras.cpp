#include "checks/moved_cameras.h"

#include <nlohmann/json.hpp>

#include "base/message.h"
#include "calibration/calibrate.h"
#include "files/files.h"
#include "files/json.h"
#include "files/json_numbers.h"
#include "rig/rig.h"

namespace ostraka::checks {
namespace {

namespace fs = std::filesystem;

std::vector<int> numbersOf(const rig::Rig& rig) {
  std::vector<int> numbers;
  for (const rig::RigCamera& camera : rig.cameras) numbers.push_back(camera.camera);
  return numbers;
}

// RIG.before-1.json, the first name that is free.
fs::path nameForTheOld(const fs::path& rig_file) {
  for (int n = 1;; ++n) {
    fs::path name = rig_file;
    name.replace_filename(rig_file.stem().string() + ".before-" + std::to_string(n) +
                          rig_file.extension().string());
    if (std::error_code ignored; !fs::exists(name, ignored)) return name;
  }
}

}  // namespace

Result<std::vector<MovedCamera>> movedCameras(const fs::path& output) {
  const fs::path file = output / "work" / "rig" / "stage.json";
  const Result<nlohmann::json> stage = readJson(file);
  if (!stage) return stage.error();
  const double most_px = calibration::PoseOptions().max_known_rig_residual_px;
  std::vector<MovedCamera> moved;
  try {
    for (const nlohmann::json& camera :
         stage->at("figures").value("cameras", nlohmann::json::array())) {
      const double residual_px = numberAt(camera, "known_rig_residual_px");
      if (residual_px <= most_px) continue;
      moved.push_back({wholeAt(camera, "camera"), residual_px, numberAt(camera, "moved_mm"),
                       numberAt(camera, "turned_rad")});
    }
  } catch (const nlohmann::json::exception&) {
    return Error::unusable(message("This file does not state how well the rig fits."),
                           file.string());
  }
  return moved;
}

Result<fs::path> calibrateFrom(const fs::path& output, const fs::path& rig_file) {
  const Result<rig::Rig> fresh = rig::readRig(output / "work" / "rig" / "rig.json");
  if (!fresh) return fresh.error();
  const Result<rig::Rig> old = rig::readRig(rig_file);
  if (!old) return old.error();
  if (numbersOf(*fresh) != numbersOf(*old))
    return Error::unusable(message("This calibration is for other cameras than those of the batch; "
                                   "calibrate the rig from its "
                                   "own photographs."),
                           rig_file.string());
  const Result<std::string> bytes = readFile(rig_file);
  if (!bytes) return bytes.error();
  const fs::path kept = nameForTheOld(rig_file);
  if (const Result<void> written = writeFileAtomically(kept, *bytes); !written)
    return written.error();
  if (const Result<void> written = rig::writeRig(rig_file, *fresh); !written)
    return written.error();
  return kept;
}

}  // namespace ostraka::checks
