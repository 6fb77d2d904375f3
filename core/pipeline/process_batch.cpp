#include "pipeline/process_batch.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>

#include "base/memory.h"
#include "base/message.h"
#include "base/part_progress.h"
#include "base/text.h"
#include "batch/copied_photographs.h"
#include "batch/mask_source.h"
#include "batch/photographs.h"
#include "checks/camera_settings.h"
#include "checks/lone_scans.h"
#include "checks/no_scale.h"
#include "checks/scale_source.h"
#include "checks/stillness.h"
#include "cloud/ply.h"
#include "decisions/candidate_table.h"
#include "decisions/scan_folder.h"
#include "files/files.h"
#include "pairing/common_scale.h"
#include "pipeline/preflight.h"
#include "pipeline/proposed_sheet.h"
#include "pipeline/report.h"
#include "pipeline/sherd_models.h"
#include "rig/plate_print.h"
#include "stages/output_folder.h"
#include "stages/publish.h"
#include "stages/run_log.h"

namespace ostraka::pipeline {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

Run runOf(const ProcessOptions& options, const batch::Batch& batch, const FolderLock& held,
          const stages::BatchInputs& inputs, const decisions::Decisions& holding,
          Progress& progress, std::stop_token stop) {
  const ordered_json& hashes = inputs.hashes();
  return {options,
          batch,
          held,
          options.output / "work",
          inputs,
          sha256(hashes.dump()),
          {stages::photographsHash(batch, hashes, batch::Side::Front),
           stages::photographsHash(batch, hashes, batch::Side::Back)},
          holding,
          progress,
          std::move(stop)};
}

struct Sides {
  Staged<Masks> masks;
  Staged<std::vector<scan::Scan>> scans;
  std::vector<std::string> moved = {};  ///< scans
  std::vector<Message> doubtful = {};   ///< what was left out and may be a sherd: sentences
};

// By hand one camera takes a photograph at each of its places, as a turntable has stops.
std::vector<rig::PosedImage> byStops(std::vector<rig::PosedImage> images, batch::Way way) {
  if (way != batch::Way::FreeCamera) return images;
  for (std::size_t i = 0; i < images.size(); ++i)
    images[i].camera = 0, images[i].stop = static_cast<int>(i);
  return images;
}

// Whether sherds lay still while a side was photographed. Nothing mends a push: what follows goes
// on with what both halves agree on, and a person hears of it.
Result<stages::StageRecord> stillnessStage(const Run& run, batch::Side side,
                                           const Staged<Poses>& poses, const Sides& found) {
  const auto work = [&](const fs::path&) -> Result<stages::StageNotes> {
    stages::StageNotes notes;
    notes.figures["moved"] = ordered_json::array();
    const std::vector<rig::PosedImage> images = byStops(poses.value.of(side), run.batch.way);
    const std::vector<checks::MovedSherd> moved = checks::findMoved(
        images, found.masks.value, found.scans.value, {.threads = run.options.threads});
    for (const checks::MovedSherd& sherd : moved) {
      const std::string from =
          run.batch.way == batch::Way::FreeCamera
              ? fs::path(images[static_cast<std::size_t>(sherd.from_stop)].file).filename().string()
              : "";
      const Message text = checks::movedWarning(sherd, side, from);
      notes.warnings.push_back(text);
      run.progress.note(NoteLevel::Warning, text);
      notes.figures["moved"].push_back(
          {{"scan", sherd.scan}, {"from_stop", sherd.from_stop}, {"by_mm", sherd.by_mm}});
    }
    return notes;
  };
  return runStage(run, std::string("stillness_") + batch::name(side),
                  {{"poses", poses.record.outputs_hash},
                   {"masks", found.masks.record.outputs_hash},
                   {"scans", found.scans.record.outputs_hash}},
                  work);
}

bool wasPhotographed(const batch::Batch& batch, batch::Side side) {
  return std::any_of(batch.shots.begin(), batch.shots.end(),
                     [&](const batch::Shot& shot) { return shot.side == side; });
}

// Nothing of a side that was not photographed.
Result<Sides> processSide(const Run& run, batch::Side side, const Staged<Poses>& poses,
                          std::vector<ReportStage>& stages) {
  Sides found;
  if (!wasPhotographed(run.batch, side)) return found;
  const std::string name = batch::name(side);
  const auto cancelled = [&] { return run.stop.stop_requested(); };
  // Around a sheet masks take as long as stereo and more, on a plate a fifth of it.
  const bool on_plate = run.batch.plate && !run.batch.plate->sheet;
  const double masks_share = on_plate ? 0.08 : 0.25;
  run.progress.begin("masks of the " + name + " side", masks_share);
  Result<Staged<Masks>> masks = maskStage(run, side, poses);
  if (!masks) return masks.error();
  stages.push_back({"masks, " + name, masks->record});
  masks = editedMasksStage(run, side, poses, std::move(*masks));
  if (!masks) return masks.error();
  if (masks->record.notes.figures.contains("strokes")) {
    stages.push_back({"masks as edited, " + name, masks->record});
    stages.back().record.notes.warnings.clear();  // the stage before tells them
  }
  if (cancelled()) return Error::cancelled();
  run.progress.begin("stereo of the " + name + " side", 0.43 - masks_share);
  Result<Staged<PointCloud>> cloud = denseStage(run, side, poses, *masks);
  if (!cloud) return cloud.error();
  stages.push_back({"stereo, " + name, cloud->record});
  if (cancelled()) return Error::cancelled();
  run.progress.begin("scans of the " + name + " side", 0.01);
  Result<Staged<std::vector<scan::Scan>>> scans = scanStage(run, side, poses, *masks, *cloud);
  if (!scans) return scans.error();
  stages.push_back({"scans, " + name, scans->record});
  found.masks = std::move(*masks);
  found.scans = std::move(*scans);
  found.doubtful = stages::messagesAt(found.scans.record.notes.figures, "doubtful");
  if (!run.batch.plate) return found;  // nothing says where a sherd lay before
  const Result<stages::StageRecord> still = stillnessStage(run, side, poses, found);
  if (!still) return still.error();
  stages.push_back({"stillness, " + name, *still});
  for (const auto& one : still->notes.figures.at("moved"))
    found.moved.push_back(one.at("scan").get<std::string>());
  return found;
}

// Without a known length the backs are brought to the fronts' size: from here on there is one unit.
// Over one sheet of whatever size both have it already. Returns the factor.
Result<double> matchSizes(const Run& run, Staged<Poses>& poses, const Sides& front, Sides& back,
                          std::vector<ReportStage>& stages) {
  if (poses.value.has_scale || run.batch.plate) return 1.0;
  const Result<Staged<double>> scale = scaleStage(run, poses, front.scans, back.scans);
  if (!scale) return scale.error();
  stages.push_back({"sizes of the sides", scale->record});
  for (scan::Scan& scan : back.scans.value) scan = pairing::scaled(scan, scale->value);
  checks::resizeSide(poses.value.images, batch::Side::Back, scale->value);
  return scale->value;
}

std::vector<const scan::Scan*> scansNamed(const std::vector<std::string>& ids,
                                          const std::vector<scan::Scan>& scans) {
  std::vector<const scan::Scan*> named;
  for (const scan::Scan& scan : scans)
    if (std::find(ids.begin(), ids.end(), scan.id) != ids.end()) named.push_back(&scan);
  return named;
}

Result<void> publishLone(const Run& run, std::span<const scan::Scan* const> scans,
                         batch::Side side) {
  for (const scan::Scan* scan : scans) {
    const Result<void> written = writePly(run.options.output / "unpaired" / (scan->id + ".ply"),
                                          scan->cloud, std::string("plate_") + batch::name(side));
    if (!written) return written;
  }
  return {};
}

SherdSummary summaryOf(const ReportSherd& sherd, const std::vector<Message>& warnings) {
  SherdSummary line;
  line.number = sherd.number;
  line.front = sherd.front->id;
  line.back = sherd.back->id;
  line.score = sherd.pair->score;
  line.fracture_rms_mm = sherd.pair->fracture_rms_mm;
  line.uncertainty_mm = sherd.pair->uncertainty_mm;
  line.ambiguous = sherd.pair->ambiguous;
  line.decided_by = sherd.pair->decided_by;
  line.has_model = sherd.figures.value("model", false);
  if (sherd.figures.contains("munsell"))
    line.munsell = colour::parseMunsellProposals(sherd.figures["munsell"].dump());
  line.remark = sherd.pair->ambiguous ? sherd.pair->reason : "";
  if ((!line.has_model || line.remark.empty()) && !warnings.empty())
    line.remark = warnings.front().english();
  return line;
}

// The model of each pair, in their order, its texture, its part of the report and its line of the
// summary. Models come first: the light is over all of them.
Result<void> makeModels(const Run& run, const Staged<Poses>& poses,
                        const std::vector<DecidedPair>& decided, const Sides& front,
                        const Sides& back, double share, ReportInput& report,
                        ProcessSummary& summary) {
  run.progress.begin("models", share);
  const std::string scans = front.scans.record.outputs_hash + back.scans.record.outputs_hash;
  std::string shown = poses.record.outputs_hash + front.masks.record.outputs_hash +
                      back.masks.record.outputs_hash + scans;
  if (run.colours.value) shown += run.colours.record.outputs_hash;
  texture::SherdViews views = viewsOf(run, poses.value, front.masks.value, back.masks.value,
                                      decided, front.scans.value, back.scans.value);
  const bool photographed = !poses.value.images.empty();
  std::vector<ModelledSherd> modelled;
  for (std::size_t i = 0; i < decided.size(); ++i) {
    if (run.stop.stop_requested()) return Error::cancelled();
    const scan::Scan& f = front.scans.value[static_cast<std::size_t>(decided[i].front)];
    const scan::Scan& b = back.scans.value[static_cast<std::size_t>(decided[i].back)];
    const std::string number = decisions::sherdNumber(f.id);
    PartProgress progress(run.progress, i, 2 * decided.size());
    const auto record = modelStage(run.with(progress), number, decided[i], f, b, scans);
    if (!record) return record.error();
    report.stages.push_back({"model " + number, *record});
    report.sherds.push_back({number, &decided[i], &f, &b, record->notes.figures,
                             run.work / ("texture_" + number) / "preview.png"});
    modelled.push_back({number, f.id + "+" + b.id, *record, {}});
    if (photographed) modelled.back().views = [&views, &run, i] { return views.of(i, run.stop); };
    progress.report(1, 1);
  }
  Result<Staged<std::optional<texture::Light>>> light = Staged<std::optional<texture::Light>>();
  if (photographed && run.options.texture == TextureColours::Albedo) {
    std::vector<ModelledSherd> whole;
    std::copy_if(modelled.begin(), modelled.end(), std::back_inserter(whole),
                 std::mem_fn(&ModelledSherd::hasModel));
    light = lightStage(run, poses.value, whole, shown);
    if (!light) return light.error();
    report.stages.push_back({"light", light->record});
  }
  std::set<std::string> current;
  for (std::size_t i = 0; i < modelled.size(); ++i) {
    if (run.stop.stop_requested()) return Error::cancelled();
    const ModelledSherd& sherd = modelled[i];
    std::vector<Message> warnings = sherd.model.notes.warnings;
    PartProgress progress(run.progress, decided.size() + i, 2 * decided.size());
    if (sherd.hasModel()) {
      const auto record = textureStage(run.with(progress), sherd, light->value, shown);
      if (!record) return record.error();
      report.stages.push_back({"texture " + sherd.number, *record});
      report.sherds[i].figures.update(record->notes.figures);
      warnings.insert(warnings.end(), record->notes.warnings.begin(), record->notes.warnings.end());
    }
    if (const auto r = stages::publish(run.held, sherd.number, sherd.hasModel()); !r) return r;
    current.insert(sherd.number);
    summary.sherds.push_back(summaryOf(report.sherds[i], warnings));
    progress.report(1, 1);
  }
  if (!run.held.stands()) return stages::outputGone(run.options.output);
  stages::removeStaleSherds(run.options.output, current);
  return {};
}

// Expected parts of the whole job's time.
struct Shares {
  double pairs = 0.03, models = 0.05;
};

// From the scans of both sides on. reading: the warnings about the batch itself.
Result<ProcessSummary> finishChain(const Run& run, Staged<Poses>& poses, const Sides& front,
                                   Sides& back, ReportInput report, const Shares& shares,
                                   const std::vector<Message>& reading) {
  run.progress.begin("pairs", shares.pairs);
  const Result<double> back_scale = matchSizes(run, poses, front, back, report.stages);
  if (!back_scale) return back_scale.error();
  const Result<Staged<Pairs>> pairs =
      pairStage(run, poses, *back_scale, front.masks, back.masks, front.scans, back.scans);
  if (!pairs) return pairs.error();
  report.stages.push_back({"pairs", pairs->record});

  report.way = run.batch.way;
  report.batch_name = fs::weakly_canonical(run.batch.folder).filename().string();
  report.unpaired_front = pairs->value.unpaired_front;
  report.unpaired_back = pairs->value.unpaired_back;
  report.set_aside = pairs->value.set_aside;
  report.reshoot = pairs->value.reshoot;
  report.scale_doubts = stages::messagesAt(poses.record.notes.figures, "scale_doubts");
  report.draft = poses.record.notes.figures.value("draft", false);
  for (const decisions::PairDecision& d : run.decisions) report.decisions.push_back(d.id);
  report.poses = &poses.value;
  report.front_masks = &front.masks.value;
  report.back_masks = &back.masks.value;
  ProcessSummary summary;
  if (const auto r =
          makeModels(run, poses, pairs->value.pairs, front, back, shares.models, report, summary);
      !r)
    return r.error();
  if (!wasPhotographed(run.batch, batch::Side::Back)) {
    report.one_side = message(
        "Only one side was photographed: its %1 scans are open surfaces without a back; they are "
        "in 'unpaired'.",
        report.unpaired_front.size());
    run.progress.note(NoteLevel::Warning, report.one_side);
  }
  const auto lone_fronts = scansNamed(report.unpaired_front, front.scans.value);
  const auto lone_backs = scansNamed(report.unpaired_back, back.scans.value);
  if (const auto r = publishLone(run, lone_fronts, batch::Side::Front); !r) return r.error();
  if (const auto r = publishLone(run, lone_backs, batch::Side::Back); !r) return r.error();
  report.warnings = reading;
  if (!report.one_side.empty()) report.warnings.push_back(report.one_side);
  for (const ReportStage& stage : report.stages)
    report.warnings.insert(report.warnings.end(), stage.record.notes.warnings.begin(),
                           stage.record.notes.warnings.end());
  // Scans that are split already lie on no plate and touch nothing.
  if (run.batch.plate && report.one_side.empty())
    for (const auto& words : {checks::perhapsTouching(lone_fronts, lone_backs),
                              checks::perhapsTouching(lone_backs, lone_fronts)})
      for (const Message& warning : words) {
        run.progress.note(NoteLevel::Warning, warning);
        report.warnings.push_back(warning);
      }

  run.progress.begin("report", 0.02);
  if (const auto r = stages::publishReports(run.options.output, pairs->value.json,
                                            reportHtml(report), reportJson(report));
      !r)
    return r.error();
  summary.unpaired_front = report.unpaired_front;
  summary.unpaired_back = report.unpaired_back;
  summary.set_aside = report.set_aside;
  summary.reshoot = report.reshoot;
  summary.warnings = report.warnings;
  summary.moved = front.moved;
  summary.moved.insert(summary.moved.end(), back.moved.begin(), back.moved.end());
  summary.left_out = front.doubtful;
  summary.left_out.insert(summary.left_out.end(), back.doubtful.begin(), back.doubtful.end());
  summary.reprojection_rms_px = poses.record.notes.figures.value("reprojection_rms_px", 0.0);
  summary.scale_doubts = report.scale_doubts;
  summary.draft = report.draft;
  summary.report = run.options.output / "report.html";
  return summary;
}

Result<ProcessSummary> runChain(Run run, const std::vector<Message>& reading) {
  ReportInput report;
  run.progress.begin("cameras", 0.02);
  Result<Staged<Poses>> poses = poseStage(run);
  if (!poses) return poses.error();
  report.stages.push_back({"cameras", poses->record});
  report.scale = checks::scaleSource(run.batch, poses->value.has_scale);
  Result<Staged<std::optional<colour::Correction>>> colours = colourStage(run);
  if (!colours) return colours.error();
  run.colours = std::move(*colours);
  const stages::StageNotes& said = run.colours.record.notes;
  if (run.colours.value || !said.warnings.empty())  // without a chart the report is as ever
    report.stages.push_back({"colours", run.colours.record});
  const Result<Sides> front = processSide(run, batch::Side::Front, *poses, report.stages);
  if (!front) return front.error();
  Result<Sides> back = processSide(run, batch::Side::Back, *poses, report.stages);
  if (!back) return back.error();
  return finishChain(run, *poses, *front, *back, std::move(report), {}, reading);
}

// A batch whose shots are its scans, so that OUT knows whose it is.
batch::Batch batchOf(const fs::path& folder, const decisions::ScanFolder& fronts,
                     const decisions::ScanFolder& backs) {
  batch::Batch batch;
  batch.folder = fs::absolute(folder).lexically_normal();
  const auto add = [&](batch::Side side, const decisions::ScanFolder& scans) {
    for (std::size_t i = 0; i < scans.files.size(); ++i)
      batch.shots.push_back({side,
                             0,
                             static_cast<int>(i),
                             fs::absolute(scans.files[i]).lexically_normal(),
                             {},
                             0,
                             0});
  };
  add(batch::Side::Front, fronts);
  add(batch::Side::Back, backs);
  if (decisions::standOnPlate(fronts.scans) && decisions::standOnPlate(backs.scans))
    batch.plate = batch::Plate{};
  return batch;
}

Result<Sides> importedSide(const Run& run, batch::Side side, const decisions::ScanFolder& folder,
                           std::vector<ReportStage>& stages) {
  const std::string name = batch::name(side);
  run.progress.begin("scans of the " + name + " side", 0.02);
  Result<Staged<std::vector<scan::Scan>>> scans = importStage(run, side, folder);
  if (!scans) return scans.error();
  stages.push_back({"scans, " + name, scans->record});
  return Sides{{}, std::move(*scans)};
}

// That OUT was deleted under the run explains whatever else went wrong.
Result<ProcessSummary> unlessGone(const Run& run, Result<ProcessSummary> summary) {
  if (run.held.stands()) return summary;
  stages::leaveGoneOutput(run.options.output);
  return stages::outputGone(run.options.output);
}

Result<ProcessSummary> runImported(const Run& run, const decisions::ScanFolder& fronts,
                                   const decisions::ScanFolder& backs,
                                   const std::vector<Message>& reading) {
  ReportInput report;
  report.scale = message("Scale: that of the imported scans.");
  const Result<Sides> front = importedSide(run, batch::Side::Front, fronts, report.stages);
  if (!front) return front.error();
  Result<Sides> back = importedSide(run, batch::Side::Back, backs, report.stages);
  if (!back) return back.error();
  Staged<Poses> no_photographs;
  return finishChain(run, no_photographs, *front, *back, std::move(report), {0.4, 0.5}, reading);
}

}  // namespace

