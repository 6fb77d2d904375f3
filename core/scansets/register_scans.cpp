#include "scansets/register_scans.h"

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>
#include <span>

#include "base/message.h"
#include "base/text.h"
#include "cloud/ply.h"
#include "decisions/pair_sides.h"
#include "decisions/scan_folder.h"
#include "files/files.h"
#include "files/json.h"
#include "files/output_place.h"
#include "pairing/common_scale.h"
#include "scansets/register_report.h"
#include "stages/output_folder.h"
#include "stages/publish.h"
#include "stages/run_log.h"

namespace ostraka::scansets {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

PointCloud mergedCloud(const scan::Scan& front, const scan::Scan& back,
                       const registration::Registration& found) {
  PointCloud merged = front.cloud;
  PointCloud other = back.cloud;
  for (Eigen::Vector3f& p : other.points) p *= static_cast<float>(found.scale);
  other = transformed(other, found.front_from_back);
  const bool colors = !front.cloud.colors.empty() && !other.colors.empty();
  merged.points.insert(merged.points.end(), other.points.begin(), other.points.end());
  merged.normals.insert(merged.normals.end(), other.normals.begin(), other.normals.end());
  if (colors) {
    merged.colors.insert(merged.colors.end(), other.colors.begin(), other.colors.end());
  } else {
    merged.colors.clear();
  }
  merged.quality.clear();
  return merged;
}

std::string numberOf(std::size_t i) {
  const std::string digits = std::to_string(i + 1);
  return digits.size() < 2 ? "0" + digits : digits;
}

RegisterSummary summaryOf(const decisions::PairTable& table, const decisions::ScanFolder& fronts,
                          const decisions::ScanFolder& backs) {
  RegisterSummary summary;
  for (std::size_t i = 0; i < table.pairs.size(); ++i) {
    const decisions::SherdPair& pair = table.pairs[i];
    summary.pairs.push_back(
        {numberOf(i), fronts.scans[static_cast<std::size_t>(pair.decision.front)].id,
         backs.scans[static_cast<std::size_t>(pair.decision.back)].id, pair.decision.score,
         pair.decision.margin, pair.registration.fracture_rms_mm,
         pair.registration.fracture_overlap, pair.registration.uncertainty_mm,
         pair.decision.ambiguous(), reasonOf(pair)});
  }
  for (const int f : table.unpaired_front) {
    summary.unpaired_front.push_back(fronts.scans[static_cast<std::size_t>(f)].id);
  }
  for (const int b : table.unpaired_back) {
    summary.unpaired_back.push_back(backs.scans[static_cast<std::size_t>(b)].id);
  }
  summary.warnings = fronts.warnings;
  summary.warnings.insert(summary.warnings.end(), backs.warnings.begin(), backs.warnings.end());
  summary.unusable = fronts.unusable + backs.unusable;
  return summary;
}

struct Paired {
  decisions::PairTable table;
  double mm = 1;  ///< RegisterSummary::mm
};

/// From fronts that were brought to a usual size by the factor to their own unit.
void bringBack(decisions::SherdPair& pair, double factor) {
  registration::Registration& found = pair.registration;
  found.front_from_back.translation() /= factor;
  for (double* length : {&found.fracture_rms_mm, &found.misfit_mm, &found.uncertainty_mm,
                         &found.runner_up_mm, &found.thickness_mm, &pair.contour_rms_mm})
    *length /= factor;
}

/// With scale free, both sides are first brought to one size, the fronts' own where that can be mm
/// (all tolerances are in mm): one scale for the whole batch is known better (0.1 %) than each
/// pair's own could be. BBICP goes on from it with each pair's own, as in its paper.
Result<Paired> paired(const RegisterOptions& options, std::span<const scan::Scan> fronts,
                      std::span<const scan::Scan> backs, Progress& progress, std::stop_token stop) {
  constexpr double kUsual_mm = 45;
  decisions::PairOptions pair_options;
  pair_options.candidates.method = options.pairing;
  pair_options.registration.method = options.registration;
  pair_options.registration.strip.boundary = options.boundary;
  if (options.boundary == registration::Boundary::Paper)
    progress.note(NoteLevel::Info,
                  "registration: these scans have no masks; gaps between neighbours alone tell "
                  "their boundaries");
  pair_options.candidates.threads = options.threads;
  pair_options.threads = options.threads;
  std::vector<scan::Scan> sized_fronts, sized_backs;
  double factor = 1, scale = 1;
  if (options.scale == pairing::Scale::Free) {
    pair_options.registration.free_scale = true;
    const Result<double> found =
        pairing::commonScale(fronts, backs, pair_options.candidates, progress, stop);
    if (!found) return found.error();
    scale = *found;
    progress.note(NoteLevel::Info, "pairing: the fronts are " + std::to_string(scale) +
                                       " times the size of the backs");
    if (const double length = decisions::medianLength(fronts); !decisions::isSherdLength(length)) {
      factor = kUsual_mm / length;
      progress.note(
          NoteLevel::Warning,
          message("The fronts are not in mm: lengths in the result, although labelled mm, are in "
                  "the fronts' own unit."));
    }
    sized_fronts = pairing::scaled(fronts, factor);
    sized_backs = pairing::scaled(backs, scale * factor);
    fronts = sized_fronts;
    backs = sized_backs;
  }
  registration::Constraints constraints;
  if (decisions::standOnPlate(fronts)) constraints.front_support.emplace();
  if (decisions::standOnPlate(backs)) constraints.back_support.emplace();
  Result<decisions::PairTable> table =
      decisions::pairSides(fronts, backs, constraints, pair_options, progress, stop);
  if (!table) return table.error();
  for (decisions::SherdPair& pair : table->pairs) {
    pair.registration.scale *= scale;
    bringBack(pair, factor);
  }
  return Paired{std::move(*table), 1 / factor};
}

}  // namespace

