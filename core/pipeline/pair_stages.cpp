// Which back belongs to which front: fractures compared, then what people decided.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/message.h"
#include "decisions/decided_pairs.h"
#include "files/files.h"
#include "files/json.h"
#include "files/json_numbers.h"
#include "files/json_text.h"
#include "pipeline/chain.h"
#include "stages/run_log.h"

namespace ostraka::pipeline {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;
using Scans = Staged<std::vector<scan::Scan>>;

std::vector<registration::SilhouetteView> silhouettes(const std::vector<rig::PosedImage>& images,
                                                      const Masks& masks) {
  std::vector<registration::SilhouetteView> views;
  for (std::size_t i = 0; i < images.size(); ++i) views.push_back({images[i], masks[i]});
  return views;
}

int indexOf(const std::vector<scan::Scan>& scans, const std::string& id) {
  for (std::size_t i = 0; i < scans.size(); ++i)
    if (scans[i].id == id) return static_cast<int>(i);
  return -1;
}

Result<Pairs> readPairs(const fs::path& file, const std::vector<scan::Scan>& fronts,
                        const std::vector<scan::Scan>& backs) {
  const Result<std::string> text = readFile(file);
  if (!text) return text.error();
  Pairs pairs;
  pairs.json = orderedJsonOrDiscarded(*text);
  try {
    for (const ordered_json& p : pairs.json.at("pairs")) {
      const Result<Eigen::Isometry3d> pose =
          isometryFromJson(p.at("T_front_from_back"), file.string());
      if (!pose) return pose.error();
      pairs.pairs.push_back(
          {indexOf(fronts, p.at("front")),
           indexOf(backs, p.at("back")),
           numberOrNone(p, "score"),
           numberOrNone(p, "margin"),
           p.at("ambiguous"),
           p.at("check_failed"),
           p.at("reason"),
           *pose,
           p.at("fracture_rms_mm").is_null() ? 0.0 : numberAt(p, "fracture_rms_mm"),
           p.at("fracture_overlap"),
           p.at("uncertainty_mm"),
           {},
           {}});
      if (p.contains("decided")) {
        pairs.pairs.back().decided_by = p["decided"].at("by");
        pairs.pairs.back().decided_at = p["decided"].at("at");
      }
      if (pairs.pairs.back().front < 0 || pairs.pairs.back().back < 0)
        return Error::unusable(
            message("A pair refers to a scan that does not exist; delete this file and reprocess "
                    "the batch."),
            file.string());
    }
    pairs.unpaired_front = pairs.json.at("unpaired_front").get<std::vector<std::string>>();
    pairs.unpaired_back = pairs.json.at("unpaired_back").get<std::vector<std::string>>();
    if (pairs.json.contains("set_aside"))
      pairs.set_aside = pairs.json["set_aside"].get<std::vector<std::string>>();
    if (pairs.json.contains("reshoot"))
      pairs.reshoot = pairs.json["reshoot"].get<std::vector<std::string>>();
  } catch (const nlohmann::json::exception&) {
    return Error::unusable(message("Not a pair table; delete it and reprocess the batch."),
                           file.string());
  }
  return pairs;
}

decisions::PairOptions optionsOf(const Run& run) {
  decisions::PairOptions options;
  options.threads = run.options.threads;
  options.candidates.threads = run.options.threads;
  options.candidates.method = run.options.pairing;
  options.registration.method = run.options.registration;
  options.registration.strip.boundary = run.options.boundary;
  // Sherds are turned over beside where they lay on a plate; over a sheet they may come anywhere.
  const bool beside = run.batch.plate && run.batch.way == batch::Way::Rig;
  options.place = beside ? decisions::PlaceEvidence::Weak : decisions::PlaceEvidence::None;
  return options;
}

Result<void> writePairs(const fs::path& folder, const decisions::PairTable& table,
                        const decisions::CandidateTable& candidates) {
  ordered_json pairs = toJson(table, candidates.fronts, candidates.backs);
  if (!candidates.has_scale) pairs["has_scale"] = false;
  return writeJson(folder / "pairs.json", pairs);
}

// Where the scans lie, and what photographs they come from.
void nameSources(const Run& run, batch::Side side, std::vector<decisions::ScanRef>& scans,
                 std::vector<std::string>& files) {
  for (decisions::ScanRef& scan : scans) {
    scan.photographs = run.photographsOf(side);
    files.push_back(scanFolder(run, side) + "/" + scan.id + ".ply");
  }
}

decisions::Decisions aboutPartners(const decisions::Decisions& standing) {
  decisions::Decisions kept;
  for (const decisions::PairDecision& d : standing)
    if (d.kind == decisions::DecisionKind::Pair || d.kind == decisions::DecisionKind::Aside ||
        d.kind == decisions::DecisionKind::Reshoot)
      kept.push_back(d);
  return kept;
}

// Decided pairs whose pose no candidate has are registered here; the others stay as they are.
Result<stages::StageNotes> decide(const Run& run, const fs::path& folder,
                                  const decisions::Decisions& decisions,
                                  const registration::Constraints& constraints, const Scans& fronts,
                                  const Scans& backs) {
  const Result<decisions::CandidateTable> table =
      decisions::readCandidates(run.work / "pairs" / "candidates.json");
  if (!table) return table.error();
  const decisions::Settled settled = decisions::settledBy(decisions, *table);
  const decisions::PairOptions options = optionsOf(run);
  Result<decisions::PairTable> pairs = decisions::assigned(*table, settled, options.assign);
  if (!pairs) return pairs.error();
  stages::StageNotes notes{{{"pairs", pairs->pairs.size()}, {"decided", settled.pairs.size()}},
                           settled.warnings};
  QuietProgress quiet;  // about a second each, after all others are compared
  for (decisions::SherdPair& pair : pairs->pairs) {
    if (pair.decided.empty() || pair.registration.start >= 0) continue;
    if (run.stop.stop_requested()) return Error::cancelled();
    const auto decision = std::find_if(decisions.begin(), decisions.end(),
                                       [&](const auto& d) { return d.id == pair.decided; });
    const scan::Scan& front = fronts.value[static_cast<std::size_t>(pair.decision.front)];
    const scan::Scan& back = backs.value[static_cast<std::size_t>(pair.decision.back)];
    const Result<registration::Registration> found =
        decisions::registerDecided(*decision, front, back, constraints, options, quiet, run.stop);
    if (!found && found.error().code == ErrorCode::Cancelled) return found.error();
    if (found) {
      pair.registration = *found;
    } else {
      pair.registration.uncertainty_mm = 1;  // nothing but a person's word holds it
      notes.warnings.push_back(
          message("%1 and %2 were paired by hand, but their relative pose is unknown; align the "
                  "back by hand in the review: %3",
                  front.id, back.id, found.error().sentence()));
    }
  }
  if (const Result<void> written = writePairs(folder, *pairs, *table); !written)
    return written.error();
  return notes;
}

}  // namespace

