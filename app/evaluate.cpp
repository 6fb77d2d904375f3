#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "cloud/ply.h"
#include "command.h"
#include "evaluate/cloud.h"
#include "evaluate/identify.h"
#include "evaluate/masks.h"
#include "evaluate/model.h"
#include "evaluate/pairs.h"
#include "evaluate/truth.h"
#include "evaluate_tables.h"
#include "options.h"

namespace ostraka::app {
namespace {

namespace fs = std::filesystem;
using namespace ostraka::evaluate;
using nlohmann::ordered_json;

struct EvaluateArguments {
  fs::path output, truth;
  std::optional<fs::path> scans;
  Align align = Align::None;
  int threads = 0;
  bool gate = false;
};

// What is printed and what machines get, gathered while the parts are measured.
struct Sheet {
  std::string text;
  ordered_json json = ordered_json::object();
  bool goals_met = true;

  void add(const char* name, std::string words, ordered_json value, bool met) {
    text += words;
    json[name] = std::move(value);
    json[name]["goals_met"] = met;
    goals_met = goals_met && met;
  }
};

// Whatever it is: what is no file is refused where it is read.
bool isThere(const fs::path& path) {
  std::error_code failed;
  return fs::exists(path, failed);
}

std::vector<fs::path> sortedEntries(const fs::path& folder) {
  std::vector<fs::path> entries;
  std::error_code failed;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, failed))
    entries.push_back(entry.path());
  std::sort(entries.begin(), entries.end());
  return entries;
}

Result<void> evaluateModels(const EvaluateArguments& arguments,
                            const std::vector<TrueSherd>& sherds, Session& session, Sheet& sheet) {
  std::vector<NamedMesh> models, truth;
  for (const fs::path& folder : sortedEntries(arguments.output / "sherds")) {
    if (!isThere(folder / "model.ply")) continue;
    Result<PlyContents> contents = readPly(folder / "model.ply");
    if (!contents) return contents.error();
    models.push_back({folder.filename().string(), std::move(contents->mesh)});
  }
  for (const TrueSherd& sherd : sherds)
    truth.push_back({sherd.id, transformed(sherd.mesh, sherd.plate_front_from_model)});
  const ModelOptions options{.align = arguments.align, .threads = arguments.threads};
  session.progress.begin("models", 0.6);
  const Result<BatchEvaluation> batch =
      evaluateBatch(models, truth, options, session.progress, session.stop);
  if (!batch) return batch.error();
  sheet.add("batch", table(*batch), toJson(*batch), batch->goals_met);
  return {};
}

Result<void> evaluateClouds(const EvaluateArguments& arguments,
                            const std::vector<TrueSherd>& sherds, Session& session, Sheet& sheet) {
  for (const char* side : {"front", "back"}) {
    const bool front = std::string(side) == "front";
    PointCloud all;
    for (const fs::path& folder : sortedEntries(arguments.output / "sherds")) {
      const fs::path file = folder / (std::string(side) + ".ply");
      if (!isThere(file)) continue;
      const Result<PointCloud> cloud = readPlyCloud(file);
      if (!cloud) return cloud.error();
      all.points.insert(all.points.end(), cloud->points.begin(), cloud->points.end());
      all.normals.insert(all.normals.end(), cloud->normals.begin(), cloud->normals.end());
    }
    if (all.empty()) continue;
    std::vector<TriangleMesh> placed;
    for (const TrueSherd& sherd : sherds)
      placed.push_back(transformed(
          sherd.mesh, front ? sherd.plate_front_from_model : sherd.plate_back_from_model));
    session.progress.begin(std::string("cloud of the ") + side, 0.1);
    const Result<CloudFigures> figures = evaluateCloud(all, placed, {.threads = arguments.threads});
    if (!figures)
      return Error{figures.error().code, figures.error().what, std::string(side) + " cloud"};
    sheet.add((std::string("cloud_") + side).c_str(), table(*figures, side), toJson(*figures),
              figures->goals_met);
    if (session.stop.stop_requested()) return Error::cancelled();
  }
  return {};
}

