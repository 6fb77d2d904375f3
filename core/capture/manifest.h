#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "batch/batch.h"
#include "capture/shot_checks.h"

namespace ostraka::capture {

struct ShotName {
  int stop = 0, camera = 0;
  bool operator==(const ShotName&) const = default;
};

/// One photograph that was taken, kept or set aside.
struct ManifestEntry {
  batch::Side side = batch::Side::Front;
  int camera = 0, stop = 0;
  int take = 1;                  ///< of this side, camera and stop
  std::string file;              ///< relative to the batch
  std::vector<std::string> raw;  ///< further files of the shot, relative to the batch
  std::string sha256;            ///< of the photograph's bytes
  std::uint64_t bytes = 0;
  std::string camera_model, camera_serial;
  std::map<std::string, std::string> settings;  ///< of the camera: "exposure", "1/8"
  std::string taken_at;                         ///< UTC, 2026-11-21T18:30:00Z
  double angle_deg = 0;                         ///< of the stop
  std::optional<double> angle_seen_deg;
  double sharpness = 0;
  int markers_seen = 0, sherds = 0;
  bool cut_off = false;               ///< a sherd touches the picture's edge
  std::vector<std::string> problems;  ///< in English; a kept photograph may have some
  bool checked = false;               ///< false: on disk, but not yet looked at
  bool used = true;
  std::string reason;  ///< why it is not used
};

/// manifest.json in the batch's folder: what was photographed, and that it is still the same.
struct Manifest {
  int stops = 0, cameras = 0;  ///< 0: nothing was taken yet
  std::vector<ManifestEntry> entries;

  ManifestEntry* find(batch::Side side, int stop, int camera);  ///< the one in use, or nullptr
  const ManifestEntry* find(batch::Side side, int stop, int camera) const;
  int takes(batch::Side side, int stop, int camera) const;  ///< highest number so far
};

/// A folder without a manifest gives an empty one. Errors: UnusableInput.
Result<Manifest> readManifest(const std::filesystem::path& batch);
Result<void> writeManifest(const std::filesystem::path& batch, const Manifest& manifest);

}  // namespace ostraka::capture
