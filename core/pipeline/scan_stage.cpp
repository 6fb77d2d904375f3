// Scans: one cloud for each sherd of a side, as found and as people joined and cut them.
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "cloud/ply.h"
#include "decisions/piece_edits.h"
#include "files/json_message.h"
#include "pipeline/chain.h"
#include "scan/fracture.h"
#include "scan/split.h"

namespace ostraka::pipeline {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

using Scans = Staged<std::vector<scan::Scan>>;

Result<ordered_json> writeScans(const fs::path& folder, const std::vector<scan::Scan>& scans,
                                const std::string& frame) {
  ordered_json points = ordered_json::object();
  for (const scan::Scan& scan : scans) {
    const Result<void> written = writePly(folder / (scan.id + ".ply"), scan.cloud, frame);
    if (!written) return written.error();
    points[scan.id] = scan.cloud.size();
  }
  return points;
}

Result<Scans> readScans(const fs::path& folder, const stages::StageRecord& record) {
  std::vector<scan::Scan> scans;
  for (const auto& [id, points] : record.notes.figures.at("points").items()) {
    Result<PointCloud> points_of = readPlyCloud(folder / (id + ".ply"));
    if (!points_of) return points_of.error();
    scan::Scan scan{id, std::move(*points_of), {}, Eigen::Vector3d::UnitZ()};
    scan.fracture = scan::findFracture(scan.cloud, scan.up);
    scans.push_back(std::move(scan));
  }
  return Scans{std::move(scans), record};
}

Result<Scans> editStage(const Run& run, batch::Side side, const Scans& found) {
  const std::string frame = std::string("plate_") + batch::name(side);
  decisions::Decisions edits;
  for (const decisions::PairDecision& d : run.decisions)
    if (decisions::hasEdits({d}, side)) edits.push_back(d);
  const auto work = [&](const fs::path& folder) -> Result<stages::StageNotes> {
    const decisions::EditedPieces edited =
        decisions::editedPieces(found.value, side, edits, run.photographsOf(side));
    const Result<ordered_json> points = writeScans(folder, edited.scans, frame);
    if (!points) return points.error();
    return stages::StageNotes{{{"points", *points},
                               {"doubtful", found.record.notes.figures.value(
                                                "doubtful", ordered_json(ordered_json::array()))}},
                              edited.warnings};
  };
  const std::string name = scanFolder(run, side);
  const Result<stages::StageRecord> record = runStage(run, name,
                                                      {{"scans", found.record.outputs_hash},
                                                       {"edits", toJson(edits)},
                                                       {"photographs", run.photographsOf(side)}},
                                                      work);
  if (!record) return record.error();
  return readScans(run.work / name, *record);
}

// f001, f002 ... or b001 ...
std::string importedName(batch::Side side, std::size_t index) {
  const std::string digits = std::to_string(index + 1);
  return (side == batch::Side::Front ? "f" : "b") +
         std::string(3 - std::min<std::size_t>(3, digits.size()), '0') + digits;
}

// As on a plate: the face up, the lowest point on it. Where it lies there has no meaning.
PointCloud laidFlat(const scan::Scan& scan) {
  Eigen::Isometry3d turned = Eigen::Isometry3d::Identity();
  turned.linear() =
      Eigen::Quaterniond::FromTwoVectors(scan.up, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  PointCloud cloud = transformed(scan.cloud, turned);
  Eigen::Vector3f low = cloud.points.front(), high = low;
  for (const Eigen::Vector3f& p : cloud.points) low = low.cwiseMin(p), high = high.cwiseMax(p);
  const Eigen::Vector3f corner((low.x() + high.x()) / 2, (low.y() + high.y()) / 2, low.z());
  for (Eigen::Vector3f& p : cloud.points) p -= corner;
  return cloud;
}

// Beside each other, as on a plate: a decision knows its scan by its place.
void layApart(std::vector<scan::Scan>& scans) {
  float longest = 0;
  for (const scan::Scan& scan : scans)
    for (const Eigen::Vector3f& p : scan.cloud.points)
      longest = std::max(longest, 2 * p.head<2>().cwiseAbs().maxCoeff());
  const auto columns = static_cast<std::size_t>(std::ceil(std::sqrt(scans.size())));
  const float cell_mm = 1.2F * longest + 10;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    const Eigen::Vector3f place(static_cast<float>(i % columns) * cell_mm,
                                static_cast<float>(i / columns) * cell_mm, 0);
    for (Eigen::Vector3f& p : scans[i].cloud.points) p += place;
  }
}

}  // namespace

Result<Scans> importStage(const Run& run, batch::Side side, const decisions::ScanFolder& folder) {
  const std::string name = std::string("scans_") + batch::name(side);
  const bool on_plate = run.batch.plate.has_value();
  const auto work = [&](const fs::path& into) -> Result<stages::StageNotes> {
    std::vector<scan::Scan> scans = folder.scans;
    ordered_json files = ordered_json::object();
    for (std::size_t i = 0; i < scans.size(); ++i) {
      const std::string id = importedName(side, i);
      files[id] = folder.files[i].filename().string();
      scans[i].id = id;
      if (!on_plate) scans[i].cloud = laidFlat(scans[i]);
    }
    if (!on_plate) layApart(scans);
    const Result<ordered_json> points =
        writeScans(into, scans, std::string("plate_") + batch::name(side));
    if (!points) return points.error();
    return stages::StageNotes{{{"points", *points}, {"files", files}}, {}};
  };
  const Result<stages::StageRecord> record = runStage(
      run, name, {{"imported", folder.hash}, {"on_plate", on_plate}, {"apart", true}}, work);
  if (!record) return record.error();
  Result<Scans> found = readScans(run.work / name, *record);
  if (!found || !decisions::hasEdits(run.decisions, side)) return found;
  return editStage(run, side, *found);
}

std::string scanFolder(const Run& run, batch::Side side) {
  return (decisions::hasEdits(run.decisions, side) ? "pieces_" : "scans_") +
         std::string(batch::name(side));
}

Result<Scans> scanStage(const Run& run, batch::Side side, const Staged<Poses>& poses,
                        const Staged<Masks>& masks, const Staged<PointCloud>& cloud) {
  const bool relative = !poses.value.has_scale;
  const std::string name = std::string("scans_") + batch::name(side);
  const std::string frame = std::string("plate_") + batch::name(side);
  const auto work = [&](const fs::path& folder) -> Result<stages::StageNotes> {
    scan::SplitOptions options;
    options.ground = poses.value.bends[sideIndex(side)];
    options.lengths = relative ? scan::Lengths::Relative : scan::Lengths::Millimetres;
    const std::vector<rig::PosedImage> images = poses.value.of(side);
    options.images = images;
    options.masks = masks.value;
    const Result<scan::SplitResult> split =
        scan::splitScans(cloud.value, side, options, run.progress);
    if (!split) return split.error();
    const Result<ordered_json> points = writeScans(folder, split->scans, frame);
    if (!points) return points.error();
    return stages::StageNotes{{{"points", *points}, {"doubtful", toJson(split->doubtful)}},
                              split->warnings};
  };
  const Result<stages::StageRecord> record = runStage(run, name,
                                                      {{"cloud", cloud.record.outputs_hash},
                                                       {"masks", masks.record.outputs_hash},
                                                       {"relative", relative}},
                                                      work);
  if (!record) return record.error();
  Result<Scans> found = readScans(run.work / name, *record);
  if (!found || !decisions::hasEdits(run.decisions, side)) return found;
  return editStage(run, side, *found);
}

}  // namespace ostraka::pipeline