Result<ProcessSummary> processBatch(const ProcessOptions& options, Progress& progress,
                                    std::stop_token stop) {
  if (const Result<void> checked = options.check(); !checked) return checked.error();
  const auto begin = std::chrono::steady_clock::now();
  stages::WarningsKept reading(progress);
  Result<batch::Batch> batch =
      batch::readPhotographs(options.batch, options.back, options.sheet, {}, reading);
  if (!batch) return batch.error();
  if (Result<void> enough = batch::leaveOutCopies(*batch, {}, reading); !enough)
    return enough.error();
  if (Result<void> sheet = proposeMissingSheet(*batch, options, reading, stop); !sheet)
    return sheet.error();
  for (const Message& warning : options.warnings) reading.note(NoteLevel::Warning, warning);
  for (const Message& warning : checks::settingsWarnings(*batch, options.threads))
    reading.note(NoteLevel::Warning, warning);
  const Result<Preflight> ahead = preflight(*batch, options, freeMemoryMb());
  if (!ahead) return ahead.error();
  const Result<decisions::Decisions> decisions = decisions::readDecisions(options.output);
  if (!decisions) return decisions.error();
  const decisions::Decisions holding = decisions::standing(*decisions);
  const Result<batch::MaskSource> masks = batch::maskSource(options.masks, *batch);
  if (!masks) return masks.error();
  const stages::BatchInputs inputs(
      *batch, options.threads,
      *masks == batch::MaskSource::Network ? fs::path(options.masks) : fs::path());
  const Result<FolderLock> held = stages::claimOutput(options.output, *batch, inputs.hashes());
  if (!held) return held.error();
  stages::withdrawResults(options.output);
  if (isProposed(*batch) && !hasGuessedSize(*batch, options))
    if (const Result<void> written = rig::writePlate(options.output / "plate.json", *batch->plate);
        !written)
      return written.error();
  stages::LoggedProgress logged(progress, options.output / "log.txt", reading.warnings);
  for (const Message& line : ahead->lines) logged.note(NoteLevel::Info, line);
  for (const Message& warning : ahead->warnings) logged.note(NoteLevel::Warning, warning);
  const Run run = runOf(options, *batch, *held, inputs, holding, logged, stop);
  Result<ProcessSummary> summary = unlessGone(run, runChain(run, reading.warnings));
  if (summary)
    summary->seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return summary;
}

