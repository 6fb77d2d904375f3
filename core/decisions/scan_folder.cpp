#include "decisions/scan_folder.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <string_view>
#include <system_error>

#include "base/median.h"
#include "base/message.h"
#include "base/parallel.h"
#include "base/text.h"
#include "cloud/ply.h"
#include "files/files.h"
#include "scan/fracture.h"

namespace ostraka::decisions {
namespace {

namespace fs = std::filesystem;

// macOS leaves a hidden ._a.ply beside each a.ply on foreign disks.
bool isPly(const fs::path& file) {
  return lowerCase(file.extension().string()) == ".ply" &&
         !file.filename().string().starts_with('.');
}

// Bytes that are of no character as \xFF.
std::string spelled(std::string_view name) {
  constexpr std::size_t kMostBytes = 4;  // of a character
  std::string text;
  for (std::size_t at = 0; at < name.size();) {
    std::size_t bytes = 1;
    while (bytes <= kMostBytes && !isUtf8(name.substr(at, bytes))) ++bytes;
    const bool is_character = bytes <= kMostBytes;
    text += is_character ? std::string(name.substr(at, bytes))
                         : formatted("\\x%02X", static_cast<unsigned char>(name[at]));
    at += is_character ? bytes : 1;
  }
  return text;
}

/// The *.ply of a folder in the order of their names.
Result<std::vector<fs::path>> plyFiles(const fs::path& folder) {
  std::error_code failed;
  std::vector<fs::path> files;
  for (fs::directory_iterator it(folder, failed), end; !failed && it != end; it.increment(failed)) {
    if (isPly(it->path())) files.push_back(it->path());
  }
  if (failed) {
    return Error::unusable(message("The folder cannot be read; choose a folder of PLY files."),
                           folder.string());
  }
  if (files.empty()) {
    return Error::unusable(
        message("This folder contains no PLY files; each sherd's scan must be one PLY file."),
        folder.string());
  }
  std::sort(files.begin(), files.end());
  // Results name scans by their files, in JSON: two such names would become one.
  for (const fs::path& file : files)
    if (const std::string name = file.filename().string(); !isUtf8(name))
      return Error::unusable(
          message(
              "The name of the file %1 is not UTF-8, and results could not tell it from others; "
              "rename it, then try again.",
              spelled(name)),
          folder.string());
  return files;
}

// Points that are no measurement: several at 0, 0, 0, where some scanners put what they did not
// see, and points far outside of all others. A few of them would decide where up is.
std::vector<int> measuredPoints(const PointCloud& cloud) {
  constexpr double kFar = 4;        // times the distance of three quarters: 3.5 radii of a disc
  constexpr double kMostFar = 0.1;  // more are part of the shape
  std::vector<int> kept, near;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (!cloud.points[i].isZero(0)) kept.push_back(static_cast<int>(i));
  if (kept.size() + 1 >= cloud.size() || kept.empty()) {
    kept.resize(cloud.size());
    std::iota(kept.begin(), kept.end(), 0);
  }
  if (kept.empty()) return kept;
  Eigen::Vector3d centre;
  std::vector<double> values(kept.size());
  const auto point = [&](std::size_t i) -> Eigen::Vector3d {
    return cloud.points[static_cast<std::size_t>(kept[i])].cast<double>();
  };
  for (int axis = 0; axis < 3; ++axis) {
    for (std::size_t i = 0; i < kept.size(); ++i) values[i] = point(i)[axis];
    centre[axis] = rankedAt(values, 0.5);
  }
  for (std::size_t i = 0; i < kept.size(); ++i) values[i] = (point(i) - centre).norm();
  const double far = kFar * rankedAt(values, 0.75);
  for (std::size_t i = 0; i < kept.size(); ++i)
    if (values[i] <= far) near.push_back(kept[i]);
  const double lost = static_cast<double>(kept.size() - near.size());
  return lost > kMostFar * static_cast<double>(kept.size()) ? kept : near;
}

// Coordinates are kept with 24 bits: at a thousand lengths of 100 mm they are rounded to 0.006 mm.
constexpr double kMostLengthsAway = 1000;

double awayFromOrigin(const PointCloud& cloud) {
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& p : cloud.points) box.extend(p);
  const double length = box.sizes().maxCoeff();
  return length > 0 ? box.center().norm() / length : 0;
}

Message notFinite(const fs::path& file, std::size_t n) {
  return n == 1 ? message("%1: 1 point without finite coordinates was left out; check the export.",
                          file)
                : message(
                      "%1: %2 points without finite coordinates were left out; check the "
                      "export.",
                      file, n);
}

Message farAway(const fs::path& file, std::size_t n) {
  return n == 1 ? message(
                      "%1: 1 point far from all others, or at 0, 0, 0, was left out; check the "
                      "export.",
                      file)
                : message(
                      "%1: %2 points far from all others, or at 0, 0, 0, were left out; check "
                      "the export.",
                      file, n);
}

Message withoutDirection(const fs::path& file, std::size_t n) {
  return n == 1
             ? message("%1: 1 point whose normal has no direction was left out; check the export.",
                       file)
             : message(
                   "%1: %2 points whose normals have no direction were left out; check the "
                   "export.",
                   file, n);
}

Result<scan::Scan> readScan(std::string_view bytes, const fs::path& file, Message& warning) {
  Result<PlyContents> contents = parsePly(bytes, file.string());
  if (!contents) return contents.error();
  if (contents->dropped_not_finite > 0) {
    warning = notFinite(file, contents->dropped_not_finite);
  }
  scan::Scan scan;
  scan.id = file.stem().string();
  scan.cloud.points = std::move(contents->mesh.vertices);
  scan.cloud.normals = std::move(contents->mesh.normals);
  scan.cloud.colors = std::move(contents->mesh.colors);
  const std::vector<int> measured = measuredPoints(scan.cloud);
  if (measured.size() < scan.cloud.size()) {
    const Message far = farAway(file, scan.cloud.size() - measured.size());
    warning = warning.empty() ? far : inOne(warning, far);
    scan.cloud = subset(scan.cloud, measured);
  }
  scan.cloud = withoutRepeats(std::move(scan.cloud));
  const std::size_t all = scan.cloud.size();
  scan.cloud = oriented(std::move(scan.cloud));
  if (scan.cloud.size() < all) {
    const Message lost = withoutDirection(file, all - scan.cloud.size());
    warning = warning.empty() ? lost : inOne(warning, lost);
  }
  if (scan.cloud.size() < 100) {
    return Error{ErrorCode::NotEnough,
                 message("The scan has fewer than 100 points; rescan this side."), file.string()};
  }
  if (!scan.cloud.hasNormals()) {
    return Error::unusable(message("The scan has no normals; export it with nx, ny and nz."),
                           file.string());
  }
  if (const double lengths = awayFromOrigin(scan.cloud); lengths > kMostLengthsAway) {
    return Error::unusable(
        message("The scan is %1 times its length away from the origin, so its coordinates are "
                "rounded; move it to the origin and export it again.",
                decimal(lengths, 0)),
        file.string());
  }
  scan.up = scan::estimateUp(scan.cloud);
  return scan;
}

constexpr double kShortest_mm = 8, kLongest_mm = 400;  // of a batch's middle sherd
constexpr double kMostApart = 3;  // one side's middle sherd may be another one than the other's

Decimal lengthValue(double length) {
  return decimal(length, length < 1 ? 3 : length < 100 ? 1 : 0);
}

// The unit in which they would be as long as sherds are.
Message wrongUnit(double length, const Message& what_to_do) {
  struct Unit {
    Template<0> name;
    double mm;
  };
  constexpr std::array<Unit, 3> kUnits = {{{translatable<0>("centimetres"), 10},
                                           {translatable<0>("metres"), 1000},
                                           {translatable<0>("micrometres"), 0.001}}};
  for (const Unit& unit : kUnits)
    if (isSherdLength(length * unit.mm))
      return message("The median length of these scans is %1 mm; their unit seems to be %2: %3.",
                     lengthValue(length), message(unit.name), what_to_do);
  return message("The median length of these scans is %1 mm; no sherds are of that size: %2.",
                 lengthValue(length), what_to_do);
}

}  // namespace