Result<std::vector<NamedScan>> readScans(const fs::path& folder) {
  std::vector<NamedScan> scans;
  for (const fs::path& file : sortedEntries(folder)) {
    if (file.extension() != ".ply") continue;
    Result<PointCloud> cloud = readPlyCloud(file);
    if (!cloud) return cloud.error();
    scans.push_back({file.stem().string(), std::move(*cloud)});
  }
  return scans;
}

Result<void> addPairs(const Result<PairsEvaluation>& evaluation, Sheet& sheet) {
  if (!evaluation) return evaluation.error();
  const PairsSummary summary = summarise({*evaluation});
  sheet.add("pairs", table(*evaluation) + table(summary), toJson(*evaluation, summary),
            summary.goals_met);
  return {};
}

// Scans of a processed batch are told apart by where they lie.
Result<void> evaluateProcessPairs(const EvaluateArguments& arguments,
                                  const std::vector<TrueSherd>& sherds, Session& session,
                                  Sheet& sheet) {
  const fs::path file = arguments.output / "pairs.json";
  if (!isThere(file)) return {};
  session.progress.begin("pairs", 0.1);
  const Result<Proposal> proposal = readProposal(file);
  if (!proposal) return proposal.error();
  const Result<std::vector<NamedScan>> fronts = readScans(arguments.output / "work/scans_front");
  if (!fronts) return fronts.error();
  const Result<std::vector<NamedScan>> backs = readScans(arguments.output / "work/scans_back");
  if (!backs) return backs.error();
  PairsTruth truth = truthOfScans(*fronts, *backs, sherds, arguments.threads);
  truth.set = fs::weakly_canonical(arguments.output).filename().string();
  const auto read = [&](const std::string& name) -> Result<PointCloud> {
    for (const std::vector<NamedScan>* side : {&*fronts, &*backs})
      for (const NamedScan& scan : *side)
        if (scan.name == name) return scan.cloud;
    return Error::unusable("This scan is not there.", name);
  };
  return addPairs(evaluatePairs(*proposal, truth, read), sheet);
}

Result<void> evaluateMasks(const EvaluateArguments& arguments, Session& session, Sheet& sheet) {
  MaskFigures all;
  double worst = 1;
  std::string worst_name;
  session.progress.begin("masks", 0.1);
  int count = 0;
  for (const char* side : {"front", "back"})
    for (const fs::path& file :
         sortedEntries(arguments.output / (std::string("work/masks_") + side))) {
      const std::string name = std::string(side) + "_" + file.filename().string();
      const fs::path truth_file = arguments.truth / "masks" / name;
      if (file.extension() != ".png" || !isThere(truth_file)) continue;
      const Result<MaskImage> found = readMask(file);
      if (!found) return found.error();
      const Result<MaskImage> truth = readMask(truth_file);
      if (!truth) return truth.error();
      const Result<MaskFigures> figures = evaluateMask(*found, *truth);
      if (!figures) return Error{figures.error().code, figures.error().what, file.string()};
      if (figures->intersectionOverUnion() < worst || worst_name.empty()) {
        worst = figures->intersectionOverUnion();
        worst_name = name;
      }
      all.add(*figures);
      ++count;
      if (session.stop.stop_requested()) return Error::cancelled();
    }
  if (count == 0) return {};
  constexpr double kGoal = 0.985;
  sheet.add("masks", table(all, count, worst, worst_name), toJson(all, count, worst, worst_name),
            all.intersectionOverUnion() >= kGoal);
  return {};
}

Result<void> evaluateProcess(const EvaluateArguments& arguments, Session& session, Sheet& sheet) {
  const Result<std::vector<TrueSherd>> sherds = readTrueSherds(arguments.truth);
  if (!sherds) return sherds.error();
  if (const auto r = evaluateModels(arguments, *sherds, session, sheet); !r) return r;
  if (const auto r = evaluateClouds(arguments, *sherds, session, sheet); !r) return r;
  if (const auto r = evaluateProcessPairs(arguments, *sherds, session, sheet); !r) return r;
  return evaluateMasks(arguments, session, sheet);
}

