#include "pipeline/scan_folder.h"

#include <algorithm>
#include <optional>
#include <system_error>

#include "base/files.h"
#include "base/parallel.h"
#include "base/text.h"
#include "cloud/ply.h"
#include "scan/rim.h"

namespace ostraka::pipeline {
namespace {

namespace fs = std::filesystem;

bool isPly(const fs::path& file) {
  return lowerCase(file.extension().string()) == ".ply";
}

/// The *.ply of a folder in the order of their names.
Result<std::vector<fs::path>> plyFiles(const fs::path& folder) {
  std::error_code failed;
  std::vector<fs::path> files;
  for (fs::directory_iterator it(folder, failed), end; !failed && it != end; it.increment(failed)) {
    if (isPly(it->path())) files.push_back(it->path());
  }
  if (failed) {
    return Error{ErrorCode::UnusableInput, "The folder cannot be read; name a folder of PLY files.",
                 folder.string()};
  }
  if (files.empty()) {
    return Error{ErrorCode::UnusableInput,
                 "There is no PLY file in this folder; each sherd's scan must be one PLY file.",
                 folder.string()};
  }
  std::sort(files.begin(), files.end());
  return files;
}

Result<scan::Scan> readScan(const fs::path& file, std::string& warning) {
  const Result<std::string> bytes = readFile(file);
  if (!bytes) return bytes.error();
  Result<PlyContents> contents = parsePly(*bytes, file.string());
  if (!contents) return contents.error();
  if (contents->dropped_not_finite > 0) {
    warning = file.string() + ": " + std::to_string(contents->dropped_not_finite) +
              " points without finite coordinates were left out; check the export.";
  }
  scan::Scan scan;
  scan.id = file.stem().string();
  scan.cloud.points = std::move(contents->mesh.vertices);
  scan.cloud.normals = std::move(contents->mesh.normals);
  scan.cloud.colors = std::move(contents->mesh.colors);
  if (scan.cloud.size() < 100) {
    return Error{ErrorCode::NotEnough, "The scan has fewer than 100 points; scan this side again.",
                 file.string()};
  }
  if (!scan.cloud.hasNormals()) {
    return Error{ErrorCode::UnusableInput, "The scan has no normals; export it with nx, ny and nz.",
                 file.string()};
  }
  scan.up = scan::estimateUp(scan.cloud);
  return scan;
}

}  // namespace

Result<ScanFolder> readScanFolder(const fs::path& folder, int threads) {
  const Result<std::vector<fs::path>> files = plyFiles(folder);
  if (!files) return files.error();
  std::vector<std::optional<Result<scan::Scan>>> read(files->size());
  std::vector<std::string> warnings(files->size()), hashes(files->size());
  parallelFor(files->size(), threads, [&](std::size_t i) {
    const Result<std::string> bytes = readFile((*files)[i]);
    hashes[i] = (*files)[i].filename().string() + ":" + (bytes ? sha256(*bytes) : "unreadable");
    read[i] = readScan((*files)[i], warnings[i]);
  });
  ScanFolder side;
  for (std::size_t i = 0; i < read.size(); ++i) {
    side.hash += hashes[i] + "\n";
    if (!warnings[i].empty()) side.warnings.push_back(warnings[i]);
    Result<scan::Scan>& scan = *read[i];
    if (scan) {
      side.scans.push_back(std::move(*scan));
      side.files.push_back((*files)[i]);
    } else {
      side.warnings.push_back(scan.error().sentence());
      ++side.unusable;
    }
  }
  if (side.scans.empty()) {
    return Error{ErrorCode::UnusableInput,
                 "None of the scans can be used: " + side.warnings.front(), folder.string()};
  }
  return side;
}

bool holdsScans(const fs::path& batch) {
  std::error_code error;
  for (fs::directory_iterator at(batch / "front", error), end; !error && at != end;
       at.increment(error))
    if (isPly(at->path())) return true;
  return false;
}

bool standOnPlate(std::span<const scan::Scan> scans) {
  return std::all_of(scans.begin(), scans.end(), [](const scan::Scan& scan) {
    std::vector<float> heights;
    for (const Eigen::Vector3f& p : scan.cloud.points) heights.push_back(p.z());
    const auto low = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 200);
    std::nth_element(heights.begin(), low, heights.end());
    return *low > -0.3f && *low < 4.0f && scan.up.z() > 0.8;
  });
}

}  // namespace ostraka::pipeline