Result<ScanFolder> readScanFolder(const fs::path& folder, int threads) {
  const Result<std::vector<fs::path>> files = plyFiles(folder);
  if (!files) return files.error();
  std::vector<std::optional<Result<scan::Scan>>> read(files->size());
  std::vector<Message> warnings(files->size());
  std::vector<std::string> hashes(files->size());
  parallelFor(files->size(), threads, [&](std::size_t i) {
    const Result<std::string> bytes = readFile((*files)[i]);
    hashes[i] = (*files)[i].filename().string() + ":" + (bytes ? sha256(*bytes) : "unreadable");
    read[i] = bytes ? readScan(*bytes, (*files)[i], warnings[i]) : bytes.error();
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
    return Error::unusable(message("None of the scans can be used: %1", side.warnings.front()),
                           folder.string());
  }
  return side;
}

double medianLength(std::span<const scan::Scan> scans) {
  std::vector<double> lengths;
  for (const scan::Scan& scan : scans) {
    Eigen::Vector3d low = scan.cloud.points.front().cast<double>(), high = low;
    for (const Eigen::Vector3f& p : scan.cloud.points) {
      low = low.cwiseMin(p.cast<double>());
      high = high.cwiseMax(p.cast<double>());
    }
    lengths.push_back((high - low).maxCoeff());
  }
  return medianOf(lengths);
}

bool isSherdLength(double mm) {
  return mm >= kShortest_mm && mm <= kLongest_mm;
}

Result<void> checkUnit(const ScanFolder& fronts, const ScanFolder& backs,
                       const Message& what_to_do) {
  const double front = medianLength(fronts.scans), back = medianLength(backs.scans);
  for (const auto& [side, length] : {std::pair(&fronts, front), std::pair(&backs, back)}) {
    if (isSherdLength(length)) continue;
    return Error::unusable(wrongUnit(length, what_to_do),
                           side->files.front().parent_path().string());
  }
  if (std::max(front, back) > kMostApart * std::min(front, back))
    return Error::unusable(message("The median length of the fronts is %1 mm, of the backs %2 mm, "
                                   "so their units differ: %3.",
                                   lengthValue(front), lengthValue(back), what_to_do),
                           backs.files.front().parent_path().string());
  return {};
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

}  // namespace ostraka::decisions