Result<void> RegisterOptions::check() const {
  const auto bad = [](Message what) { return Error::unusable(std::move(what)); };
  if (front.empty())
    return bad(message("No folder of front scans was given; name one with --front DIR."));
  if (back.empty())
    return bad(message("No folder of back scans was given; name one with --back DIR."));
  if (output.empty())
    return bad(message("No output folder was given; name one with --output OUT."));
  return checkOutputPlace(output);
}

int RegisterSummary::ambiguous() const {
  return static_cast<int>(
      std::count_if(pairs.begin(), pairs.end(), [](const Pair& p) { return p.ambiguous; }));
}

bool RegisterSummary::whole() const {
  return unusable == 0 && !pairs.empty() && unpaired_front.empty() && unpaired_back.empty();
}

Result<RegisterSummary> registerScans(const RegisterOptions& options, Progress& progress,
                                      std::stop_token stop) {
  const auto begin = std::chrono::steady_clock::now();
  if (const Result<void> valid = options.check(); !valid) return valid.error();
  progress.begin("pairs", 0.97);
  const Result<decisions::ScanFolder> fronts =
      decisions::readScanFolder(options.front, options.threads);
  if (!fronts) return fronts.error();
  const Result<decisions::ScanFolder> backs =
      decisions::readScanFolder(options.back, options.threads);
  if (!backs) return backs.error();
  for (const decisions::ScanFolder* side : {&*fronts, &*backs})
    for (const Message& warning : side->warnings) progress.note(NoteLevel::Warning, warning);
  if (options.scale == pairing::Scale::Fixed) {
    const Result<void> unit =
        decisions::checkUnit(*fronts, *backs, message("export them in mm, or use --scale free"));
    if (!unit) return unit.error();
  }
  const std::string inputs_hash = sha256(fronts->hash + "back\n" + backs->hash);
  const Result<FolderLock> held = stages::claimOutput(options.output, inputs_hash);
  if (!held) return held.error();
  stages::withdrawResults(options.output);
  stages::removeStaleSherds(options.output, {});

  stages::WarningsKept kept(progress);
  const Result<Paired> found = paired(options, fronts->scans, backs->scans, kept, stop);
  if (!found) return found.error();
  const decisions::PairTable* table = &found->table;
  if (!held->stands()) return stages::outputGone(options.output);

  RegisterSummary summary = summaryOf(*table, *fronts, *backs);
  summary.mm = found->mm;
  summary.warnings.insert(summary.warnings.end(), kept.warnings.begin(), kept.warnings.end());
  for (std::size_t i = 0; i < table->pairs.size(); ++i) {
    if (stop.stop_requested()) return Error::cancelled();
    const decisions::SherdPair& pair = table->pairs[i];
    const PointCloud merged =
        mergedCloud(fronts->scans[static_cast<std::size_t>(pair.decision.front)],
                    backs->scans[static_cast<std::size_t>(pair.decision.back)], pair.registration);
    const fs::path file = options.output / "sherds" / numberOf(i) / "merged.ply";
    if (const Result<void> wrote = writePly(file, merged, "front scan"); !wrote)
      return wrote.error();
  }
  summary.pairs_file = options.output / "pairs.json";
  const ordered_json pairs = toJson(*table, fronts->scans, backs->scans);
  if (const Result<void> wrote = writeJson(summary.pairs_file, pairs); !wrote) return wrote.error();
  summary.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  if (const Result<void> wrote = writeRegisterReport(options.output, summary, *table, fronts->scans,
                                                     backs->scans, inputs_hash);
      !wrote) {
    return wrote.error();
  }
  if (!held->stands()) {
    stages::leaveGoneOutput(options.output);
    return stages::outputGone(options.output);
  }
  return summary;
}

}  // namespace ostraka::scansets