Result<Staged<Pairs>> pairStage(const Run& run, const Staged<Poses>& poses, double back_scale,
                                const Staged<Masks>& front_masks, const Staged<Masks>& back_masks,
                                const Scans& fronts, const Scans& backs) {
  std::array<rig::Support, 2> supports;
  if (run.batch.plate) supports = {poses.value.bends[0], poses.value.bends[1]};
  const auto withConstraints = [&](const auto& call) {
    const auto front_views = silhouettes(poses.value.of(batch::Side::Front), front_masks.value);
    const auto back_views = silhouettes(poses.value.of(batch::Side::Back), back_masks.value);
    return call(registration::Constraints{front_views, back_views, supports[0], supports[1]});
  };
  const auto compare = [&](const fs::path& folder) -> Result<stages::StageNotes> {
    const decisions::PairOptions options = optionsOf(run);
    stages::WarningsKept kept(run.progress);  // such as of a scan without an outline
    Result<decisions::CandidateTable> table =
        withConstraints([&](const registration::Constraints& constraints) {
          return decisions::compareSides(fronts.value, backs.value, constraints, options, kept,
                                         run.stop);
        });
    if (!table) return table.error();
    nameSources(run, batch::Side::Front, table->fronts, table->front_files);
    nameSources(run, batch::Side::Back, table->backs, table->back_files);
    table->back_scale = back_scale;
    table->has_scale = poses.value.has_scale;
    table->supports = supports;
    const Result<decisions::PairTable> pairs = decisions::assigned(*table, options.assign);
    if (!pairs) return pairs.error();
    if (const Result<void> w = writeJson(folder / "candidates.json", toJson(*table)); !w)
      return w.error();
    if (const Result<void> w = writePairs(folder, *pairs, *table); !w) return w.error();
    return stages::StageNotes{{{"candidates", pairs->candidates}, {"pairs", pairs->pairs.size()}},
                              kept.warnings};
  };
  ordered_json inputs = {{"poses", poses.record.outputs_hash},
                         {"front_masks", front_masks.record.outputs_hash},
                         {"back_masks", back_masks.record.outputs_hash},
                         {"fronts", fronts.record.outputs_hash},
                         {"backs", backs.record.outputs_hash},
                         {"pairing", static_cast<int>(run.options.pairing)},
                         {"registration", static_cast<int>(run.options.registration)},
                         {"photographs", run.photographs},
                         {"leaves", "candidates and supports"}};
  // No new key for what is usual: results of before stay valid.
  if (run.options.boundary != registration::Boundary::Strip)
    inputs["boundary"] = static_cast<int>(run.options.boundary);
  Result<stages::StageRecord> record = runStage(run, "pairs", inputs, compare);
  if (!record) return record.error();
  std::string folder = "pairs";
  const decisions::Decisions decisions = aboutPartners(run.decisions);
  if (!decisions.empty()) {
    folder = "decided";
    const auto work = [&](const fs::path& into) {
      return withConstraints([&](const registration::Constraints& constraints) {
        return decide(run, into, decisions, constraints, fronts, backs);
      });
    };
    const std::vector<Message> compared = record->notes.warnings;
    record = runStage(run, folder,
                      {{"pairs", record->outputs_hash}, {"decisions", toJson(decisions)}}, work);
    if (!record) return record.error();
    std::vector<Message>& told = record->notes.warnings;
    told.insert(told.begin(), compared.begin(), compared.end());
  }
  Result<Pairs> pairs = readPairs(run.work / folder / "pairs.json", fronts.value, backs.value);
  if (!pairs) return pairs.error();
  return Staged<Pairs>{std::move(*pairs), *record};
}

}  // namespace ostraka::pipeline
