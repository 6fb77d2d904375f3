#include "rig/rig.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "base/limits.h"
#include "base/message.h"
#include "files/json.h"
#include "files/json_numbers.h"

namespace ostraka::rig {
namespace {

constexpr const char* kFormat = "ostraka-rig/1";

constexpr double kLeastFocal_px = 1, kMost_px = 1e7;
constexpr std::size_t kParameters = 15;  // of a camera with its pose

nlohmann::ordered_json toJson(const RigCamera& camera) {
  const Intrinsics& i = camera.intrinsics;
  nlohmann::ordered_json json = {{"camera", camera.camera},
                                 {"width", i.width},
                                 {"height", i.height},
                                 {"K", {{i.fx, 0, i.cx}, {0, i.fy, i.cy}, {0, 0, 1}}}};
  writeLens(i.distortion, json);
  json["camera_from_turntable"] = ostraka::toJson(camera.camera_from_turntable);
  json["focal_sd_px"] = camera.focal_sd_px;
  json["intrinsics_rms_px"] = camera.intrinsics_rms_px;
  json["marker_inset_px"] = camera.marker_inset_px;
  if (camera.covariance.empty()) return json;
  json["covariance_of"] = {"fx", "fy", "cx", "cy", "k1", "k2", "p1", "p2",
                           "k3", "rx", "ry", "rz", "tx", "ty", "tz"};
  json["covariance"] = camera.covariance;
  return json;
}

// Throws nlohmann's exceptions; the caller words them.
Result<RigCamera> cameraFromJson(const nlohmann::json& value, const std::filesystem::path& file) {
  RigCamera camera;
  camera.camera = wholeAt(value, "camera", 0, limits::kRigCameras.most);
  Intrinsics& i = camera.intrinsics;
  i.width = wholeAt(value, "width", 1, limits::kImageSide.most);
  i.height = wholeAt(value, "height", 1, limits::kImageSide.most);
  const auto [shorter, longer] =
      std::minmax({static_cast<std::uint64_t>(i.width), static_cast<std::uint64_t>(i.height)});
  if (longer > limits::kRigRatio.most * shorter || longer * shorter > limits::kImagePixels.most)
    return Error::unusable(
        message("Camera %1 has pictures of %2 x %3 pixels, which no camera takes; recalibrate the "
                "rig.",
                camera.camera, i.width, i.height),
        file);
  const nlohmann::json& k = value.at("K");
  i.fx = numberIn(k.at(0).at(0), "K", kLeastFocal_px, kMost_px);
  i.fy = numberIn(k.at(1).at(1), "K", kLeastFocal_px, kMost_px);
  i.cx = numberIn(k.at(0).at(2), "K", -kMost_px, kMost_px);
  i.cy = numberIn(k.at(1).at(2), "K", -kMost_px, kMost_px);
  (void)value.at("dist");
  readLens(value, i);
  const Result<Eigen::Isometry3d> pose =
      isometryFromJson(value.at("camera_from_turntable"), file.string(), limits::kPoseReach_mm);
  if (!pose) return pose.error();
  camera.camera_from_turntable = *pose;
  camera.focal_sd_px = numberOr(value, "focal_sd_px", 0.0, 0);
  camera.intrinsics_rms_px = numberOr(value, "intrinsics_rms_px", 0.0, 0);
  camera.marker_inset_px = numberOr(value, "marker_inset_px", 0.0);
  camera.covariance = value.value("covariance", std::vector<double>());
  if (!camera.covariance.empty() && camera.covariance.size() != kParameters * kParameters)
    return Error::unusable(
        message("Camera %1 has a covariance of the wrong size; recalibrate the rig.",
                camera.camera),
        file);
  return camera;
}

}  // namespace

const RigCamera* Rig::find(int camera) const {
  for (const RigCamera& one : cameras)
    if (one.camera == camera) return &one;
  return nullptr;
}

Result<Rig> readRig(const std::filesystem::path& file) {
  const Result<nlohmann::json> json = readJson(file);
  if (!json) return json.error();
  Rig rig;
  try {
    if (json->at("format") != kFormat)
      return Error::unusable(
          message("Another version of Ostraka wrote this rig; recalibrate the rig."), file);
    if (json->contains("unit") && json->at("unit") != "mm")
      return Error::unusable(message("The rig's lengths are not in mm; recalibrate the rig."),
                             file);
    for (const nlohmann::json& value : json->at("cameras")) {
      Result<RigCamera> camera = cameraFromJson(value, file);
      if (!camera) return camera.error();
      if (rig.find(camera->camera) != nullptr)
        return Error::unusable(message("Camera %1 appears twice in the rig.", camera->camera),
                               file);
      rig.cameras.push_back(std::move(*camera));
    }
    for (const nlohmann::json& value : json->at("stops")) {
      const int stop = wholeAt(value, "stop", 0, limits::kRigStops.most);
      if (std::count(rig.stops.begin(), rig.stops.end(), stop) > 0)
        return Error::unusable(
            message("Position %1 appears twice in the rig; recalibrate it.", stop), file);
      if (rig.stops.size() >= limits::kRigPositions.most)
        return Error::unusable(message("The rig has more than %1 positions; recalibrate it.",
                                       limits::kRigPositions.most),
                               file);
      rig.stops.push_back(stop);
      rig.stop_angles_rad.push_back(numberAt(value, "angle_deg", -36000, 36000) * M_PI / 180);
    }
    rig.reprojection_rms_px = numberOr(*json, "reprojection_rms_px", 0.0, 0);
  } catch (const nlohmann::json::exception& refused) {
    return unusableJson(refused, message("Not a rig file (RIG.json); recalibrate the rig."), file);
  }
  if (rig.cameras.empty())
    return Error::unusable(message("The rig has no camera; recalibrate it."), file);
  std::sort(rig.cameras.begin(), rig.cameras.end(),
            [](const RigCamera& a, const RigCamera& b) { return a.camera < b.camera; });
  return rig;
}

Result<void> checkRigOutput(const std::filesystem::path& file) {
  std::error_code failed;
  if (!std::filesystem::exists(file, failed)) return {};
  const Result<nlohmann::json> json = readJson(file);
  if (json && json->is_object() &&
      ((json->contains("cameras") && json->contains("stops")) || json->contains("devices")))
    return {};
  return Error::unusable(
      message("This file already exists and is not a rig; choose another name."), file);
}

Result<void> writeRig(const std::filesystem::path& file, const Rig& rig) {
  nlohmann::ordered_json cameras = nlohmann::ordered_json::array();
  for (const RigCamera& camera : rig.cameras) cameras.push_back(toJson(camera));
  nlohmann::ordered_json stops = nlohmann::ordered_json::array();
  for (std::size_t k = 0; k < rig.stops.size(); ++k)
    stops.push_back({{"stop", rig.stops[k]}, {"angle_deg", rig.stop_angles_rad[k] * 180 / M_PI}});
  nlohmann::ordered_json whole = {{"format", kFormat},
                                  {"unit", "mm"},
                                  {"reprojection_rms_px", rig.reprojection_rms_px},
                                  {"cameras", cameras},
                                  {"stops", stops}};
  if (const Result<void> good = checkRigOutput(file); !good) return good;
  if (const Result<nlohmann::json> there = readJson(file))
    for (const auto& [key, value] : there->items())
      if (!whole.contains(key)) whole[key] = value;
  return writeJson(file, whole);
}

}  // namespace ostraka::rig