Result<void> evaluateRegister(const EvaluateArguments& arguments, Session& session, Sheet& sheet) {
  session.progress.begin("pairs", 1.0);
  const Result<Proposal> proposal = readProposal(arguments.output / "pairs.json");
  if (!proposal) return proposal.error();
  const Result<PairsTruth> truth = readPairsTruth(arguments.truth / "truth.json");
  if (!truth) return truth.error();
  const fs::path scans = arguments.scans.value_or(arguments.truth);
  const auto read = [&](const std::string& file) { return readPlyCloudWithin(scans, file); };
  return addPairs(evaluatePairs(*proposal, *truth, read), sheet);
}

Result<void> evaluateOneModel(const EvaluateArguments& arguments, Session& session, Sheet& sheet) {
  const Result<PlyContents> model = readPly(arguments.output);
  if (!model) return model.error();
  const Result<PlyContents> truth = readPly(arguments.truth);
  if (!truth) return truth.error();
  const ModelOptions options{.align = arguments.align, .threads = arguments.threads};
  session.progress.begin("model", 1.0);
  const Result<ModelFigures> figures =
      compareModel(model->mesh, truth->mesh, options, session.progress, session.stop);
  if (!figures) return figures.error();
  const bool met = figures->accuracy_mm <= 0.20 && figures->completeness_percent >= 95 &&
                   figures->mean_mm <= 0.09;
  sheet.add("model", table(*figures), toJson(*figures), met);
  return {};
}

Result<void> evaluateAny(const EvaluateArguments& arguments, Session& session, Sheet& sheet) {
  std::error_code failed;
  if (!fs::is_directory(arguments.output, failed) && !fs::is_directory(arguments.truth, failed))
    return evaluateOneModel(arguments, session, sheet);
  if (isThere(arguments.truth / "sherds.json") &&
      fs::is_directory(arguments.output / "sherds", failed))
    return evaluateProcess(arguments, session, sheet);
  if (isThere(arguments.truth / "truth.json") && isThere(arguments.output / "pairs.json"))
    return evaluateRegister(arguments, session, sheet);
  return Error::unusable(
      "There is nothing here to compare with " + arguments.truth.string() +
          "; give a folder of `process` and a truth with sherds.json, a folder of "
          "`register` and one with truth.json, or two PLY files.",
      arguments.output.string());
}

int runEvaluate(const EvaluateArguments& arguments, Session& session) {
  Sheet sheet;
  if (const Result<void> done = evaluateAny(arguments, session, sheet); !done)
    return fail(session, done.error());
  sheet.json["goals_met"] = sheet.goals_met;
  return finish(session, arguments.gate && !sheet.goals_met ? NotWhole : Whole, sheet.json,
                sheet.text + "Goals: " + (sheet.goals_met ? "all met" : "not all met"));
}

}  // namespace

void addEvaluate(CLI::App& root, Command& chosen) {
  CLI::App* command =
      root.add_subcommand("evaluate", "Measure a result against the truth, in tables");
  auto arguments = std::make_shared<EvaluateArguments>();
  command
      ->add_option("OUT", arguments->output,
                   "Folder of `process` or `register`, or one model (PLY)")
      ->required()
      ->check(CLI::ExistingPath);
  command
      ->add_option("--truth", arguments->truth,
                   "Folder with sherds.json or truth.json, or the true mesh (PLY)")
      ->required()
      ->check(CLI::ExistingPath);
  command
      ->add_option("--scans", arguments->scans,
                   "Folder of the scans named in truth.json, when not beside it")
      ->check(CLI::ExistingDirectory);
  addChoice(*command, "--align", arguments->align, {{"none", Align::None}, {"icp", Align::Icp}},
            "none", "none: poses as they are; icp: models moved onto the truth first");
  addThreads(*command, arguments->threads);
  command->add_flag("--gate", arguments->gate, "Exit status 1 when a goal is missed");
  workOf(*command, chosen, runEvaluate, arguments);
}

}  // namespace ostraka::app
