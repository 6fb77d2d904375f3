#include "api/register.h"

#include <filesystem>

#include "api/checked.h"
#include "base/message.h"
#include "decisions/pair_sides.h"
#include "decisions/scan_folder.h"
#include "scan/fracture.h"

namespace ostraka::api {
namespace {

// As a folder of scans that were read; their ids are what messages call them.
Result<decisions::ScanFolder> asScans(std::span<const PointCloud> clouds, const std::string& side) {
  constexpr std::size_t kFewestPoints = 100;
  decisions::ScanFolder folder;
  for (std::size_t i = 0; i < clouds.size(); ++i) {
    const std::string id = side + " " + std::to_string(i);
    Result<PointCloud> cloud = checkedCloud(clouds[i], id);
    if (!cloud) return cloud.error();
    if (cloud->size() < kFewestPoints)
      return Error{ErrorCode::NotEnough,
                   message("The scan has fewer than 100 points; rescan this side."), id};
    const Eigen::Vector3d up = scan::estimateUp(*cloud);
    folder.scans.push_back({id, std::move(*cloud), {}, up});
    folder.files.push_back(std::filesystem::path(side) / std::to_string(i));
  }
  if (folder.scans.empty())
    return Error{ErrorCode::NotEnough,
                 message("No scan of this side was given; give at least one."), side};
  return folder;
}

Result<RegisteredScans> registered(std::span<const PointCloud> fronts,
                                   std::span<const PointCloud> backs, int threads,
                                   Progress& progress, const std::stop_token& stop) {
  const Result<decisions::ScanFolder> front = asScans(fronts, "front");
  if (!front) return front.error();
  const Result<decisions::ScanFolder> back = asScans(backs, "back");
  if (!back) return back.error();
  if (const Result<void> unit = decisions::checkUnit(*front, *back, message("give them in mm"));
      !unit)
    return unit.error();
  decisions::PairOptions options;
  options.candidates.threads = options.threads = threads;
  registration::Constraints constraints;
  if (decisions::standOnPlate(front->scans)) constraints.front_support.emplace();
  if (decisions::standOnPlate(back->scans)) constraints.back_support.emplace();
  const Result<decisions::PairTable> table =
      decisions::pairSides(front->scans, back->scans, constraints, options, progress, stop);
  if (!table) return table.error();
  RegisteredScans result{{}, table->unpaired_front, table->unpaired_back};
  for (const decisions::SherdPair& pair : table->pairs) {
    const registration::Registration& found = pair.registration;
    result.pairs.push_back({pair.decision.front, pair.decision.back, found.front_from_back,
                            *pair.decision.score, found.fracture_rms_mm, found.fracture_overlap,
                            found.uncertainty_mm, pair.decision.ambiguous(), reasonOf(pair)});
  }
  return result;
}

}  // namespace

Result<RegisteredScans> registerScans(std::span<const PointCloud> fronts,
                                      std::span<const PointCloud> backs, int threads,
                                      Progress& progress, std::stop_token stop) {
  return withoutExceptions([&] { return registered(fronts, backs, threads, progress, stop); });
}

}  // namespace ostraka::api