Result<ProcessSummary> processScans(const ProcessOptions& options, Progress& progress,
                                    std::stop_token stop) {
  if (const Result<void> checked = options.check(); !checked) return checked.error();
  const auto begin = std::chrono::steady_clock::now();
  const Result<decisions::ScanFolder> fronts =
      decisions::readScanFolder(options.batch / "front", options.threads);
  if (!fronts) return fronts.error();
  const Result<decisions::ScanFolder> backs =
      decisions::readScanFolder(options.batch / "back", options.threads);
  if (!backs) return backs.error();
  if (const Result<void> unit = decisions::checkUnit(*fronts, *backs, message("export them in mm"));
      !unit)
    return unit.error();
  const batch::Batch batch = batchOf(options.batch, *fronts, *backs);
  const Result<decisions::Decisions> decisions = decisions::readDecisions(options.output);
  if (!decisions) return decisions.error();
  const decisions::Decisions holding = decisions::standing(*decisions);
  const stages::BatchInputs inputs(batch, options.threads);
  const Result<FolderLock> held = stages::claimOutput(options.output, batch, inputs.hashes());
  if (!held) return held.error();
  stages::withdrawResults(options.output);
  std::vector<Message> reading = options.warnings;
  reading.insert(reading.end(), fronts->warnings.begin(), fronts->warnings.end());
  reading.insert(reading.end(), backs->warnings.begin(), backs->warnings.end());
  stages::LoggedProgress logged(progress, options.output / "log.txt", {});
  for (const Message& warning : reading) logged.note(NoteLevel::Warning, warning);
  const Run run = runOf(options, batch, *held, inputs, holding, logged, stop);
  Result<ProcessSummary> summary = unlessGone(run, runImported(run, *fronts, *backs, reading));
  if (summary)
    summary->seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return summary;
}

}  // namespace ostraka::pipeline
