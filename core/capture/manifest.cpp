#include "capture/manifest.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/limits.h"
#include "base/message.h"
#include "files/contained_path.h"
#include "files/json.h"
#include "files/json_numbers.h"

namespace ostraka::capture {
namespace {

constexpr const char* kManifestFormat = "ostraka-capture/1";

std::filesystem::path manifestFile(const std::filesystem::path& batch) {
  return batch / "manifest.json";
}

nlohmann::ordered_json toJson(const ManifestEntry& e) {
  nlohmann::ordered_json json = {{"side", batch::name(e.side)},
                                 {"camera", e.camera},
                                 {"stop", e.stop},
                                 {"take", e.take},
                                 {"file", e.file},
                                 {"sha256", e.sha256},
                                 {"bytes", e.bytes},
                                 {"camera_model", e.camera_model},
                                 {"camera_serial", e.camera_serial},
                                 {"taken_at", e.taken_at},
                                 {"angle_deg", e.angle_deg},
                                 {"angle_seen_deg", nullptr},
                                 {"edge_width_px", e.sharpness},
                                 {"markers_seen", e.markers_seen},
                                 {"sherds_seen", e.sherds},
                                 {"sherd_cut_off", e.cut_off},
                                 {"problems", e.problems},
                                 {"checked", e.checked},
                                 {"used", e.used}};
  if (e.angle_seen_deg) json["angle_seen_deg"] = *e.angle_seen_deg;
  if (!e.settings.empty()) json["settings"] = e.settings;
  if (!e.raw.empty()) json["raw"] = e.raw;
  if (!e.reason.empty()) json["reason"] = e.reason;
  return json;
}

// Throws nlohmann's exceptions; the caller words them.
ManifestEntry entryFromJson(const nlohmann::json& json) {
  ManifestEntry e;
  e.side = json.at("side").get<std::string>() == "back" ? batch::Side::Back : batch::Side::Front;
  e.camera = wholeAt(json, "camera", 0, limits::kRigCameras.most);
  e.stop = wholeAt(json, "stop", 0, limits::kRigStops.most);
  e.take = wholeAt(json, "take", 0);
  e.file = json.at("file").get<std::string>();
  e.sha256 = json.at("sha256").get<std::string>();
  e.bytes = wholeIn(json.at("bytes"), "bytes", 0, INT64_MAX);
  e.camera_model = json.value("camera_model", "");
  e.camera_serial = json.value("camera_serial", "");
  e.settings = json.value("settings", std::map<std::string, std::string>{});
  e.taken_at = json.value("taken_at", "");
  e.angle_deg = numberOr(json, "angle_deg", 0.0);
  if (json.contains("angle_seen_deg") && json["angle_seen_deg"].is_number())
    e.angle_seen_deg = numberAt(json, "angle_seen_deg");
  e.sharpness = numberOr(json, "edge_width_px", 0.0);
  e.markers_seen = wholeOr(json, "markers_seen", 0);
  e.sherds = wholeOr(json, "sherds_seen", 0);
  e.cut_off = json.value("sherd_cut_off", false);
  e.problems = json.value("problems", std::vector<std::string>{});
  e.raw = json.value("raw", std::vector<std::string>{});
  e.checked = json.value("checked", false);
  e.used = json.at("used").get<bool>();
  e.reason = json.value("reason", "");
  return e;
}

// Names stay within the batch's folder.
bool isOwnName(const std::string& file) {
  return ContainedPath::parse(file).has_value();
}

}  // namespace

const ManifestEntry* Manifest::find(batch::Side side, int stop, int camera) const {
  for (const ManifestEntry& e : entries)
    if (e.used && e.side == side && e.stop == stop && e.camera == camera) return &e;
  return nullptr;
}

ManifestEntry* Manifest::find(batch::Side side, int stop, int camera) {
  return const_cast<ManifestEntry*>(std::as_const(*this).find(side, stop, camera));
}

int Manifest::takes(batch::Side side, int stop, int camera) const {
  int most = 0;
  for (const ManifestEntry& e : entries)
    if (e.side == side && e.stop == stop && e.camera == camera) most = std::max(most, e.take);
  return most;
}

Result<Manifest> readManifest(const std::filesystem::path& batch) {
  const std::filesystem::path file = manifestFile(batch);
  Manifest manifest;
  std::error_code absent;
  if (!std::filesystem::exists(file, absent)) return manifest;
  const Result<nlohmann::json> json = readJson(file);
  if (!json) return json.error();
  const Error unusable = Error::unusable(
      message("Not an Ostraka photograph list; choose another folder for the batch."),
      file.string());
  try {
    if (json->at("format") != kManifestFormat) return unusable;
    manifest.stops = wholeAt(*json, "stops", 0, limits::kRigStops.most);
    manifest.cameras = wholeAt(*json, "cameras", 0, limits::kRigCameras.most);
    for (const nlohmann::json& entry : json->at("photographs")) {
      manifest.entries.push_back(entryFromJson(entry));
      const ManifestEntry& read = manifest.entries.back();
      if (!isOwnName(read.file) || !std::all_of(read.raw.begin(), read.raw.end(), isOwnName))
        return unusable;
    }
  } catch (const nlohmann::json::exception& refused) {
    return unusableJson(refused, unusable.what, unusable.where);
  }
  return manifest;
}

Result<void> writeManifest(const std::filesystem::path& batch, const Manifest& manifest) {
  std::vector<const ManifestEntry*> sorted;
  for (const ManifestEntry& e : manifest.entries) sorted.push_back(&e);
  std::stable_sort(sorted.begin(), sorted.end(), [](const auto* a, const auto* b) {
    return std::tuple(a->side, a->camera, a->stop, a->take) <
           std::tuple(b->side, b->camera, b->stop, b->take);
  });
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const ManifestEntry* e : sorted) list.push_back(toJson(*e));
  return writeJson(manifestFile(batch), {{"format", kManifestFormat},
                                         {"stops", manifest.stops},
                                         {"cameras", manifest.cameras},
                                         {"photographs", list}});
}

}  // namespace ostraka::capture
